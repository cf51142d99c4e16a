// Where the view stands: every corner of the box is in the picture, and no farther away than
// needed.
#include "framing.h"

#include <gtest/gtest.h>

#include <cmath>

#include "beside.h"

namespace ice_ice_baby {
namespace {

/// Largest share of half the picture, in width or height, that a corner of the box reaches.
double reach(const Eigen::AlignedBox3d& box, const Orbit& orbit, double distance) {
  const Eigen::AngleAxisd yaw(orbit.yaw, Eigen::Vector3d::UnitZ());
  const Eigen::AngleAxisd pitch(-orbit.pitch, Eigen::Vector3d::UnitY());
  const Eigen::Matrix3d axes = (yaw * pitch).toRotationMatrix();  // to the eye, right, up
  const double high = std::tan(orbit.view_angle / 2);
  double most = 0.0;
  for (int k = 0; k < 8; ++k) {
    const Eigen::Vector3d way =
        axes.transpose() * (box.corner(Eigen::AlignedBox3d::CornerType(k)) - box.center());
    const double depth = distance - way.x();
    EXPECT_GT(depth, 0.0);
    most = std::max({most, std::abs(way.y()) / (depth * high * orbit.aspect),
                     std::abs(way.z()) / (depth * high)});
  }
  return most;
}

TEST(Framing, ShowsAllOfABoxAndLittleElse) {
  const Eigen::Vector3d sizes[] = {{1, 1, 1}, {10, 1, 0.1}, {0.1, 0.1, 3}, {0.02, 0.01, 0.03}};
  for (const Eigen::Vector3d& size : sizes) {
    for (const double yaw : {0.0, 0.8, 2.5, 5.25}) {
      for (const double pitch : {-0.5, 0.0, 0.32, 1.5}) {
        for (const double aspect : {0.6, 1.0, 2.5}) {
          const Eigen::Vector3d low(3, -2, 5);
          const Eigen::AlignedBox3d box(low, low + size);
          const Orbit orbit{yaw, pitch, 0.785, aspect};
          const double filled = reach(box, orbit, framingDistance(box, orbit));
          EXPECT_LE(filled, 0.95);
          EXPECT_GE(filled, 0.90);
        }
      }
    }
  }
}

TEST(TopicBeside, IsOfTheSameNode) {
  EXPECT_EQ(topicBeside("/left/ice_ice_baby/surface", "state"), "/left/ice_ice_baby/state");
  EXPECT_EQ(topicBeside("surface", "state"), "state");
}

}  // namespace
}  // namespace ice_ice_baby
