// The node as a process, from start to shutdown.
#pragma once

namespace ice_ice_baby {

/// Waits for the master, serves until SIGINT, SIGTERM or a shutdown by the master.
/// @returns 0, or 1 if a parameter or the scene was refused or another node took the name of this
/// one; the reason is logged
int runNode(int argc, char** argv);

}  // namespace ice_ice_baby
