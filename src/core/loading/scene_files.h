// Where scene files lie and how they are read: by path, or by a name that never leaves the folder.
#pragma once

#include <string>

namespace ice_ice_baby {

/// Whether a scene is meant by the path of its file, as it ends in .yaml or names a folder.
bool isScenePath(const std::string& name_or_path);

/// File of a scene of sceneFolder().
/// @throws InvalidInput for an unknown name, and for a link that leads out of the folder
std::string sceneFile(const std::string& name);

/// Whether a file lies in a folder or below it, after following links.
bool liesWithin(const std::string& file, const std::string& folder);

/// Whole text of a scene file. Reads no device, pipe or folder and no more than 1 MiB.
/// @throws InvalidInput naming the path and what it is
std::string readSceneFile(const std::string& path);

}  // namespace ice_ice_baby
