// Where an eye has to stand to see all of a box.
#pragma once

#include <Eigen/Geometry>

namespace ice_ice_baby {

/// How an orbiting eye looks at a point: angles as rviz has them, in radians.
struct Orbit {
  double yaw = 0.0;           ///< of the eye about z, as seen from the point
  double pitch = 0.0;         ///< of the eye above the point
  double view_angle = 0.785;  ///< of the whole height of the picture
  double aspect = 1.6;        ///< width of the picture over its height
};

/// Distance from the centre of `box` at which all of it is in view, with a margin; m.
double framingDistance(const Eigen::AlignedBox3d& box, const Orbit& orbit);

}  // namespace ice_ice_baby
