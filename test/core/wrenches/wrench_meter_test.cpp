// Forces and torques on colliders against known answers: Archimedes, hydrostatics, momentum.
#include <gtest/gtest.h>

#include <map>

#include "fixtures.h"
#include "simulation/simulator.h"

namespace ice_ice_baby {
namespace wrench_meter_test {

constexpr double kGravity_m_s2 = 9.81, kWater_kg_m3 = 1000;

void advance(Simulation& simulation, double time_s) {
  const double frames = time_s * simulation.scene().solver.frame_rate_hz;
  for (int frame = 0; frame < frames; ++frame) simulation.advanceFrame();
}

/// Mean wrenches over `measured_s` after `settled_s`, by the names of the colliders.
std::map<std::string, ColliderWrench> measured(Simulation& simulation, double settled_s,
                                               double measured_s) {
  advance(simulation, settled_s);
  simulation.measureWrenches(true);
  advance(simulation, measured_s);
  std::map<std::string, ColliderWrench> wrenches;
  for (const ColliderWrench& wrench : simulation.wrenches()) wrenches[wrench.name] = wrench;
  return wrenches;
}

double mass_kg(const Simulation& simulation) {
  const Scene& scene = simulation.scene();
  return double(simulation.report().particles) *
         particleMass_kg(scene.fluid, scene.supportRadius_m());
}

Scene pool(double spacing_m, const Vec3d& size_m) {
  Scene scene;
  scene.fluid.spacing_m = spacing_m;
  const Vec3d half(size_m.x() / 2, size_m.y() / 2, 0);
  scene.blocks.push_back(test::blockOf(-half, {half.x(), half.y(), size_m.z()}));
  scene.blocks[0].carve = true;
  scene.containers.push_back(test::tankOf({size_m.x(), size_m.y(), 1.3 * size_m.z()}, true));
  return scene;
}

/// What all colliders together take in some frames, against the momentum of the particles.
template <class Prepare>
void expectMomentumKept(Scene scene, int frames, const Prepare& eachFrame) {
  Simulator<double> simulation(scene, 2);
  const auto momentum = [&] {
    Vec3d sum = Vec3d::Zero();
    for (std::size_t i = 0; i < simulation.particles().size(); ++i) {
      sum += simulation.particles().velocity.at(i);
    }
    return Vec3d(sum * mass_kg(simulation) / double(simulation.particles().size()));
  };
  for (int frame = 0; frame < frames; ++frame) {
    const Vec3d before = momentum();
    eachFrame(simulation, frame);
    simulation.measureWrenches(true);
    simulation.advanceFrame();
    Vec3d sum = Vec3d::Zero();
    for (const ColliderWrench& one : simulation.wrenches()) {
      sum += simulation.colliderPose(one.name).rotation * one.force_n;
    }
    const double time_s = 1 / scene.solver.frame_rate_hz;
    const Vec3d weight = mass_kg(simulation) * scene.gravity_m_s2;
    const Vec3d wanted = weight - (momentum() - before) / time_s;
    ASSERT_LT((sum - wanted).norm(), 1e-9 * weight.norm()) << frame;
  }
}

TEST(WrenchMeterTest, AllForcesAreTheChangeOfMomentumLessTheWeight) {
  Scene scene = test::splash();
  scene.spheres.push_back(test::ball({0.2, 0, 0.1}, 0.12));
  expectMomentumKept(scene, 60, [](Simulator<double>&, int) {});
}

TEST(WrenchMeterTest, ATankCarriesItsWater) {
  const auto simulation = makeSimulation(pool(0.02, {0.2, 0.2, 0.2}), Precision::kFloat, 2);
  const ColliderWrench tank = measured(*simulation, 1, 1)["tank"];
  const double weight_n = kGravity_m_s2 * mass_kg(*simulation);
  EXPECT_NEAR(tank.force_n.z() / weight_n, -1, 0.005);
  EXPECT_LT(tank.force_n.head<2>().norm() / weight_n, 0.005);
  EXPECT_LT(tank.torque_n_m.norm() / (weight_n * 0.1), 0.005);
}

TEST(WrenchMeterTest, WhatIsUnderWaterIsLiftedByTheWaterThatItDisplaces) {
  const Vec3d high(0.013, -0.007, 0.21), low(0.013, -0.007, 0.14);
  std::vector<Scene> scenes(3, pool(0.02, {0.32, 0.32, 0.3}));
  scenes[0].spheres.push_back(test::ball(high, 0.06));
  scenes[1].boxes.emplace_back();
  scenes[1].boxes[0].name = "ball";
  scenes[1].boxes[0].size_m = {0.12, 0.1, 0.08};
  scenes[1].boxes[0].position_m = low;
  scenes[1].boxes[0].rpy_deg = {20, 30, 40};
  scenes[2].cylinders.emplace_back();
  scenes[2].cylinders[0].name = "ball";
  scenes[2].cylinders[0].radius_m = 0.05;
  scenes[2].cylinders[0].height_m = 0.12;
  scenes[2].cylinders[0].position_m = low;
  scenes[2].cylinders[0].rpy_deg = {70, 0, 0};
  const double volumes_m3[] = {4 * M_PI / 3 * std::pow(0.06, 3), 0.12 * 0.1 * 0.08,
                               M_PI * 0.05 * 0.05 * 0.12};
  for (std::size_t k = 0; k < scenes.size(); ++k) {
    const auto simulation = makeSimulation(scenes[k], Precision::kFloat, 2);
    const ColliderWrench solid = measured(*simulation, 0.7, 0.5)["ball"];
    const Vec3d world = simulation->colliderPose("ball").rotation * solid.force_n;
    const double lift_n = kGravity_m_s2 * kWater_kg_m3 * volumes_m3[k];
    EXPECT_NEAR(world.z() / lift_n, 1, 0.02) << k;
    EXPECT_LT(world.head<2>().norm() / lift_n, 0.02) << k;
  }
}

/// Five boxes as a tank around a pool.
Scene boxesAround(double spacing_m, const Vec3d& pool_m) {
  Scene scene = pool(spacing_m, pool_m);
  scene.containers.clear();
  const auto wall = [&](const std::string& name, const Vec3d& size_m, const Vec3d& centre_m) {
    scene.boxes.emplace_back();
    scene.boxes.back().name = name;
    scene.boxes.back().size_m = size_m;
    scene.boxes.back().position_m = centre_m;
  };
  const double x = pool_m.x() / 2 + 0.05, y = pool_m.y() / 2 + 0.05;
  wall("floor", {0.8, 0.8, 0.1}, {0, 0, -0.05});
  wall("left", {0.1, 0.8, 0.4}, {-x, 0, 0.2});
  wall("right", {0.1, 0.8, 0.4}, {x, 0, 0.2});
  wall("front", {pool_m.x(), 0.1, 0.4}, {0, -y, 0.2});
  wall("back", {pool_m.x(), 0.1, 0.4}, {0, y, 0.2});
  return scene;
}

/// With 8 and 12 layers of water; with 24 to 30 within 3 %.
TEST(WrenchMeterTest, AWallFeelsTheMeanPressureOfTheWaterBehindIt) {
  for (const Vec3d& size_m : {Vec3d(0.3, 0.2, 0.24), Vec3d(0.24, 0.28, 0.16)}) {
    const auto simulation = makeSimulation(boxesAround(0.02, size_m), Precision::kFloat, 2);
    auto wrenches = measured(*simulation, 1, 0.5);
    const double pressure_n_m = kGravity_m_s2 * kWater_kg_m3 * size_m.z() * size_m.z() / 2;
    const double on_x_n = size_m.y() * pressure_n_m, on_y_n = size_m.x() * pressure_n_m;
    EXPECT_NEAR(wrenches["left"].force_n.x() / on_x_n, -1, 0.07);
    EXPECT_NEAR(wrenches["right"].force_n.x() / on_x_n, 1, 0.07);
    EXPECT_NEAR(wrenches["front"].force_n.y() / on_y_n, -1, 0.07);
    EXPECT_NEAR(wrenches["back"].force_n.y() / on_y_n, 1, 0.07);
    const double weight_n = kGravity_m_s2 * mass_kg(*simulation);
    EXPECT_NEAR(wrenches["floor"].force_n.z() / weight_n, -1, 0.02);
  }
}

TEST(WrenchMeterTest, ACupWeighsItsWaterAlsoWhileItIsCarried) {
  const auto simulation = makeSimulation(pool(0.02, {0.2, 0.2, 0.16}), Precision::kFloat, 2);
  advance(*simulation, 1);
  simulation->measureWrenches(true);
  const double up_m_s2 = 1.5;
  const int frames = 40;
  for (int frame = 1; frame <= frames; ++frame) {
    Posed pose = simulation->colliderPose("tank");
    pose.position.z() = 0.5 * up_m_s2 * std::pow(frame / 60.0, 2);
    simulation->moveCollider("tank", pose);
    simulation->advanceFrame();
  }
  const ColliderWrench tank = simulation->wrenches()[0];
  EXPECT_NEAR(-tank.force_n.z() / (mass_kg(*simulation) * (kGravity_m_s2 + up_m_s2)), 1, 0.005);
}

TEST(WrenchMeterTest, AJetPushesAPlateWithItsFlowOfMomentum) {
  Scene scene;
  scene.gravity_m_s2.setZero();
  scene.fluid.spacing_m = 0.0125;
  scene.blocks.push_back(test::blockOf({-0.05, -0.05, 0.01}, {0.05, 0.05, 0.81}));
  scene.blocks[0].velocity_m_s = {0, 0, -2};
  scene.boxes.emplace_back();
  scene.boxes[0].name = "plate";
  scene.boxes[0].size_m = {1.6, 1.6, 0.1};
  scene.boxes[0].position_m = {0, 0, -0.05};
  const auto simulation = makeSimulation(scene, Precision::kFloat, 2);
  const ColliderWrench plate = measured(*simulation, 0.1, 0.2)["plate"];
  EXPECT_NEAR(-plate.force_n.z() / (kWater_kg_m3 * 0.01 * 4), 1, 0.05);
}

TEST(WrenchMeterTest, WaterHoldsBackABallThatIsDrawnThroughIt) {
  Scene scene = pool(0.02, {0.8, 0.3, 0.3});
  scene.spheres.push_back(test::ball({-0.2, 0, 0.15}, 0.05));
  const auto simulation = makeSimulation(scene, Precision::kFloat, 2);
  advance(*simulation, 0.5);
  simulation->measureWrenches(true);
  for (int frame = 1; frame <= 30; ++frame) {
    Posed pose = simulation->colliderPose("ball");
    pose.position.x() += 0.8 / 60;
    simulation->moveCollider("ball", pose);
    simulation->advanceFrame();
    if (frame == 10) simulation->measureWrenches(true);
  }
  const double drag_n = 0.5 * kWater_kg_m3 * M_PI * 0.05 * 0.05 * 0.8 * 0.8;
  const double share = -simulation->wrenches()[1].force_n.x() / drag_n;
  EXPECT_GT(share, 0.1);
  EXPECT_LT(share, 3);
}

TEST(WrenchMeterTest, IceThatRestsOnAPlateWeighsOnIt) {
  Scene scene;
  scene.fluid.spacing_m = 0.02;
  scene.thermal.enabled = true;
  scene.blocks.push_back(test::blockOf({-0.1, -0.1, 0.01}, {0.1, 0.1, 0.15}));
  scene.blocks[0].celsius = -10;
  scene.boxes.emplace_back();
  scene.boxes[0].name = "plate";
  scene.boxes[0].size_m = {0.4, 0.4, 0.1};
  scene.boxes[0].position_m = {0, 0, -0.05};
  const auto simulation = makeSimulation(scene, Precision::kFloat, 2);
  for (const double settled_s : {0.2, 2.0}) {
    const ColliderWrench plate = measured(*simulation, settled_s, 0.5)["plate"];
    EXPECT_NEAR(-plate.force_n.z() / (kGravity_m_s2 * mass_kg(*simulation)), 1, 0.005);
  }
}

TEST(WrenchMeterTest, NothingIsMeasuredUnlessSomebodyAsks) {
  const auto simulation = makeSimulation(pool(0.05, {0.3, 0.3, 0.3}), Precision::kFloat, 1);
  const auto other = makeSimulation(pool(0.05, {0.3, 0.3, 0.3}), Precision::kFloat, 1);
  EXPECT_TRUE(simulation->wrenches().empty());
  other->measureWrenches(true);
  for (int frame = 0; frame < 10; ++frame) {
    simulation->advanceFrame();
    other->advanceFrame();
  }
  EXPECT_EQ(simulation->stateHash(), other->stateHash());
  EXPECT_EQ(other->wrenches().size(), 1u);
  other->measureWrenches(false);
  EXPECT_TRUE(other->wrenches().empty());
}

}  // namespace wrench_meter_test
}  // namespace ice_ice_baby
