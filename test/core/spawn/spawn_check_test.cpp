// Where water may start: not in a collider, not in other water, not on both sides of a closed wall.
#include <gtest/gtest.h>

#include "fixtures.h"
#include "simulation/simulator.h"

namespace ice_ice_baby {
namespace spawn_check_test {

using test::ball;
using test::blockOf;
using test::Random;

std::string refusal(const Scene& scene) {
  return test::refusalOf([&] { validate(scene); });
}

/// Sixty-four particles in the middle of a tank.
Scene tankWithWater() {
  Scene scene;
  scene.fluid.spacing_m = 0.05;
  scene.blocks.push_back(blockOf({-0.1, -0.1, 0.2}, {0.1, 0.1, 0.4}));
  scene.containers.push_back(test::tankOf({1, 1, 1}, false));
  return scene;
}

TEST(SpawnCheckTest, WaterInAColliderIsRefusedByTheKeysOfBoth) {
  struct Case {
    std::function<void(Scene&)> change;
    const char* words;
  };
  const Case cases[] = {
      {[](Scene& s) {
         s.spheres.push_back(ball({0, 0, 0.3}, 0.5));
       },
       "blocks.0: 64 of its 64 particles lie inside sphere ball (spheres.0)"},
      {[](Scene& s) {
         s.spheres.push_back(ball({0.075, 0.075, 0.375}, 1e-3));
       },
       "blocks.0: 1 of its 64 particles lies inside sphere ball (spheres.0)"},
      {[](Scene& s) {
         s.planes.emplace_back().name = "ground";
         s.planes[0].position_m.z() = 0.3;
       },
       "blocks.0: 32 of its 64 particles lie inside plane ground (planes.0)"},
      {[](Scene& s) {
         s.blocks[0].min_m.x() += 0.43;
         s.blocks[0].max_m.x() += 0.43;
         s.containers[0].wall_m = 0.1;
       },
       "blocks.0: 16 of its 64 particles lie inside the wall of container tank (containers.0)"},
      {[](Scene& s) {
         s.blocks[0].min_m.x() += 0.43;
         s.blocks[0].max_m.x() += 0.43;
         s.containers[0].wall_m = 1e-3;
       },
       "blocks.0: 16 of its 64 particles lie outside the closed container tank (containers.0)"},
  };
  for (const Case& c : cases) {
    Scene scene = tankWithWater();
    ASSERT_EQ(refusal(scene), "");
    c.change(scene);
    EXPECT_NE(refusal(scene).find(c.words), std::string::npos) << c.words << "\n" << refusal(scene);
  }
}

TEST(SpawnCheckTest, BlocksThatOverlapAreRefusedByTheKeysOfBoth) {
  const auto with = [](const Vec3d& by, const Vec3d& rpy_deg = Vec3d::Zero()) {
    Scene scene = tankWithWater();
    Block other = scene.blocks[0];
    other.min_m += by;
    other.max_m += by;
    other.rpy_deg = rpy_deg;
    scene.blocks.push_back(other);
    return refusal(scene);
  };
  const std::string first = "blocks.1 overlaps blocks.0: ";
  EXPECT_EQ(with({0, 0, 0}).find(first + "64 of its 64 particles"), 0u) << with({0, 0, 0});
  EXPECT_EQ(with({0.15, 0, 0}).find(first + "16 of its 64 particles"), 0u) << with({0.15, 0, 0});
  EXPECT_EQ(with({0, 0, 0.175}).find(first + "16 of its 64"), 0u) << "half a spacing deep";
  EXPECT_EQ(with({0.175, 0.175, 0.175}).find(first + "1 of its 64"), 0u) << "between four";
  EXPECT_NE(with({0.1, 0, 0}, {45, 45, 0}), "");
  EXPECT_EQ(with({0.2, 0, 0}), "") << "side by side";
  EXPECT_EQ(with({0.2, 0.2, 0}), "");
  EXPECT_EQ(with({0, 0, 0.35}, {20, 30, 40}), "") << "boxes around them meet, they do not";
}

TEST(SpawnCheckTest, BlocksInDisjointBoxesNeverOverlapHoweverTheyAreTurned) {
  Random random(71);
  for (int k = 0; k < 300; ++k) {
    Scene scene;
    scene.fluid.spacing_m = 0.05;
    scene.thermal.enabled = k % 2 == 1;
    const Vec3d rpy = 180 * random.direction();
    const Posed pose = poseOf(Vec3d::Zero(), rpy);
    const Vec3d size = random.inBox(Vec3d::Constant(0.06), Vec3d::Constant(0.3));
    for (const double side : {-1.0, 1.0}) {
      const Vec3d centre = pose.toWorld({side * size.x() / 2, 0, 0});
      Block block = blockOf(centre - size / 2, centre + size / 2);
      block.rpy_deg = rpy;
      if (side > 0) block.celsius = -5;
      scene.blocks.push_back(block);
    }
    EXPECT_EQ(refusal(scene), "");
    scene.blocks[1].min_m = scene.blocks[0].min_m;
    scene.blocks[1].max_m = scene.blocks[0].max_m;
    EXPECT_NE(refusal(scene), "");
  }
}

TEST(SpawnCheckTest, AThousandCopiesInOnePlaceAreRefused) {
  Scene scene = tankWithWater();
  scene.blocks.assign(1000, scene.blocks[0]);
  EXPECT_EQ(refusal(scene).find("blocks.1 overlaps blocks.0"), 0u);
}

TEST(SpawnCheckTest, WaterBesideOrAboveAClosedTankIsAllowed) {
  Scene scene = tankWithWater();
  scene.blocks.push_back(blockOf({1, 1, 0}, {1.2, 1.2, 0.2}));
  scene.blocks.push_back(blockOf({-0.1, -0.1, 1.1}, {0.1, 0.1, 1.3}));
  EXPECT_EQ(refusal(scene), "");
}

TEST(SpawnCheckTest, WhatOverlapsSlightlyIsPushedOutBeforeTheFirstFrameAndGainsNoSpeed) {
  Scene scene = tankWithWater();
  scene.gravity_m_s2.setZero();
  scene.spheres.push_back(ball({0, 0, 0.49}, 0.1));  // 1 cm into the topmost layer of centres
  ASSERT_EQ(refusal(scene), "");
  Simulator<double> simulator(scene, 1);
  for (std::size_t i = 0; i < simulator.particles().size(); ++i) {
    EXPECT_GE((simulator.particles().position.at(i) - Vec3d(0, 0, 0.49)).norm(), 0.125 - 1e-9);
  }
  EXPECT_EQ(simulator.report().max_speed_m_s, 0.0);
  simulator.advanceFrame();
  EXPECT_LT(simulator.report().max_speed_m_s, 1.0);
}

TEST(SpawnCheckTest, RandomScenesAreRefusedOrStaySlow) {
  Random random(72);
  int refused = 0, run = 0;
  for (int k = 0; k < 90; ++k) {
    Scene scene;
    scene.fluid.spacing_m = 0.05;
    scene.gravity_m_s2.setZero();
    scene.containers.push_back(test::tankOf({1, 1, 1}, k % 2 == 0));
    for (int b = 0; b < 2; ++b) {
      const Vec3d low = random.inBox({-0.5, -0.5, 0}, {0.4, 0.4, 0.7});
      scene.blocks.push_back(blockOf(low, low + Vec3d::Constant(random.uniform(0.06, 0.25))));
      scene.blocks[b].rpy_deg = k % 3 == 0 ? Vec3d(90 * random.direction()) : Vec3d::Zero();
    }
    scene.spheres.push_back(ball(random.inBox({-0.5, -0.5, 0}, {0.5, 0.5, 1}), 0.1));
    const std::string why = refusal(scene);
    if (!why.empty()) {
      EXPECT_NE(why.find("blocks."), std::string::npos) << why;
      ++refused;
      continue;
    }
    const auto simulation = makeSimulation(scene, Precision::kFloat, 1);
    simulation->advanceFrame();
    EXPECT_LT(simulation->report().max_speed_m_s, 1.5);
    ++run;
  }
  EXPECT_GT(refused, 10);
  EXPECT_GT(run, 20);
}

}  // namespace spawn_check_test
}  // namespace ice_ice_baby
