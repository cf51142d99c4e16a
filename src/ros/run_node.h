// The life of the node as a process.
#pragma once

namespace ice_ice_baby {

/// Waits for the master, serves until SIGINT, SIGTERM or a shutdown by the master.
/// @returns 0, or 1 where a parameter or the scene was refused, or where another node took the name
/// of this one, with the reason on the log
int runNode(int argc, char** argv);

}  // namespace ice_ice_baby
