// What the coarse level promises: water of any depth is as accurate as a puddle, wherever it is and
// however it is turned, and water in flight is left alone.
#include <gtest/gtest.h>

#include "fixtures.h"
#include "ice_ice_baby/simulation.h"

namespace ice_ice_baby {
namespace coarse_level_test {

/// A column of 6 x 6 particles in a pipe.
Scene column(int layers, double spacing_m) {
  Scene scene;
  scene.fluid.spacing_m = spacing_m;
  const double half = 3 * spacing_m, height = layers * spacing_m;
  scene.blocks.push_back(test::blockOf({-half, -half, 0}, {half, half, height}));
  scene.containers.push_back(test::tankOf({2 * half, 2 * half, 1.2 * height}, true));
  scene.containers[0].friction = 0.0;
  return scene;
}

struct Rest {
  double error, rms_m_s, rise;  ///< rise of energy over that of the column at the start
  std::size_t nodes;
};

Rest rested(const Scene& scene, int frames) {
  const auto simulation = makeSimulation(scene, Precision::kFloat, 1);
  const auto energy = [&] {
    const StepReport& now = simulation->report();
    return now.kinetic_energy_j + now.potential_energy_j;
  };
  const double before = energy();
  double highest = before;
  for (int frame = 0; frame < frames; ++frame) {
    simulation->advanceFrame();
    highest = std::max(highest, energy());
  }
  const StepReport& end = simulation->report();
  EXPECT_TRUE(end.quality_met);
  return {end.density_error_run, end.rms_speed_m_s, (highest - before) / std::abs(before),
          end.coarse_nodes};
}

class DepthTest : public testing::TestWithParam<int> {};

TEST_P(DepthTest, AColumnRestsAsAccuratelyAtAnyDepth) {
  const Rest rest = rested(column(GetParam(), 0.01), 60);
  EXPECT_LT(rest.error, 0.0005);  // without the coarse level 0.6 % at 20 layers, 2.5 % at 80
  EXPECT_LT(rest.rms_m_s, 0.005);
  EXPECT_LT(rest.rise, 1e-3);
}
INSTANTIATE_TEST_SUITE_P(Layers, DepthTest, testing::Values(20, 40, 80));

TEST(CoarseLevelTest, ARefinedColumnOfOneHeightIsNoLessAccurate) {
  for (const int layers : {20, 80}) {
    const Rest rest = rested(column(layers, 0.4 / layers), 60);
    EXPECT_LT(rest.error, 0.0005) << layers;  // without it 10 % at 80 layers
    EXPECT_LT(rest.rms_m_s, 0.005) << layers;
  }
}

TEST(CoarseLevelTest, OrientationAndPlaceDoNotMatter) {
  Scene scene = column(30, 0.01);
  scene.gravity_m_s2.setZero();
  const Vec3d rpy(30, 20, 10), place(4, -3, 2);
  const Posed pose = poseOf(place, rpy);
  scene.containers[0].position_m = place;
  scene.containers[0].rpy_deg = rpy;
  scene.gravity_m_s2 = pose.rotation * Vec3d(0, 0, -9.81);
  const Vec3d centre = pose.toWorld(scene.blocks[0].centre_m());
  const Vec3d half = (scene.blocks[0].max_m - scene.blocks[0].min_m) / 2;
  scene.blocks[0].min_m = centre - half;
  scene.blocks[0].max_m = centre + half;
  scene.blocks[0].rpy_deg = rpy;
  const Rest rest = rested(scene, 60);
  EXPECT_GT(rest.nodes, 10u);
  EXPECT_LT(rest.error, 0.0005);
  EXPECT_LT(rest.rms_m_s, 0.005);
}

TEST(CoarseLevelTest, PressureIsThatOfTheWaterAbove) {
  for (const int layers : {20, 60}) {
    const Scene scene = column(layers, 0.01);
    const auto simulation = makeSimulation(scene, Precision::kFloat, 1);
    for (int frame = 0; frame < 90; ++frame) simulation->advanceFrame();
    std::vector<ParticleSample> samples;
    simulation->sample(samples);
    const double height = 0.01 * layers;
    double measured = 0.0, expected = 0.0;
    for (const ParticleSample& p : samples) {
      if (double(p.z) < 0.1 * height || double(p.z) > 0.7 * height) continue;
      measured += double(p.pressure_pa);
      expected += 9810.0 * (height - double(p.z));
    }
    EXPECT_NEAR(measured / expected, 1.0, 0.02) << layers;
  }
}

TEST(CoarseLevelTest, WaterInFlightHasNone) {
  Scene scene = column(20, 0.01);
  for (Vec3d* corner : {&scene.blocks[0].min_m, &scene.blocks[0].max_m}) corner->z() += 0.6;
  scene.containers[0].size_m.z() = 1.0;
  const auto simulation = makeSimulation(scene, Precision::kFloat, 1);
  for (int frame = 0; frame < 15; ++frame) {
    EXPECT_EQ(simulation->advanceFrame().coarse_nodes, 0u) << frame;
  }
  std::size_t max = 0;
  for (int frame = 0; frame < 90; ++frame) {
    max = std::max(max, simulation->advanceFrame().coarse_nodes);
  }
  EXPECT_GT(max, 0u);
}

TEST(CoarseLevelTest, NothingAloneOrWithoutWallsHasNone) {
  Scene scene = column(10, 0.01);
  scene.containers.clear();
  const auto simulation = makeSimulation(scene, Precision::kFloat, 1);
  EXPECT_EQ(simulation->advanceFrame().coarse_nodes, 0u);
  for (const StageStats& stage : simulation->stages()) EXPECT_NE(stage.name, "coarse_level");
}

/// Water that lies a tenth too loose settles to its density; the coarse level does not hold it up.
TEST(CoarseLevelTest, LooseWaterSettles) {
  Scene scene = column(40, 0.01);
  scene.blocks[0].max_m.z() = 0.2;
  Block upper = scene.blocks[0];
  for (Vec3d* corner : {&upper.min_m, &upper.max_m}) corner->z() += 0.23;
  scene.blocks.push_back(upper);
  const auto simulation = makeSimulation(scene, Precision::kFloat, 1);
  for (int frame = 0; frame < 180; ++frame) simulation->advanceFrame();
  const double mass_kg = 0.4 * 0.06 * 0.06 * 1000;
  EXPECT_NEAR(simulation->report().potential_energy_j / (mass_kg * 9.81), 0.2, 0.2 * 0.02);
}

TEST(QualityTest, APromiseThatIsNotKeptIsTold) {
  Scene scene = column(40, 0.01);
  scene.solver.coarse_level = false;
  scene.solver.substeps = 4;
  const auto simulation = makeSimulation(scene, Precision::kFloat, 1);
  for (int frame = 0; frame < 60; ++frame) simulation->advanceFrame();
  const StepReport& report = simulation->report();
  EXPECT_EQ(report.promised_error, 0.002);
  EXPECT_GT(report.density_error_run, 0.002);
  EXPECT_FALSE(report.quality_met);
}

TEST(QualityTest, TheErrorOfADamStaysBelowThatOfEveryQuality) {
  for (const auto& [quality, promised] : std::vector<std::pair<Quality, double>>{
           {Quality::kFast, 0.01}, {Quality::kBalanced, 0.002}, {Quality::kAccurate, 0.0003}}) {
    Scene scene = test::splash();
    scene.solver.quality = quality;
    const auto simulation = makeSimulation(scene, Precision::kFloat, 1);
    for (int frame = 0; frame < 90; ++frame) simulation->advanceFrame();
    EXPECT_EQ(simulation->report().promised_error, promised);
    EXPECT_LE(simulation->report().density_error_run, promised);
    EXPECT_TRUE(simulation->report().quality_met);
  }
}

}  // namespace coarse_level_test
}  // namespace ice_ice_baby
