// How high water stands in boxes and cylinders, upright and tilted, against closed forms and a
// count of points.
#include "measure/vessel_level.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "fixtures.h"

namespace ice_ice_baby {
namespace vessel_level_test {

const VesselSpace kBox{{-0.1, -0.2, 0.0}, {0.1, 0.2, 0.5}, false};
const VesselSpace kCylinder{{-0.1, -0.1, 0.0}, {0.1, 0.1, 0.3}, true};

/// Height below which a share of the space lies, of many points.
double countedLevel_m(const VesselSpace& space, const Vec3d& up, double share) {
  std::vector<double> heights_m;
  for (const Vec3d& point : test::randomPoints(400000, space.low, space.high, 7)) {
    if (space.holds(point)) heights_m.push_back(up.dot(point));
  }
  const auto rank = heights_m.begin() + std::ptrdiff_t(share * double(heights_m.size()));
  std::nth_element(heights_m.begin(), rank, heights_m.end());
  return *rank - space.lowest_m(up);
}

TEST(VesselLevelTest, UprightVesselsAreExact) {
  for (const double share : {0.0, 0.03, 0.5, 0.77, 1.0}) {
    EXPECT_NEAR(levelOf_m(kBox, Vec3d::UnitZ(), share * 0.04, {}), 0.5 * share, 1e-9);
    const double volume_m3 = share * M_PI * 0.01 * 0.3;
    EXPECT_NEAR(levelOf_m(kCylinder, Vec3d::UnitZ(), volume_m3, {}), 0.3 * share, 1e-9);
    EXPECT_NEAR(levelOf_m(kBox, -Vec3d::UnitZ(), share * 0.04, {}), 0.5 * share, 1e-9);
    EXPECT_NEAR(levelOf_m(kBox, Vec3d::UnitX(), share * 0.04, {}), 0.2 * share, 1e-9);
  }
}

TEST(VesselLevelTest, TiltedVesselsAreRightWithinAPercentOfTheirHeight) {
  test::Random random(3);
  for (const VesselSpace& space : {kBox, kCylinder}) {
    for (int k = 0; k < test::repeats(20); ++k) {
      const Vec3d up = random.direction();
      const double share = random.uniform(0.1, 0.9);
      const double height_m = -space.lowest_m(-up) - space.lowest_m(up);
      EXPECT_NEAR(levelOf_m(space, up, share * space.capacity_m3(), {}),
                  countedLevel_m(space, up, share), 0.005 * height_m)
          << up.transpose() << ", share " << share;
    }
  }
}

/// A tilted box that is half full has its surface through its middle.
TEST(VesselLevelTest, AHalfFullVesselIsFilledToItsMiddle) {
  const Vec3d up = Vec3d(std::sin(M_PI / 6), 0, std::cos(M_PI / 6));
  for (const VesselSpace& space : {kBox, kCylinder}) {
    const double middle_m = up.dot(space.centre()) - space.lowest_m(up);
    EXPECT_NEAR(levelOf_m(space, up, space.capacity_m3() / 2, {}), middle_m, 1e-6);
  }
}

TEST(VesselLevelTest, WhatTakesSpaceRaisesTheLevelAndWhatDoesNotFitStopsAtTheTop) {
  const auto half = [](const Vec3d& point) { return point.x() > 0; };
  EXPECT_NEAR(levelOf_m(kBox, Vec3d::UnitZ(), 0.01, half), 0.25, 1e-9);
  EXPECT_NEAR(levelOf_m(kBox, Vec3d::UnitZ(), 0.03, half), 0.5, 1e-9);
  EXPECT_NEAR(levelOf_m(kBox, Vec3d::UnitZ(), 1.0, {}), 0.5, 1e-9);
}

TEST(VesselLevelTest, TheLowestPointIsThatOfTheCornersOrOfTheRim) {
  const Vec3d up = Vec3d(1, 0, 1).normalized();
  EXPECT_NEAR(kBox.lowest_m(up), -0.1 / std::sqrt(2), 1e-12);
  EXPECT_NEAR(kCylinder.lowest_m(up), -0.1 / std::sqrt(2), 1e-12);
  EXPECT_NEAR(kCylinder.lowest_m(-Vec3d::UnitZ()), -0.3, 1e-12);
}

}  // namespace vessel_level_test
}  // namespace ice_ice_baby
