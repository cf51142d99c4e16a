// Overfull tanks, huge gravity, huge speeds: no particle is lost and all stay finite.
#include <gtest/gtest.h>

#include "fixtures.h"
#include "ice_ice_baby/errors.h"
#include "metrics/escape_meter.h"
#include "unchecked.h"

namespace ice_ice_baby {
namespace crowding_test {

using test::Random;

void expectWhole(const Simulation& simulation, std::size_t particles) {
  ASSERT_EQ(simulation.report().particles, particles);
  ASSERT_EQ(simulation.report().non_finite, 0u);
  ASSERT_EQ(countEscaped(simulation), 0u);
  ASSERT_TRUE(std::isfinite(simulation.report().kinetic_energy_j));
}

TEST(CrowdingTest, ATankTwentyTimesTooFullLosesNothingAtTenThousandMetresPerSecondSquared) {
  Scene scene = test::fullTank(4);
  scene.blocks.assign(20, scene.blocks[0]);
  for (int k = 0; k < 20; ++k) {
    scene.blocks[k].rpy_deg = {0, 0, k % 4 * 90.0};
    scene.blocks[k].min_m.z() += 1e-4 * k;
  }
  scene.gravity_m_s2 = {0, 0, -1e4};
  const auto simulation = test::unchecked(scene, 1);
  const std::size_t particles = simulation->report().particles;
  for (int frame = 0; frame < test::repeats(30); ++frame) {
    if (frame % 3 == 0) simulation->setGravity({0, 0, frame % 2 == 0 ? 1e4 : -1e4});
    simulation->advanceFrame();
    expectWhole(*simulation, particles);
  }
  EXPECT_GT(simulation->report().density_error_mean, 5.0);
}

TEST(CrowdingTest, AParticleAtTheCentreOfABallIsPutOnTopOfItAtRest) {
  Scene scene = test::floatingCube(1);
  scene.spheres.emplace_back();
  scene.spheres[0].position_m = Vec3d::Constant(0.025);
  scene.spheres[0].radius_m = 0.3;
  Simulator<double> simulator(scene, 1);
  const Vec3d top = scene.spheres[0].position_m + Vec3d(0, 0, 0.325);
  EXPECT_LT((simulator.particles().position.at(0) - top).norm(), 1e-12);
  simulator.advanceFrame();
  EXPECT_LT(simulator.report().max_speed_m_s, 1e-9);
}

TEST(CrowdingTest, CrossedContainersAndWedgesLoseNothingAndThrowNothing) {
  Random random(95);
  for (int round = 0; round < test::repeats(12); ++round) {
    Scene scene = test::splash();
    scene.containers.push_back(test::tankOf({0.6, 0.6, 0.6}, true, "crossed"));
    scene.containers[1].position_m = random.inBox({-0.4, -0.2, -0.1}, {0.4, 0.2, 0.6});
    scene.containers[1].rpy_deg = 90 * random.direction();
    for (const char* name : {"one", "two"}) {
      Plane plate;
      plate.name = name;
      plate.size_x_m = plate.size_y_m = 0.6;
      plate.position_m = {0.1, 0, 0.1};
      plate.rpy_deg = {0, name[0] == 'o' ? 20.0 : -20.0, 0};
      scene.planes.push_back(plate);
    }
    scene.spheres.emplace_back().position_m = {0.5, 0, 0.3};  // half in the wall
    scene.blocks[0].velocity_m_s = 20 * random.direction();
    const auto simulation = test::unchecked(scene, 1);
    const std::size_t particles = simulation->report().particles;
    for (int frame = 0; frame < 15; ++frame) {
      simulation->advanceFrame();
      expectWhole(*simulation, particles);
      EXPECT_LE(simulation->report().max_speed_m_s, 60.0);
    }
  }
}

TEST(CrowdingTest, ThousandsInOneCellAreEachListedOnce) {
  const std::size_t n = 3000;
  const std::vector<Vec3d> points = test::randomPoints(n, Vec3d::Zero(), Vec3d::Constant(0.01), 96);
  test::Cloud<float> cloud(points, 0.1);
  EXPECT_EQ(cloud.neighbours.pairs(), n * (n - 1) / 2);
}

/// run_scene then reports the error and ends, and the node pauses.
TEST(CrowdingTest, AFrameWhoseListsNeedTooMuchMemoryIsRefusedAndLaterOnesMayRun) {
  Simulator<float> simulator(test::splash(), 1);
  simulator.advanceFrame();
  const VectorField<float> spread = simulator.particles().position;
  const std::size_t particles = simulator.particles().size();
  simulator.neighbours().limitLists(1e6);
  for (std::size_t i = 0; i < particles; ++i) {
    simulator.particles().position.set(i, {0, 0, 0.5f});
  }
  for (int k = 0; k < 2; ++k) EXPECT_THROW(simulator.advanceFrame(), InvalidInput);
  EXPECT_EQ(countEscaped(simulator), 0u);
  EXPECT_EQ(simulator.report().particles, particles);
  simulator.particles().position = spread;
  simulator.advanceFrame();
  expectWhole(simulator, particles);
}

TEST(CrowdingTest, FloatsHoldWaterInATankAtTheEdgeOfTheScene) {
  Scene scene = test::splash();
  const Vec3d out(-99, 98, 97);
  scene.bounds = {Vec3d::Constant(-100), Vec3d::Constant(100)};
  scene.blocks[0].min_m += out;
  scene.blocks[0].max_m += out;
  scene.containers[0].position_m = out;
  const auto simulation = makeSimulation(scene, Precision::kFloat, 1);
  const std::size_t particles = simulation->report().particles;
  for (int frame = 0; frame < 60; ++frame) {
    simulation->advanceFrame();
    expectWhole(*simulation, particles);
  }
  EXPECT_LT(simulation->report().max_speed_m_s, 6.0);
}

TEST(CrowdingTest, WaterAt1000MetresPerSecondStaysInAndOutAtEveryFrameRate) {
  for (const double rate : {1.0, 60.0, 1e3, 1e4}) {
    for (const Vec3d& way : {Vec3d(1, 0, 0), Vec3d(-1, 1, 1), Vec3d(0, 0, -1)}) {
      Scene scene = test::splash();
      scene.solver.frame_rate_hz = rate;
      scene.solver.substeps = 1;
      scene.solver.max_speed_m_s = 1e5;
      scene.containers[0].wall_m = 1e-4;
      scene.spheres.emplace_back().position_m = {0.3, 0, 0.3};
      scene.spheres[0].radius_m = 0.01;
      scene.blocks[0].velocity_m_s = 1000 * way.normalized();
      Block outside = scene.blocks[0];
      outside.min_m.x() -= 1.5;
      outside.max_m.x() -= 1.5;
      outside.max_m.z() = 0.3;
      outside.velocity_m_s = {1000, 0, 0};
      scene.blocks.push_back(outside);
      Simulator<float> simulator(scene, 1);
      const std::size_t inner = 8 * 10 * 12;
      for (int frame = 0; frame < 20; ++frame) {
        simulator.advanceFrame();
        expectWhole(simulator, simulator.particles().size());
      }
      std::size_t entered = 0;
      for (std::size_t i = 0; i < simulator.particles().size(); ++i) {
        const Vec3<float> x = simulator.particles().position.at(i);
        const bool within =
            std::abs(x.x()) < 0.5f && std::abs(x.y()) < 0.25f && x.z() > 0 && x.z() < 1;
        entered += within && simulator.particles().id[i] >= inner;
      }
      EXPECT_EQ(entered, 0u) << rate;
    }
  }
}

}  // namespace crowding_test
}  // namespace ice_ice_baby
