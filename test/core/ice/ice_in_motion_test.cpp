// Freezing and melting in whole scenes: momenta, volume and energy.
#include <gtest/gtest.h>

#include <cmath>

#include "fixtures.h"
#include "particles/kernels.h"
#include "simulation/simulator.h"

namespace ice_ice_baby {
namespace ice_in_motion_test {

struct Motion3 {
  Vec3d momentum = Vec3d::Zero();
  Vec3d angular = Vec3d::Zero();  ///< about the origin
  double fastest = 0.0;
};

template <class Real>
Motion3 motionOf(const Particles<Real>& particles, double mass) {
  Motion3 motion;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const Vec3d v = particles.velocity.at(i).template cast<double>();
    const Vec3d x = particles.position.at(i).template cast<double>();
    motion.momentum += mass * v;
    motion.angular += mass * x.cross(v);
    motion.fastest = std::max(motion.fastest, v.norm());
  }
  return motion;
}

/// Two balls of water at the freezing point that collide off centre in empty space.
Scene splashInSpace() {
  Scene scene;
  scene.gravity_m_s2.setZero();
  scene.fluid.spacing_m = 0.02;
  scene.solver.viscosity_1_s = 0.0;  // its shear would take angular momentum away
  scene.thermal.enabled = true;
  scene.thermal.air_heat_transfer_w_m2k = 0.0;
  Block one;
  one.shape = BlockShape::kSphere;
  one.min_m = Vec3d(-0.21, -0.1, -0.1);
  one.max_m = Vec3d(-0.01, 0.1, 0.1);
  one.velocity_m_s = Vec3d(0.5, 0.1, 0.0);
  one.celsius = 0.0;
  Block two = one;
  two.min_m += Vec3d(0.22, 0.06, 0.04);
  two.max_m += Vec3d(0.22, 0.06, 0.04);
  two.velocity_m_s = Vec3d(-0.6, 0.0, 0.1);
  scene.blocks = {one, two};
  return scene;
}

/// Cools all water to 20 degrees below freezing within a fifth of a second.
void flashFreeze(Simulation& simulation, double water_kg) {
  HeatedRegion spray;
  spray.shape = BlockShape::kBox;
  spray.size_m = Vec3d::Constant(10.0);
  spray.duration_s = 0.2;
  const ThermalParams& thermal = simulation.scene().thermal;
  spray.power_w = -water_kg *
                  (thermal.latent_heat_fusion_j_kg + 20.0 * thermal.ice_specific_heat_j_kgk) /
                  spray.duration_s;
  simulation.heatRegion(spray);
}

TEST(IceInMotionTest, FreezingInMidSplashKeepsBothMomentaAndMakesNothingFaster) {
  const Scene scene = splashInSpace();
  Simulator<float> simulator(scene, 1);
  const double mass = particleMass_kg(scene.fluid, scene.supportRadius_m());
  for (int frame = 0; frame < 18; ++frame) simulator.advanceFrame();
  const Motion3 before = motionOf(simulator.particles(), mass);
  flashFreeze(simulator, mass * double(simulator.particles().size()));
  for (int frame = 0; frame < 60; ++frame) simulator.advanceFrame();
  const Motion3 after = motionOf(simulator.particles(), mass);

  EXPECT_EQ(simulator.report().ice_particles, simulator.particles().size());
  const double momentum_scale = mass * double(simulator.particles().size()) * before.fastest;
  EXPECT_LT((after.momentum - before.momentum).norm(), 1e-3 * momentum_scale);
  EXPECT_LT((after.momentum - before.momentum).norm(), 1e-3 * before.momentum.norm());
  EXPECT_LT((after.angular - before.angular).norm(), 1e-3 * before.angular.norm());
  EXPECT_LE(after.fastest, before.fastest);
}

/// A narrow basin of water at 5 degrees; the air takes no heat.
Scene basin() {
  Scene scene;
  scene.fluid.spacing_m = 0.02;
  scene.thermal.enabled = true;
  scene.thermal.air_heat_transfer_w_m2k = 0.0;
  Block water;
  water.min_m = Vec3d(-0.06, -0.06, 0.0);
  water.max_m = Vec3d(0.06, 0.06, 0.2);
  water.celsius = 5.0;
  scene.blocks = {water};
  Container walls;
  walls.name = "basin";
  walls.size_m = Vec3d(0.12, 0.12, 0.4);
  scene.containers = {walls};
  return scene;
}

template <class Real>
double meanHeight(const Particles<Real>& particles) {
  double sum = 0.0;
  for (const Real z : particles.position.z) sum += double(z);
  return sum / double(particles.size());
}

template <class Real>
void run(Simulator<Real>& simulator, double seconds) {
  const double frames = seconds * simulator.scene().solver.frame_rate_hz;
  for (int frame = 0; frame < frames; ++frame) simulator.advanceFrame();
}

/// Heats every particle by `j_kg` within `seconds`, then runs as long again.
template <class Real>
void heatAll(Simulator<Real>& simulator, double j_kg, double seconds) {
  const Scene& scene = simulator.scene();
  const double mass = particleMass_kg(scene.fluid, scene.supportRadius_m());
  HeatedRegion all;
  all.shape = BlockShape::kBox;
  all.size_m = Vec3d::Constant(10.0);
  all.duration_s = seconds;
  all.power_w = j_kg * mass * double(simulator.particles().size()) / seconds;
  simulator.heatRegion(all);
  run(simulator, 2 * seconds);
}

/// From water at 5 degrees to ice at -5.
double freezing_j_kg(const ThermalParams& thermal) {
  return thermal.latent_heat_fusion_j_kg +
         5.0 * (thermal.water_specific_heat_j_kgk + thermal.ice_specific_heat_j_kgk);
}

TEST(IceInMotionTest, WaterInABasinSwellsByNinePercentAndShrinksBack) {
  Simulator<float> simulator(basin(), 1);
  run(simulator, 2.0);
  const double water = meanHeight(simulator.particles());
  const double heat_j_kg = freezing_j_kg(simulator.scene().thermal);
  heatAll(simulator, -heat_j_kg, 2.0);
  ASSERT_EQ(simulator.report().ice_particles, simulator.particles().size());
  const double ice = meanHeight(simulator.particles());
  EXPECT_NEAR(ice / water, 1 / 0.917, 0.01);
  heatAll(simulator, heat_j_kg, 2.0);
  ASSERT_EQ(simulator.report().ice_particles, 0u);
  run(simulator, 2.0);
  EXPECT_NEAR(meanHeight(simulator.particles()) / water, 1.0, 0.01);
}

TEST(IceInMotionTest, AHundredCyclesOfFrostAndThawLeaveEverythingAsItWas) {
  Scene scene = basin();
  scene.solver.substeps = 4;
  scene.blocks[0].max_m.z() = 0.1;
  Simulator<float> simulator(scene, 1);
  run(simulator, 2.0);
  const double height = meanHeight(simulator.particles());
  const StepReport before = simulator.report();
  const double heat_j_kg = freezing_j_kg(scene.thermal);
  for (int cycle = 0; cycle < test::repeats(100); ++cycle) {
    heatAll(simulator, -heat_j_kg, 0.5);
    ASSERT_EQ(simulator.report().ice_particles, before.particles) << cycle;
    EXPECT_EQ(simulator.report().ice_bodies, 1u) << cycle;
    heatAll(simulator, heat_j_kg, 0.5);
    ASSERT_EQ(simulator.report().ice_particles, 0u) << cycle;
    ASSERT_EQ(simulator.report().springs, 0u) << cycle;
  }
  run(simulator, 2.0);
  const StepReport& after = simulator.report();
  EXPECT_EQ(after.particles, before.particles);
  EXPECT_EQ(after.ice_bodies, 0u);
  EXPECT_NEAR(after.enthalpy_j / before.enthalpy_j, 1.0, 1e-9);
  EXPECT_NEAR(after.mean_celsius, before.mean_celsius, 1e-6);
  EXPECT_NEAR(meanHeight(simulator.particles()) / height, 1.0, 0.01);
  EXPECT_LT(after.kinetic_energy_j, 1e-4 * std::abs(before.potential_energy_j));
  EXPECT_EQ(after.non_finite, 0u);
  EXPECT_EQ(after.speed_limited, 0u);
}

}  // namespace ice_in_motion_test
}  // namespace ice_ice_baby
