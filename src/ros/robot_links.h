// Colliders with the collision geometry of a robot, which follow its tf frames.
#pragma once

#include <string>
#include <vector>

#include "ice_ice_baby/scene.h"

namespace ice_ice_baby {

/// Names of links separated by commas or spaces; `*` stands for any characters.
std::vector<std::string> linkPatterns(const std::string& links);

/// Adds a collider for each collision geometry of the links whose names match, with the name of the
/// link, and the same again with _2, _3 and so on for further geometries of one link.
/// @param description URDF, the text of the parameter robot_description
/// @throws InvalidInput for a description that is no URDF, a pattern that matches no link, a link
///   without collision geometry, and if this program was built without liburdf-dev
void addRobotLinks(Scene& scene, const std::string& description,
                   const std::vector<std::string>& patterns);

}  // namespace ice_ice_baby
