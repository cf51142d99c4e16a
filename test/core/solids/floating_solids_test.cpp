// Floating solids against closed forms: Archimedes, stability, momentum, free motion.
#include <gtest/gtest.h>

#include <cmath>

#include "fixtures.h"
#include "scene/lattice.h"
#include "simulation/simulator.h"

namespace ice_ice_baby {
namespace floating_solids_test {

using test::blockOf;
using test::tankOf;

constexpr double kSpacing_m = 0.02;

Solid boxOf(const Vec3d& size_m, double density_kg_m3) {
  Solid solid;
  solid.name = "box";
  solid.size_m = size_m;
  solid.density_kg_m3 = density_kg_m3;
  return solid;
}

/// A tank with water up to `depth` spacings, `sides` spacings wide.
Scene poolOf(double sides, double depth) {
  Scene scene;
  scene.fluid.spacing_m = kSpacing_m;
  const double half_m = sides * kSpacing_m / 2, depth_m = depth * kSpacing_m;
  scene.containers.push_back(tankOf({2 * half_m, 2 * half_m, depth_m + 0.6}, true));
  scene.containers[0].friction = 0.0;
  scene.blocks.push_back(blockOf({-half_m, -half_m, 0}, {half_m, half_m, depth_m}));
  scene.blocks[0].carve = true;
  return scene;
}

std::unique_ptr<Simulation> ran(const Scene& scene, double seconds) {
  auto simulation = makeSimulation(scene, Precision::kFloat, 1);
  for (int k = 0; k < std::lround(60 * seconds); ++k) simulation->advanceFrame();
  return simulation;
}

double tilt_deg(const SolidState& state) {
  return std::acos(std::min(1.0, state.pose.rotation(2, 2))) * 180 / M_PI;
}

TEST(FloatingSolids, FallAndSpinFreelyAsInClosedForm) {
  Scene scene;
  scene.fluid.spacing_m = kSpacing_m;
  Solid ball;
  ball.name = "ball";
  ball.shape = SolidShape::kSphere;
  ball.radius_m = 0.05;
  ball.velocity_m_s = {1.0, -0.5, 2.0};
  ball.angular_velocity_rad_s = {3.0, 1.0, -2.0};
  scene.solids.push_back(ball);
  const auto simulation = ran(scene, 0.5);
  const SolidState state = simulation->solids().at(0);
  // Velocity first, then position: half a substep ahead of the parabola.
  const double dt_s = 1.0 / (60.0 * simulation->report().substeps);
  const Vec3d fallen = scene.gravity_m_s2 * (0.5 * (0.5 + dt_s) / 2);
  EXPECT_NEAR((state.pose.position - (0.5 * ball.velocity_m_s + fallen)).norm(), 0.0, 1e-5);
  EXPECT_NEAR((state.velocity_m_s - ball.velocity_m_s - 0.5 * scene.gravity_m_s2).norm(), 0.0,
              1e-5);
  EXPECT_NEAR((state.angular_velocity_rad_s - ball.angular_velocity_rad_s).norm(), 0.0, 1e-5);
  const Vec3d spun = 0.5 * ball.angular_velocity_rad_s;
  const Mat3<double> turned = Eigen::AngleAxisd(spun.norm(), spun.normalized()).matrix();
  EXPECT_NEAR((state.pose.rotation - turned).norm(), 0.0, 1e-4);
}

/// Momentum of everything, by the masses of the scene.
Vec3d momentumOf(const Simulation& simulation, double solid_kg) {
  std::vector<ParticleSample> samples;
  simulation.sample(samples);
  Vec3d sum = Vec3d::Zero();
  for (const ParticleSample& p : samples) {
    if (p.phase == Phase::kWater) sum += Vec3d(p.vx, p.vy, p.vz);
  }
  return sum * 1000.0 * std::pow(kSpacing_m, 3) + solid_kg * simulation.solids().at(0).velocity_m_s;
}

TEST(FloatingSolids, AHitOnWaterInFreeSpaceConservesMomentumAndAddsNoEnergy) {
  for (const double density_kg_m3 : {200.0, 2000.0}) {
    Scene scene;
    scene.fluid.spacing_m = kSpacing_m;
    scene.gravity_m_s2.setZero();
    scene.blocks.push_back(blockOf(Vec3d::Constant(-0.1), Vec3d::Constant(0.1)));
    Solid box = boxOf(Vec3d::Constant(0.1), density_kg_m3);
    box.position_m = {-0.17, 0.01, 0.02};
    box.velocity_m_s = {1.5, 0.0, 0.0};
    scene.solids.push_back(box);
    const double mass_kg = density_kg_m3 * 1e-3;
    const auto simulation = ran(scene, 0.0);
    const Vec3d before = momentumOf(*simulation, mass_kg);
    const double energy_j = simulation->report().kinetic_energy_j;
    EXPECT_NEAR(energy_j, mass_kg * 1.5 * 1.5 / 2, 1e-6);
    for (int k = 0; k < 20; ++k) {
      simulation->advanceFrame();
      EXPECT_LE(simulation->report().kinetic_energy_j, 1.001 * energy_j) << k;
    }
    EXPECT_LT(simulation->solids()[0].velocity_m_s.x(), 1.3) << "it hit the water";
    EXPECT_NEAR((momentumOf(*simulation, mass_kg) - before).norm() / before.norm(), 0.0, 1e-4);
  }
}

/// Draft of a box by the volumes, in spacings, less that of Archimedes.
double draftError_d(const Simulation& simulation) {
  const Scene& scene = simulation.scene();
  const Solid& box = scene.solids[0];
  const Vec3d room = scene.containers[0].size_m;
  const double area_m2 = room.x() * room.y(), base_m2 = box.size_m.x() * box.size_m.y();
  const double water_m3 =
      double(latticeCount(scene.blocks[0], kSpacing_m, 1e6)) * std::pow(kSpacing_m, 3);
  const double bottom_m = simulation.solids()[0].pose.position.z() - box.size_m.z() / 2;
  const double level_m = (water_m3 - base_m2 * bottom_m) / (area_m2 - base_m2);
  return (level_m - bottom_m - box.density_kg_m3 / 1000 * box.size_m.z()) / kSpacing_m;
}

/// A tilted box falls into a pool, so that it does not hang in the lattice of the water.
Scene boxInPool(const Vec3d& size_d, double density_kg_m3, const Vec3d& rpy_deg) {
  Scene scene = poolOf(18, 8);
  scene.blocks[0].carve = false;
  scene.solids.push_back(boxOf(kSpacing_m * size_d, density_kg_m3));
  const double reach_m = scene.solids[0].size_m.norm() / 2;
  scene.solids[0].position_m.z() = 8 * kSpacing_m + reach_m;
  scene.solids[0].rpy_deg = rpy_deg;
  return scene;
}

TEST(FloatingSolids, ABoxFloatsAsDeepAsItIsDense) {
  for (const double density_kg_m3 : {250.0, 750.0}) {
    const auto simulation = ran(boxInPool({8, 8, 4}, density_kg_m3, {12, 20, 0}), 4.0);
    EXPECT_LT(tilt_deg(simulation->solids()[0]), 3.0) << density_kg_m3;
    EXPECT_NEAR(draftError_d(*simulation), 0.0, 0.35) << density_kg_m3;
  }
}

/// Half as dense as water, a box is stable where width / height > sqrt(3 / 2) = 1.22.
TEST(FloatingSolids, ABoxFloatsUprightOrRollsOverAsItsMetacentreHasIt) {
  const auto flat = ran(boxInPool({8, 8, 5}, 500, {0, 12, 0}), 3.0);
  EXPECT_LT(tilt_deg(flat->solids()[0]), 4.0);
  const auto tall = ran(boxInPool({5, 5, 8}, 500, {0, 12, 0}), 3.0);
  EXPECT_GT(tilt_deg(tall->solids()[0]), 45.0);
}

/// The cup displaces 7.2 kg of water up to its rim and weighs 1.7 kg.
TEST(FloatingSolids, ABoatCarriesALoadAndSinksWhenItIsTooMuch) {
  for (const double load_kg : {1.5, 9.0}) {
    Scene scene = poolOf(20, 10);
    scene.blocks[0].carve = false;
    Solid cup;
    cup.name = "boat";
    cup.shape = SolidShape::kCup;
    cup.radius_m = 0.1;
    cup.height_m = 0.14;
    cup.wall_m = 0.02;
    cup.mass_kg = 1.7;
    cup.position_m = {0, 0, 0.23};
    Solid load = boxOf(Vec3d(0.1, 0.1, 0.06), 500);
    load.name = "load";
    load.mass_kg = load_kg;
    load.position_m = {0, 0, 0.275};
    scene.solids = {cup, load};
    const auto simulation = ran(scene, 3.0);
    const double rim_m = simulation->solids()[0].pose.position.z() + cup.height_m;
    const bool sinks = load_kg > 5.5;
    EXPECT_EQ(rim_m < 0.2, sinks) << "load of " << load_kg << " kg, rim at " << rim_m << " m";
    EXPECT_EQ(simulation->report().non_finite, 0u);
  }
}

}  // namespace floating_solids_test
}  // namespace ice_ice_baby
