// Which parts of a scene have a marker in rviz, and where and how large it is.
#include "handle_markers.h"

#include <gtest/gtest.h>

#include "ice_ice_baby/scene_loader.h"

namespace ice_ice_baby {
namespace {

constexpr char kScene[] = R"(
thermal: {enabled: true}
planes: [{name: ground, position_m: [0, 0, -1]}, {name: plate, size_x_m: 2, size_y_m: 1, thickness_m: 0.1}]
spheres: [{name: ball, radius_m: 0.3, position_m: [3, 0, 0]}, {name: held, follow_frame: hand, position_m: [9, 9, 9]}]
sources:
  - {name: tap, position_m: [5, 0, 0], radius_m: 0.1, speed_m_s: 1, direction: [1, 0, 0]}
  - {name: hose, speed_m_s: 1, follow_frame: hand}
heat_regions:
  - {name: spray, power_w: -1, size_m: [0.1, 0.5, 0.2], shape: box}
)";

TEST(HandleMarkers, EveryPartThatFollowsNoFrameAndIsNotInfiniteHasOne) {
  const std::vector<Handle> handles = everyHandle(parseScene(kScene), "the_scene");
  std::vector<std::string> names;
  for (const Handle& handle : handles) names.push_back(handle.marker.name);
  EXPECT_EQ(names, (std::vector<std::string>{"collider plate", "collider ball", "source tap",
                                             "heat region spray"}));
  for (const Handle& handle : handles) {
    EXPECT_EQ(handle.marker.header.frame_id, "the_scene");
    EXPECT_GE(handle.marker.controls.size(), 6U) << "three arrows and three rings";
    EXPECT_EQ(handle.marker.pose.position.x, handle.what.pose.position.x());
  }
}

TEST(HandleMarkers, TheyAreAsLargeAsThePartAndPointAlongTheAxes) {
  const std::vector<Handle> handles = everyHandle(parseScene(kScene), "the_scene");
  EXPECT_NEAR(handles[1].marker.scale, 1.2 * 0.6, 1e-6);
  EXPECT_NEAR(handles[2].marker.scale, 1.2 * 0.6, 1e-6);
  EXPECT_NEAR(handles[3].marker.scale, 1.2 * 0.5, 1e-6);
  EXPECT_GT(handles[0].marker.scale, 2.0);
  for (int axis = 0; axis < 3; ++axis) {
    const auto& q = handles[0].marker.controls[std::size_t(2 * axis)].orientation;
    const Vec3d along = Eigen::Quaterniond(q.w, q.x, q.y, q.z) * Vec3d::UnitX();
    EXPECT_LT((along - Vec3d::Unit(axis)).norm(), 1e-12);
  }
  EXPECT_EQ(handles[3].marker.controls.back().markers[0].type, visualization_msgs::Marker::CUBE);
}

}  // namespace
}  // namespace ice_ice_baby
