// Scenes with floating solids: what is refused, what spawns, checkpoints, threads, and what they
// cost.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "fixtures.h"
#include "ice_ice_baby/checkpoint.h"
#include "ice_ice_baby/scene_loader.h"
#include "simulation/simulator.h"
#include "spawn/spawn_points.h"

namespace ice_ice_baby {
namespace solid_scenes_test {

using test::blockOf;
using test::refusalOf;
using test::tankOf;

constexpr double kSpacing_m = 0.05;

Solid cubeAt(const Vec3d& position_m, const std::string& name = "cube") {
  Solid solid;
  solid.name = name;
  solid.size_m = Vec3d::Constant(0.2);
  solid.position_m = position_m;
  return solid;
}

/// Water in a tank and a cube that falls into it.
Scene cubeAbovePool() {
  Scene scene;
  scene.fluid.spacing_m = kSpacing_m;
  scene.containers.push_back(tankOf({0.6, 0.6, 1.0}, true));
  scene.blocks.push_back(blockOf({-0.3, -0.3, 0.0}, {0.3, 0.3, 0.3}));
  scene.solids.push_back(cubeAt({0.02, 0.01, 0.45}));
  return scene;
}

std::string refusal(const Scene& scene) {
  return refusalOf([&] { validate(scene); });
}

struct Refused {
  const char* what;
  std::function<void(Scene&)> change;
  std::vector<std::string> words;
};

TEST(SolidScenes, AreRefusedWithTheThingTheValueAndTheCure) {
  const std::vector<Refused> all = {
      {"light",
       [](Scene& s) { s.solids[0].density_kg_m3 = 50; },
       {"solids.0 (cube)", "density_kg_m3 = 50", "[100, 20000]"}},
      {"heavy",
       [](Scene& s) { s.solids[0].mass_kg = 200; },
       {"solids.0 (cube)", "mass_kg = 200", "25000"}},
      {"thin",
       [](Scene& s) { s.solids[0].size_m.x() = 0.04; },
       {"size_m = 0.04", "fluid.spacing_m = 0.05", "0.05"}},
      {"small ball",
       [](Scene& s) {
         s.solids[0].shape = SolidShape::kSphere;
         s.solids[0].radius_m = 0.03;
       },
       {"radius_m = 0.03", "at least 0.05"}},
      {"narrow cup",
       [](Scene& s) {
         s.solids[0].shape = SolidShape::kCup;
         s.solids[0].radius_m = 0.06;
       },
       {"radius_m = 0.06", "at least 0.1"}},
      {"name of a collider",
       [](Scene& s) { s.solids[0].name = "tank"; },
       {"solids.0.name = tank", "collider"}},
      {"same name",
       [](Scene& s) {
         s.solids.push_back(cubeAt({0, 0, 0.8}));
       },
       {"solids.1.name = cube"}},
      {"in water",
       [](Scene& s) { s.solids[0].position_m.z() = 0.3; },
       {"solids.0 (cube)", "blocks.0", "carve"}},
      {"in a wall",
       [](Scene& s) { s.solids[0].position_m.x() = 0.3; },
       {"solids.0 (cube)", "container tank", "containers.0.position_m"}},
      {"in each other",
       [](Scene& s) {
         s.solids.push_back(cubeAt({0.1, 0, 0.5}, "other"));
       },
       {"solids.1 (other)", "solids.0 (cube)", "position_m"}},
      {"beyond the bounds",
       [](Scene& s) { s.solids[0].position_m.z() = 60; },
       {"solids.0 (cube)", "bounds", "60"}},
      {"too fast",
       [](Scene& s) { s.solids[0].velocity_m_s.x() = 100; },
       {"solids.0 (cube)", "solver.max_speed_m_s", "100"}},
      {"too many particles",
       [](Scene& s) { s.limits.max_particles = 500; },
       {"blocks and solids", "limits.max_particles = 500"}},
  };
  ASSERT_EQ(refusal(cubeAbovePool()), "");
  for (const Refused& one : all) {
    Scene scene = cubeAbovePool();
    one.change(scene);
    const std::string text = refusal(scene);
    for (const std::string& word : one.words) {
      EXPECT_NE(text.find(word), std::string::npos) << one.what << ": " << word << " in " << text;
    }
  }
}

TEST(SolidScenes, CarvedWaterLeavesRoomForASolid) {
  Scene scene = cubeAbovePool();
  scene.solids[0].position_m = {0.0, 0.0, 0.15};
  scene.blocks[0].carve = true;
  ASSERT_EQ(refusal(scene), "");
  // The cube takes the place of 4 x 4 x 4 particles of water on the same lattice.
  EXPECT_EQ(particleCount(scene), 12 * 12 * 6);
  EXPECT_EQ(makeSimulation(scene)->report().particles, std::size_t(12 * 12 * 6));
}

TEST(SolidScenes, AreReadFromYamlAndNamed) {
  const Scene scene = parseScene(
      "{fluid: {spacing_m: 0.05}, solids: [{shape: cup, radius_m: 0.2, height_m: 0.3, mass_kg: 9}, "
      "{position_m: [1, 0, 0]}]}");
  ASSERT_EQ(scene.solids.size(), 2u);
  EXPECT_EQ(scene.solids[0].name, "solid_0");
  EXPECT_EQ(scene.solids[0].shape, SolidShape::kCup);
  EXPECT_EQ(scene.solids[1].shape, SolidShape::kBox);
}

TEST(SolidScenes, ContinueFromACheckpointWithTheSameBitsForAnyNumberOfThreads) {
  for (const Precision precision : {Precision::kFloat, Precision::kDouble}) {
    const auto one = makeSimulation(cubeAbovePool(), precision, 1);
    const auto three = makeSimulation(cubeAbovePool(), precision, 3);
    for (int k = 0; k < 20; ++k) {
      one->advanceFrame();
      three->advanceFrame();
      if (k == 10) one->holdSolid("cube", {Vec3d(0.05, 0.0, 0.5), Mat3<double>::Identity()});
      if (k == 10) three->holdSolid("cube", {Vec3d(0.05, 0.0, 0.5), Mat3<double>::Identity()});
    }
    EXPECT_EQ(one->stateHash(), three->stateHash());
    const auto again = decodeCheckpoint(encodeCheckpoint(*one), "solids", 1);
    EXPECT_EQ(again->stateHash(), one->stateHash());
    for (const auto& simulation : {&one, &again}) {
      (*simulation)->releaseSolid("cube");
      for (int k = 0; k < 10; ++k) (*simulation)->advanceFrame();
    }
    EXPECT_EQ(again->stateHash(), one->stateHash());
    EXPECT_EQ(again->solids()[0].pose.position, one->solids()[0].pose.position);
  }
}

TEST(SolidScenes, AHeldSolidGoesWhereItIsToldAndKeepsItsVelocityWhenItIsLetGo) {
  Scene scene;
  scene.fluid.spacing_m = kSpacing_m;
  scene.solids.push_back(cubeAt(Vec3d::Zero()));
  const auto simulation = makeSimulation(scene);
  for (int k = 1; k <= 30; ++k) {
    const Vec3d at(0.01 * k, 0.0, 0.02 * k);
    simulation->holdSolid("cube", {at, Eigen::AngleAxisd(0.01 * k, Vec3d::UnitZ()).matrix()});
    simulation->advanceFrame();
    const SolidState state = simulation->solids()[0];
    ASSERT_NEAR((state.pose.position - at).norm(), 0.0, 1e-9) << k;
    EXPECT_TRUE(state.held);
  }
  const Vec3d velocity_m_s(0.6, 0.0, 1.2);
  EXPECT_NEAR((simulation->solids()[0].velocity_m_s - velocity_m_s).norm(), 0.0, 1e-6);
  EXPECT_NEAR(simulation->solids()[0].angular_velocity_rad_s.z(), 0.6, 1e-6);
  simulation->releaseSolid("cube");
  simulation->advanceFrame();
  const SolidState state = simulation->solids()[0];
  EXPECT_FALSE(state.held);
  EXPECT_NEAR((state.velocity_m_s - velocity_m_s - scene.gravity_m_s2 / 60).norm(), 0.0, 1e-5);
}

TEST(SolidScenes, CommandsForUnknownSolidsAndBadPosesAreRefused) {
  const auto simulation = makeSimulation(cubeAbovePool());
  const std::uint64_t before = simulation->stateHash();
  const Posed pose{Vec3d(0, 0, 0.5), Mat3<double>::Identity()};
  EXPECT_NE(refusalOf([&] { simulation->holdSolid("cup", pose); }).find("has: cube"),
            std::string::npos);
  EXPECT_NE(refusalOf([&] { simulation->releaseSolid("cup"); }), "");
  const Posed nowhere{Vec3d(0, 0, NAN), Mat3<double>::Identity()};
  EXPECT_NE(refusalOf([&] { simulation->holdSolid("cube", nowhere); }).find("nan"),
            std::string::npos);
  const Posed mirrored{Vec3d::Zero(), -Mat3<double>::Identity()};
  EXPECT_NE(refusalOf([&] { simulation->holdSolid("cube", mirrored); }), "");
  EXPECT_EQ(simulation->stateHash(), before);
}

TEST(SolidScenes, ASolidLeavesTheSceneAsAWhole) {
  Scene scene = cubeAbovePool();
  scene.bounds.min_m = Vec3d::Constant(-2);
  scene.bounds.max_m = Vec3d::Constant(2);
  scene.solids[0].position_m = {1.0, 0.0, 1.7};
  scene.solids[0].velocity_m_s = {0.0, 0.0, 9.0};
  const auto simulation = makeSimulation(scene);
  const std::size_t particles = simulation->report().particles;
  EXPECT_EQ(simulation->report().solids, 1u);
  for (int k = 0; k < 6; ++k) {
    const std::size_t left = particles - simulation->advanceFrame().particles;
    EXPECT_TRUE(left == 0 || left == 64) << left;
  }
  EXPECT_EQ(simulation->report().spilled, 64u);
  EXPECT_EQ(simulation->report().solids, 0u);
  EXPECT_TRUE(simulation->solids().empty());
  EXPECT_NE(refusalOf([&] { simulation->releaseSolid("cube"); }).find("left"), std::string::npos);
}

TEST(SolidScenes, HaveTheStagesOfRigidBodiesAndNoHeat) {
  const auto simulation = makeSimulation(cubeAbovePool());
  simulation->advanceFrame();
  std::vector<std::string> names;
  for (const StageStats& stage : simulation->stages()) names.push_back(stage.name);
  const auto has = [&](const char* name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  EXPECT_TRUE(has("ice_bodies") && has("ice_contacts"));
  EXPECT_FALSE(has("heat"));
}

/// Ice forms in the water around a solid, which stays one body of its own.
TEST(SolidScenes, WaterFreezesAroundASolidThatStaysItself) {
  Scene scene = cubeAbovePool();
  scene.thermal.enabled = true;
  scene.temperature.initial_c = -20;
  scene.blocks[0].celsius = -5;
  const auto simulation = makeSimulation(scene);
  for (int k = 0; k < 40; ++k) simulation->advanceFrame();
  EXPECT_EQ(simulation->report().solids, 1u);
  EXPECT_EQ(simulation->report().ice_bodies, 1u);
  EXPECT_GT(simulation->report().ice_particles, 500u);
  std::vector<ParticleSample> samples;
  simulation->sample(samples);
  const auto solid = std::count_if(samples.begin(), samples.end(), [](const ParticleSample& p) {
    return p.phase == Phase::kSolid;
  });
  EXPECT_EQ(solid, 64);
  EXPECT_NEAR(simulation->solids()[0].pose.position.z(), 0.4, 0.06) << "it lies on the ice";
}

/// The springs of a scene without heat join the water and leave the solid out.
TEST(SolidScenes, WaterFrozenBySpringsLeavesASolidFree) {
  Scene scene = cubeAbovePool();
  scene.temperature.initial_c = -5;
  const auto simulation = makeSimulation(scene);
  for (int k = 0; k < 40; ++k) simulation->advanceFrame();
  EXPECT_EQ(simulation->report().solids, 1u);
  EXPECT_GT(simulation->report().springs, 0u);
  EXPECT_EQ(simulation->report().non_finite, 0u);
  EXPECT_GT(simulation->solids()[0].pose.position.z(), 0.35);
}

}  // namespace solid_scenes_test
}  // namespace ice_ice_baby
