// Blocks with `carve` leave out the particles that would lie in a collider or touch it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fixtures.h"
#include "ice_ice_baby/checkpoint.h"
#include "ice_ice_baby/scene_loader.h"
#include "metrics/escape_meter.h"
#include "simulation/simulator.h"
#include "spawn/spawn_points.h"

namespace ice_ice_baby {
namespace carve_test {

using test::ball;
using test::blockOf;
using test::Random;

constexpr double kSpacing_m = 0.05;

/// A cube of 20 x 20 x 20 lattice points, carved.
Scene carvedCube() {
  Scene scene;
  scene.fluid.spacing_m = kSpacing_m;
  scene.gravity_m_s2.setZero();
  scene.blocks.push_back(blockOf(Vec3d::Constant(-0.5), Vec3d::Constant(0.5)));
  scene.blocks[0].carve = true;
  return scene;
}

std::vector<Vec3d> pointsOf(const Scene& scene) {
  std::vector<Vec3d> points;
  const SpawnPoints spawn(scene);
  for (std::size_t k = 0; k < scene.blocks.size(); ++k) {
    spawn.forEach(k, [&](const Vec3d& x) { points.push_back(x); });
  }
  return points;
}

std::string refusal(const Scene& scene) {
  return test::refusalOf([&] { validate(scene); });
}

TEST(CarveTest, NoneRemainsInASphereOrTouchesItAndTheNumberIsThatOfTheVolume) {
  Scene scene = carvedCube();
  const double radius_m = 0.31, free_m = radius_m + kSpacing_m / 2;
  const Vec3d centre(0.02, -0.03, 0.01);
  scene.spheres.push_back(ball(centre, radius_m));
  ASSERT_EQ(refusal(scene), "");
  const std::vector<Vec3d> points = pointsOf(scene);
  for (const Vec3d& x : points) ASSERT_GE((x - centre).norm(), free_m - 1e-6);
  const double carved = 4.0 / 3.0 * M_PI * std::pow(free_m / kSpacing_m, 3);
  const double layer = 4 * M_PI * std::pow(free_m / kSpacing_m, 2);
  EXPECT_NEAR(double(points.size()), 8000 - carved, layer / 2);
  EXPECT_EQ(particleCount(scene), std::int64_t(points.size()));
  EXPECT_EQ(makeSimulation(scene)->report().particles, points.size());
}

TEST(CarveTest, OfABlockAtTheWallOfAContainerThePartsInsideAndOutsideRemain) {
  Scene scene = carvedCube();
  scene.containers.push_back(test::tankOf({1, 1, 1}, true));
  scene.containers[0].position_m = {0.525, 0, -0.5};
  scene.containers[0].wall_m = 0.1;  // between x = -0.075 and 0.025
  scene.blocks[0].min_m.y() = -0.4;
  scene.blocks[0].max_m.y() = 0.4;
  ASSERT_EQ(refusal(scene), "");
  std::size_t inside = 0, outside = 0;
  for (const Vec3d& x : pointsOf(scene)) {
    if (x.x() > 0) ++inside;
    if (x.x() < 0) ++outside;
    EXPECT_TRUE(x.x() <= -0.1 + 1e-6 || x.x() >= 0.05 - 1e-6) << x.transpose();
  }
  EXPECT_EQ(inside, std::size_t(9 * 16 * 20)) << "the first layer beyond the wall touches it";
  EXPECT_EQ(outside, std::size_t(8 * 16 * 20));
}

TEST(CarveTest, OfABlockAroundAClosedContainerNoParticleCountsAsEscaped) {
  Scene scene = carvedCube();
  scene.containers.push_back(test::tankOf({0.5, 0.5, 0.5}, false));
  ASSERT_EQ(refusal(scene), "");
  const auto simulation = makeSimulation(scene, Precision::kFloat, 1);
  EXPECT_EQ(countEscaped(*simulation), 0U);
  simulation->placeColliders({{"tank", poseOf({0, 0, 3}, Vec3d::Zero())}});
  EXPECT_EQ(countEscaped(*simulation), 0U) << "its contents went along";
}

TEST(CarveTest, RandomSolidsOfEveryShapePushNothingAtTheStart) {
  Random random(74);
  for (int k = 0; k < 40; ++k) {
    Scene scene = carvedCube();
    scene.thermal.enabled = k % 4 == 0;
    if (k % 4 == 0) scene.blocks[0].celsius = -5.0;
    scene.blocks[0].rpy_deg = k % 2 == 0 ? Vec3d(90 * random.direction()) : Vec3d::Zero();
    const auto place = [&](Collider& collider, const char* name) {
      collider.name = name;
      collider.position_m = random.inBox(Vec3d::Constant(-0.3), Vec3d::Constant(0.3));
      collider.rpy_deg = 180 * random.direction();
    };
    scene.containers.push_back(test::tankOf({0.4, 0.5, 0.3}, k % 3 == 0));
    place(scene.containers[0], "tank");
    scene.spheres.push_back(ball(Vec3d::Zero(), 0.15));
    place(scene.spheres[0], "ball");
    scene.planes.resize(2);
    place(scene.planes[0], "plate");
    scene.planes[0].size_x_m = scene.planes[0].size_y_m = 0.3;
    place(scene.planes[1], "ground");
    ASSERT_EQ(refusal(scene), "");
    const Simulator<double> simulator(scene, 1);
    const std::vector<Vec3d> points = pointsOf(scene);
    ASSERT_EQ(simulator.particles().size(), points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vec3d x = simulator.particles().position.at(i);
      ASSERT_LT((x - points[simulator.particles().id[i]]).norm(), 2e-6);
    }
  }
}

TEST(CarveTest, WithoutItABlockInAColliderIsRefusedAndTheMessageNamesIt) {
  Scene scene = carvedCube();
  scene.spheres.push_back(ball({0, 0, 0}, 0.1));
  scene.blocks[0].carve = false;
  EXPECT_NE(refusal(scene).find("or set blocks.0.carve to true"), std::string::npos);
}

TEST(CarveTest, ABlockOfWhichNothingRemainsIsRefused) {
  Scene scene = carvedCube();
  scene.spheres.push_back(ball({0, 0, 0}, 2.0));
  EXPECT_EQ(refusal(scene),
            "blocks.0: carve leaves no particle, because all of them lie in colliders or touch "
            "them; change blocks.0.min_m or max_m, or move the colliders");
}

TEST(CarveTest, OnlyWhatRemainsCountsForTheLimitAndForOverlaps) {
  Scene scene = carvedCube();
  scene.spheres.push_back(ball({0, 0, 0}, 0.4));
  const auto count = double(particleCount(scene));
  scene.limits.max_particles = count;
  EXPECT_EQ(refusal(scene), "");
  scene.limits.max_particles = count - 1;
  EXPECT_NE(refusal(scene).find("particles, more than limits.max_particles"), std::string::npos);

  scene = carvedCube();
  scene.planes.emplace_back().name = "ground";
  scene.blocks.push_back(scene.blocks[0]);
  scene.blocks[0].rpy_deg.x() = 180;
  scene.blocks[0].max_m.z() = 0.0;
  EXPECT_NE(refusal(scene).find("carve leaves no particle"), std::string::npos);
  scene.blocks[0].max_m.z() = 0.1;
  EXPECT_NE(refusal(scene).find("blocks.1 overlaps blocks.0"), std::string::npos);
  scene.blocks[0].min_m.x() = scene.blocks[0].max_m.x() + 0.0;
  scene.blocks[0].max_m.x() += 0.5;
  EXPECT_EQ(refusal(scene), "") << "side by side";
}

TEST(CarveTest, ACheckpointOfACarvedSceneGoesOn) {
  const Scene scene = parseScene(R"(
    fluid: {spacing_m: 0.05}
    blocks: [{min_m: [-0.3, -0.3, -0.1], max_m: [0.3, 0.3, 0.3], carve: true}]
    spheres: [{radius_m: 0.12}]
    planes: [{}])");
  const auto one = makeSimulation(scene, Precision::kFloat, 1);
  EXPECT_EQ(std::int64_t(one->report().particles), particleCount(scene));
  one->advanceFrame();
  const auto two = decodeCheckpoint(encodeCheckpoint(*one), "memory", 2);
  one->advanceFrame();
  two->advanceFrame();
  EXPECT_EQ(two->stateHash(), one->stateHash());
}

}  // namespace carve_test
}  // namespace ice_ice_baby
