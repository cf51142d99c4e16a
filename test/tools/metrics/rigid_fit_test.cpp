#include "metrics/rigid_fit.h"

#include <gtest/gtest.h>

#include <numeric>

namespace ice_ice_baby {
namespace {

std::vector<Vec3d> brick() {
  std::vector<Vec3d> points;
  for (int k = 0; k < 60; ++k) points.emplace_back(k % 3, k / 3 % 4, k / 12);
  return points;
}

std::vector<std::size_t> all(const std::vector<Vec3d>& points) {
  std::vector<std::size_t> members(points.size());
  std::iota(members.begin(), members.end(), std::size_t(0));
  return members;
}

TEST(RigidFit, SeesNothingInARigidMotion) {
  const std::vector<Vec3d> before = brick();
  const Eigen::AngleAxisd turn(2.5, Vec3d(1, -2, 0.5).normalized());
  std::vector<Vec3d> after;
  for (const Vec3d& x : before) after.push_back(turn * x + Vec3d(3, -7, 0.2));
  EXPECT_LT(squaredRigidMisfit_m2(before, after, all(before)), 1e-24);
}

TEST(RigidFit, SeesStretching) {
  const std::vector<Vec3d> before = brick();
  std::vector<Vec3d> after;
  double expected = 0.0;
  for (const Vec3d& x : before) {
    after.push_back(Vec3d(x.x(), x.y(), 1.1 * x.z()));
    expected += std::pow(0.1 * (x.z() - 2.0), 2);
  }
  EXPECT_NEAR(squaredRigidMisfit_m2(before, after, all(before)), expected, 1e-12);
}

TEST(RigidFit, DoesNotTakeAMirrorImageForAMotion) {
  const std::vector<Vec3d> before = brick();
  std::vector<Vec3d> after;
  for (const Vec3d& x : before) after.push_back(Vec3d(-x.x(), x.y(), x.z()));
  EXPECT_GT(squaredRigidMisfit_m2(before, after, all(before)), 1.0);
}

TEST(RigidFit, FewPointsHaveAFitToo) {
  const std::vector<Vec3d> before{{0, 0, 0}, {1, 0, 0}}, after{{5, 5, 5}, {5, 6, 5}};
  EXPECT_LT(squaredRigidMisfit_m2(before, after, {0, 1}), 1e-24);
  EXPECT_LT(squaredRigidMisfit_m2(before, after, {0}), 1e-24);
  EXPECT_EQ(squaredRigidMisfit_m2(before, after, {}), 0.0);
}

TEST(ConnectedGroups, AreWhatChainsOfPairsJoin) {
  const auto groups = connectedGroups(6, {{2, 0}, {3, 2}, {1, 4}});
  ASSERT_EQ(groups.size(), 3u);
  EXPECT_EQ(groups[0], (std::vector<std::size_t>{0, 2, 3}));
  EXPECT_EQ(groups[1], (std::vector<std::size_t>{1, 4}));
  EXPECT_EQ(groups[2], (std::vector<std::size_t>{5}));
  EXPECT_TRUE(connectedGroups(0, {}).empty());
}

}  // namespace
}  // namespace ice_ice_baby
