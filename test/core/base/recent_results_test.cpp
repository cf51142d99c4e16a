// What scenes that follow each other share, and for how long.
#include "base/recent_results.h"

#include <gtest/gtest.h>

#include "colliders/colliders.h"
#include "fixtures.h"
#include "fluid/surface_density.h"
#include "meshes/solids_of_revolution.h"

namespace ice_ice_baby {
namespace recent_results_test {

struct Number {
  int value;
  std::size_t bytes() const { return 100; }
};

TEST(RecentResultsTest, TheOldestAreDroppedFirst) {
  RecentResults<Number> kept(250);
  int made = 0;
  const auto get = [&](int value) {
    return kept.find([&](const Number& one) { return one.value == value; },
                     [&] {
                       ++made;
                       return std::make_shared<const Number>(Number{value});
                     });
  };
  for (const int value : {1, 2, 1, 2}) EXPECT_EQ(get(value)->value, value);
  EXPECT_EQ(made, 2);
  const auto third = get(3), first = get(1);
  EXPECT_EQ(made, 4) << "the first was dropped for the third";
  EXPECT_EQ(get(3), third);
  EXPECT_EQ(get(1), first);
  EXPECT_EQ(made, 4);
}

TEST(RecentResultsTest, WhatIsTooLargeIsMadeAndNotKept) {
  RecentResults<Number> kept(50);
  int made = 0;
  for (int k = 0; k < 2; ++k) {
    const auto one = kept.find([](const Number&) { return true; },
                               [&] {
                                 ++made;
                                 return std::make_shared<const Number>(Number{7});
                               });
    EXPECT_EQ(one->value, 7);
  }
  EXPECT_EQ(made, 2);
}

Scene cupOf(double depth_m) {
  Scene scene;
  scene.cups.emplace_back();
  scene.cups[0].depth_m = depth_m;
  return scene;
}

TEST(RecentResultsTest, ScenesWithTheSameCupShareItsTables) {
  const Colliders<float> first(cupOf(0.1), 0.01), again(cupOf(0.1), 0.01);
  const Colliders<double> in_double(cupOf(0.1), 0.01);
  const Surface* surface = first[0].shape.triangleSurface();
  EXPECT_EQ(again[0].shape.triangleSurface(), surface);
  EXPECT_EQ(in_double[0].shape.triangleSurface(), surface);
  EXPECT_NE(Colliders<float>(cupOf(0.1), 0.011)[0].shape.triangleSurface(), surface);
  EXPECT_NE(Colliders<float>(cupOf(0.11), 0.01)[0].shape.triangleSurface(), surface);

  const WallKernel kernel([](double s) { return s < 0.03 ? 0.5 * (1 - s / 0.03) : 0.0; }, 0.03);
  const WallKernel other([](double s) { return s < 0.03 ? 0.4 * (1 - s / 0.03) : 0.0; }, 0.03);
  const auto density = SurfaceDensity<float>::shared(*surface, kernel, 0.02);
  EXPECT_EQ(SurfaceDensity<float>::shared(*surface, kernel, 0.02), density);
  EXPECT_NE(SurfaceDensity<float>::shared(*surface, other, 0.02), density);
}

}  // namespace recent_results_test
}  // namespace ice_ice_baby
