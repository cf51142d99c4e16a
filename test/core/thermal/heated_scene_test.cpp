// Heat in whole scenes: walls, steam, extreme parameters.
#include <gtest/gtest.h>

#include <cmath>

#include "fixtures.h"
#include "metrics/escape_meter.h"
#include "thermal/kettle.h"
#include "unchecked.h"

namespace ice_ice_baby {
namespace heated_scene_test {

using test::iceInKettle;
using test::kettle;

void run(Simulation& simulation, int frames) {
  for (int k = 0; k < frames; ++k) simulation.advanceFrame();
}

TEST(SteamTest, WaterBoilsRisesCondensesOnTheLidAndFallsBack) {
  const Scene scene = kettle();
  Simulator<float> simulator(scene, 1);
  std::size_t max_steam = 0, condensed = 0, before = 0;
  float highest = 0;
  std::vector<ParticleSample> samples;
  for (int frame = 0; frame < 600; ++frame) {
    simulator.advanceFrame();
    const std::size_t steam = simulator.report().steam_particles;
    max_steam = std::max(max_steam, steam);
    if (steam < before) condensed += before - steam;
    before = steam;
    simulator.sample(samples, 1);
    std::size_t sampled = 0;
    for (const ParticleSample& p : samples) {
      if (p.phase != Phase::kSteam) continue;
      ++sampled;
      EXPECT_EQ(p.density, 6e-4f);
      highest = std::max(highest, p.z);
    }
    ASSERT_EQ(sampled, steam);
  }
  EXPECT_GT(max_steam, 5u);
  EXPECT_GT(condensed, 5u);
  EXPECT_GT(highest, 0.35f) << "steam reaches the lid";
  EXPECT_EQ(countEscaped(simulator), 0u);
  EXPECT_EQ(simulator.report().non_finite, 0u);
}

/// A drop of water at 0 degrees C that nothing but `passHeat` heats.
Scene drop() {
  Scene scene;
  scene.fluid.spacing_m = 0.02;
  scene.thermal.enabled = true;
  scene.thermal.speedup = 1000.0;
  scene.thermal.air_heat_transfer_w_m2k = 0.0;
  scene.gravity_m_s2 = Vec3d::Zero();
  Block block;
  block.max_m = Vec3d::Constant(0.08);
  block.celsius = 0.0;
  scene.blocks = {block};
  return scene;
}

/// Gives all water the heat, within half a second, and lets it swell for another half.
void passHeat(Simulation& simulation, double heat_j_kg) {
  const FluidParams& fluid = simulation.scene().fluid;
  const double mass_kg = fluid.rest_density_kg_m3 * std::pow(fluid.spacing_m, 3) *
                         double(simulation.report().particles);
  HeatedRegion region;
  region.shape = BlockShape::kBox;
  region.size_m = Vec3d::Constant(10.0);
  region.duration_s = 0.5;
  region.power_w = heat_j_kg * mass_kg / (region.duration_s * simulation.scene().thermal.speedup);
  simulation.heatRegion(region);
  run(simulation, 66);
}

void expectAll(const Simulation& simulation, Phase phase, float ice_fraction) {
  std::vector<ParticleSample> samples;
  simulation.sample(samples);
  ASSERT_FALSE(samples.empty());
  for (const ParticleSample& p : samples) {
    ASSERT_EQ(p.phase, phase) << p.id;
    ASSERT_NEAR(p.ice_fraction, ice_fraction, 1e-3) << p.id;
  }
  const std::size_t ice = phase == Phase::kIce ? samples.size() : 0;
  EXPECT_EQ(simulation.report().ice_particles, ice);
}

TEST(PhaseTest, SamplesTellSlushThatFlowsFromIceThatMelts) {
  const auto simulation = makeSimulation(drop(), Precision::kFloat, 1);
  const double latent_j_kg = simulation->scene().thermal.latent_heat_fusion_j_kg;
  expectAll(*simulation, Phase::kWater, 0.0f);
  passHeat(*simulation, -0.6 * latent_j_kg);
  expectAll(*simulation, Phase::kWater, 0.6f);
  passHeat(*simulation, -0.5 * latent_j_kg);
  expectAll(*simulation, Phase::kIce, 1.0f);
  passHeat(*simulation, 0.5 * latent_j_kg);
  expectAll(*simulation, Phase::kIce, 0.6f);
  passHeat(*simulation, 0.7 * latent_j_kg);
  expectAll(*simulation, Phase::kWater, 0.0f);
}

TEST(PhaseTest, WithoutHeatAllIsIceWhileTheSceneIsFrozen) {
  Scene scene = drop();
  scene.thermal.enabled = false;
  const auto simulation = makeSimulation(scene, Precision::kFloat, 1);
  const TemperatureParams& limits = scene.temperature;
  const std::pair<double, Phase> states[] = {
      {limits.onset_c, Phase::kWater},
      {0.5 * (limits.onset_c + limits.freezing_c), Phase::kWater},
      {limits.freezing_c, Phase::kIce},
      {limits.onset_c, Phase::kWater}};
  for (const auto& [celsius, phase] : states) {
    simulation->setTemperature(celsius, 0.0);
    run(*simulation, 2);
    std::vector<ParticleSample> samples;
    simulation->sample(samples);
    EXPECT_EQ(samples.at(0).phase, phase) << celsius;
    EXPECT_FLOAT_EQ(samples.at(0).ice_fraction, float(simulation->report().strictness));
  }
}

TEST(SteamTest, RisesAtItsSpeedAgainstGravity) {
  Scene scene;
  scene.thermal.enabled = true;
  scene.blocks.emplace_back();
  scene.blocks[0].min_m = Vec3d::Zero();
  scene.blocks[0].max_m = Vec3d::Constant(scene.fluid.spacing_m);
  scene.blocks[0].celsius = 300.0;
  scene.gravity_m_s2 = Vec3d(0, 9.81, 0);
  Simulator<double> simulator(scene, 1);
  ASSERT_EQ(simulator.report().steam_particles, 1u);
  run(simulator, 60);
  const double t = 1.0, rate = scene.steam.drag_1_s, speed = scene.steam.rise_speed_m_s;
  EXPECT_NEAR(simulator.particles().velocity.y[0], -speed * (1 - std::exp(-rate * t)), 1e-9);
  const double way = speed * (t - (1 - std::exp(-rate * t)) / rate);
  EXPECT_NEAR(simulator.particles().position.y[0] - scene.fluid.spacing_m / 2, -way, 0.01 * way);
}

TEST(HeatedSceneTest, SetTemperatureOfAColliderLeavesTheAir) {
  Scene scene = kettle();
  scene.planes[0].heat = ThermalBoundary::kInsulated;
  scene.planes[1].heat = ThermalBoundary::kInsulated;
  const auto simulation = makeSimulation(scene, Precision::kFloat, 1);
  run(*simulation, 30);
  const double still = simulation->report().enthalpy_j;
  run(*simulation, 30);
  EXPECT_NEAR(simulation->report().enthalpy_j / still, 1.0, 1e-12);
  simulation->setTemperature(-50.0, 0.5, "floor");
  run(*simulation, 60);
  EXPECT_LT(simulation->report().enthalpy_j, 0.9 * still);
  EXPECT_EQ(simulation->report().temperature_c, 100.0);
}

TEST(HeatedExtremesTest, NothingBecomesNotFiniteOrEscapes) {
  using Change = void (*)(Scene&);
  const std::vector<std::pair<const char*, Change>> cases = {
      {"speedup 1e7", [](Scene& s) { s.thermal.speedup = 1e7; }},
      {"no heat passes", [](Scene& s) { s.thermal.speedup = 0.0; }},
      {"heavy ice", [](Scene& s) { s.ice.density_ratio = 2.0; }},
      {"light ice", [](Scene& s) { s.ice.density_ratio = 0.5; }},
      {"no hysteresis", [](Scene& s) { s.thermal.hysteresis_c = 0.0; }},
      {"tiny latent heats",
       [](Scene& s) {
         s.thermal.latent_heat_fusion_j_kg = s.thermal.latent_heat_vaporisation_j_kg = 1.0;
       }},
      {"tiny capacities",
       [](Scene& s) {
         s.thermal.ice_specific_heat_j_kgk = s.thermal.water_specific_heat_j_kgk = 1.0;
       }},
      {"conducts as no metal does", [](Scene& s) { s.thermal.water_conductivity_w_mk = 1e4; }},
      {"conducts nothing",
       [](Scene& s) { s.thermal.ice_conductivity_w_mk = s.thermal.water_conductivity_w_mk = 0.0; }},
      {"air that takes all", [](Scene& s) { s.thermal.air_heat_transfer_w_m2k = 1e6; }},
      {"1000 degrees below", [](Scene& s) { s.planes[0].celsius = 1000.0; }},
      {"a flux of 10 MW",
       [](Scene& s) {
         s.planes[0].heat = ThermalBoundary::kFlux;
         s.planes[0].flux_w_m2 = -1e7;
       }},
      {"ice at 300 m/s", [](Scene& s) { s.blocks[1].velocity_m_s = Vec3d(300, 200, -1000); }},
      {"ice that spins",
       [](Scene& s) { s.blocks[1].angular_velocity_rad_s = Vec3d(1000, -900, 800); }},
      {"1000 g", [](Scene& s) { s.gravity_m_s2 = Vec3d(0, 0, -9810); }},
      {"gravity aside", [](Scene& s) { s.gravity_m_s2 = Vec3d(100, 30, 5); }},
      {"ice in the water",
       [](Scene& s) {
         s.blocks[1].min_m.z() = 0.0;  // which makeSimulation would refuse
         s.blocks[1].max_m.z() = 0.1;
       }},
      {"one substep, one iteration", [](Scene& s) { s.solver.substeps = s.solver.iterations = 1; }},
      {"no iterations", [](Scene& s) { s.solver.iterations = 0; }},
      {"elastic ice", [](Scene& s) { s.ice.compliance_m_n = 1e-4; }},
      {"stiff ice that breaks",
       [](Scene& s) {
         s.ice.compliance_m_n = 1e-12;
         s.ice.break_strain = 0.01;
       }},
      {"steam as fast as sound", [](Scene& s) { s.steam.rise_speed_m_s = 100.0; }},
      {"fifty frames a minute", [](Scene& s) { s.solver.frame_rate_hz = 1.0; }},
  };
  for (const auto& [name, change] : cases) {
    SCOPED_TRACE(name);
    Scene scene = iceInKettle();
    change(scene);
    const auto simulation = test::unchecked(scene, 1);
    run(*simulation, test::repeats(90));
    std::vector<ParticleSample> samples;
    simulation->sample(samples);
    for (const ParticleSample& p : samples) {
      ASSERT_TRUE(std::isfinite(p.x + p.y + p.z + p.vx + p.vy + p.vz)) << p.id;
      ASSERT_GE(p.temperature_c, kTemperatureRange_c.min - 1e-3);
      ASSERT_LE(p.temperature_c, kTemperatureRange_c.max + 1e-3);
    }
    EXPECT_EQ(countEscaped(*simulation), 0u);
    EXPECT_EQ(simulation->report().non_finite, 0u);
  }
}

}  // namespace heated_scene_test
}  // namespace ice_ice_baby
