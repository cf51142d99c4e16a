// Energy of whole scenes: without external work it must not rise.
#include <gtest/gtest.h>

#include <algorithm>

#include "fixtures.h"
#include "simulation/simulator.h"

namespace ice_ice_baby {
namespace energy_test {

double mechanical_j(const StepReport& r) { return r.kinetic_energy_j + r.potential_energy_j; }
double total_j(const StepReport& r) { return mechanical_j(r) + r.elastic_energy_j; }

/// Largest rise of an energy above its running minimum.
class Rise {
 public:
  void add(double energy_j) {
    min_j_ = std::min(min_j_, energy_j);
    rise_j_ = std::max(rise_j_, energy_j - min_j_);
  }
  double value_j() const { return rise_j_; }

 private:
  double min_j_ = std::numeric_limits<double>::max();
  double rise_j_ = 0.0;
};

/// A column that falls on the floor of an open tank and splashes over its rim.
Scene splash(int substeps) {
  Scene scene;
  scene.fluid.spacing_m = 0.04;
  scene.solver.substeps = substeps;
  scene.blocks.push_back(test::blockOf({-0.2, -0.2, 0.5}, {0.2, 0.2, 1.1}));
  scene.containers.push_back(test::tankOf({0.6, 0.5, 0.35}, true));
  scene.planes.emplace_back();
  scene.planes[0].name = "ground";
  return scene;
}

struct Rises {
  double mechanical;
  double total;
};

/// Both relative to the potential energy of the fall.
Rises risesOf(const Scene& scene, double drop_m, int frames) {
  const auto simulation = makeSimulation(scene, Precision::kFloat, 1);
  const double mass_kg = double(simulation->report().particles) * scene.fluid.rest_density_kg_m3 *
                         std::pow(scene.fluid.spacing_m, 3);
  const double scale_j = mass_kg * scene.gravity_m_s2.norm() * drop_m;
  Rise mechanical, total;
  for (int frame = 0; frame < frames; ++frame) {
    const StepReport& report = simulation->advanceFrame();
    mechanical.add(mechanical_j(report));
    total.add(total_j(report));
  }
  return {mechanical.value_j() / scale_j, total.value_j() / scale_j};
}

class SplashEnergyTest : public testing::TestWithParam<int> {};

TEST_P(SplashEnergyTest, DoesNotRise) {
  EXPECT_LT(risesOf(splash(GetParam()), 0.7, test::repeats(120)).total, 1e-4);
}

INSTANTIATE_TEST_SUITE_P(Substeps, SplashEnergyTest, testing::Values(2, 4, 8, 24));

/// A column that falls down a pipe, lands in one piece and takes more substeps while it is
/// compressed.
class LandingTest : public testing::TestWithParam<std::tuple<double, bool>> {};

TEST_P(LandingTest, GivesBackLessThanItHad) {
  const auto [column_m, coarse] = GetParam();
  Scene scene;
  scene.fluid.spacing_m = 0.02;
  scene.solver.coarse_level = coarse;
  scene.blocks.push_back(test::blockOf({-0.06, -0.06, 0.3}, {0.06, 0.06, 0.3 + column_m}));
  scene.containers.push_back(test::tankOf({0.12, 0.12, 2 * column_m + 0.5}, true));
  const auto simulation = makeSimulation(scene, Precision::kFloat, 1);
  const double start_j = total_j(simulation->report());
  double most_j = 0.0;
  int most_substeps = 0;
  for (int frame = 0; frame < 60; ++frame) {
    const StepReport& report = simulation->advanceFrame();
    if (report.time_s > 0.25) most_j = std::max(most_j, mechanical_j(report));
    most_substeps = std::max(most_substeps, report.substeps);
  }
  EXPECT_LT(most_j, start_j);
  EXPECT_GT(most_substeps, scene.fewestSubsteps());  // they rose
}

INSTANTIATE_TEST_SUITE_P(Of, LandingTest,
                         testing::Combine(testing::Values(0.2, 0.4, 1.6), testing::Bool()));

TEST(EnergyTest, ReboundComesFromEnergyStoredInPressure) {
  // Two substeps without a coarse level leave water so compressible that it bounces.
  Scene scene = splash(2);
  scene.solver.coarse_level = false;
  const Rises rises = risesOf(scene, 0.7, 60);
  EXPECT_GT(rises.mechanical, 1e-3);
  EXPECT_LT(rises.total, 0.1 * rises.mechanical);
}

TEST(EnergyTest, FreezingInMidSplashAddsNone) {
  Scene scene = splash(8);
  scene.schedule = {{0.35, -5, 0.08}};
  EXPECT_LT(risesOf(scene, 0.7, test::repeats(120)).total, 1e-3);
}

/// Springs that few iterations leave stretched turn their energy into speed later.
class SheetEnergyTest : public testing::TestWithParam<int> {};

TEST_P(SheetEnergyTest, GivesBackNoMoreThanItsSpringsHold) {
  Scene scene;
  scene.fluid.spacing_m = 0.03;
  scene.blocks.push_back(test::blockOf({-0.45, -0.45, 0.6}, {0.45, 0.45, 0.63}));
  scene.blocks[0].sheet = true;
  scene.spheres.push_back(test::ball({0, 0, 0.3}, 0.2));
  scene.planes.emplace_back();
  scene.planes[0].name = "ground";
  scene.solver.substeps = GetParam();
  const Rises rises = risesOf(scene, 0.4, 90);
  EXPECT_LT(rises.total, 1e-4);
  EXPECT_GT(rises.mechanical, 1e-3);
}

INSTANTIATE_TEST_SUITE_P(Substeps, SheetEnergyTest, testing::Values(2, 4, 8, 24));

TEST(EnergyTest, TheElasticPartIsThatOfAnEvenlyPressedColumn) {
  // Pressure p compresses a volume V by C: energy p C V / 2, with p = rho g z and C as measured.
  Scene scene = test::fullTank(8, true);
  scene.solver.coarse_level = false;  // with it the column is hardly compressed
  const auto simulation = makeSimulation(scene, Precision::kDouble, 1);
  for (int frame = 0; frame < 240; ++frame) simulation->advanceFrame();
  std::vector<ParticleSample> particles;
  simulation->sample(particles);
  double expected_j = 0.0;
  const double volume_m3 = std::pow(scene.fluid.spacing_m, 3);
  for (const ParticleSample& p : particles) {
    const double pressure_pa = 1000 * 9.81 * std::max(0.0, 0.4 - double(p.z));
    expected_j += 0.5 * pressure_pa * volume_m3 * std::max(0.0, double(p.density) - 1.0);
  }
  EXPECT_NEAR(simulation->report().elastic_energy_j, expected_j, 0.2 * expected_j);
}

TEST(EnergyTest, WaterLandsOnARimWithoutBeingThrownAside) {
  Scene scene;
  scene.fluid.spacing_m = 0.02;
  scene.solver.iterations = 0;  // no pressure: only walls can push
  scene.solver.substeps = 24;
  scene.containers.push_back(test::tankOf({0.4, 0.4, 0.3}, true));
  scene.blocks.push_back(test::blockOf({-0.25, -0.05, 0.4}, {0.25, 0.05, 0.42}));
  scene.planes.emplace_back();
  scene.planes[0].name = "ground";
  const double fall_m_s = std::sqrt(2 * 9.81 * 0.42);
  const auto simulation = makeSimulation(scene, Precision::kFloat, 1);
  for (int frame = 0; frame < 40; ++frame) {
    simulation->advanceFrame();
    ASSERT_LT(simulation->report().max_speed_m_s, fall_m_s) << "frame " << frame;
  }
}

TEST(EnergyTest, CorrectionsThatAreCutAreCounted) {
  Scene calm = test::fullTank(6, true);
  Scene crushed = splash(2);
  crushed.gravity_m_s2 = {0, 0, -1000};
  const auto cutIn = [](const Scene& scene) {
    const auto simulation = makeSimulation(scene, Precision::kFloat, 1);
    std::uint64_t cut = 0;
    for (int frame = 0; frame < 30; ++frame) cut += simulation->advanceFrame().correction_limited;
    return cut;
  };
  EXPECT_EQ(cutIn(calm), 0u);
  EXPECT_GT(cutIn(crushed), 1000u);
}

}  // namespace energy_test
}  // namespace ice_ice_baby
