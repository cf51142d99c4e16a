// One projection of the coarse level: a column that stands on the floor does not fall.
#include "coarse/displacement_projection.h"

#include <gtest/gtest.h>

#include "fixtures.h"
#include "spawn/spawn_particles.h"

namespace ice_ice_baby {
namespace displacement_projection_test {

constexpr double kSpacing_m = 0.01;
constexpr double kSubstep_s = 1.0 / 300;

/// A column in a closed pipe that it fills, turned about the middle of its floor.
Scene column(const Vec3d& rpy_deg) {
  const Vec3d half(3 * kSpacing_m, 3 * kSpacing_m, 20 * kSpacing_m);
  const Vec3d up = poseOf(Vec3d::Zero(), rpy_deg).rotation * Vec3d::UnitZ();
  const Vec3d centre = half.z() * up;
  Scene scene;
  scene.fluid.spacing_m = kSpacing_m;
  scene.gravity_m_s2 = -9.81 * up;
  scene.blocks.push_back(test::blockOf(centre - half, centre + half));
  scene.blocks[0].rpy_deg = rpy_deg;
  scene.containers.push_back(test::tankOf(2 * half, true));
  scene.containers[0].rpy_deg = rpy_deg;
  return scene;
}

/// Largest displacement in the lower half of a column that was at rest, over that in free fall.
double fallOf(const Scene& scene) {
  std::vector<Spawn> spawns;
  Particles<double> water = spawnParticles<double>(scene, spawns);
  const Colliders<double> colliders(scene, kSpacing_m / 2);
  DisplacementProjection<double> projection(scene, colliders, nullptr);
  const std::vector<double> density(water.size(), 1.0);
  const Vec3d fall = kSubstep_s * kSubstep_s * scene.gravity_m_s2;
  for (int repeat = 0; repeat < 10; ++repeat) {  // each starts from the pressure of the last
    for (std::size_t i = 0; i < water.size(); ++i) {
      water.velocity.set(i, kSubstep_s * scene.gravity_m_s2);
      water.predicted.set(i, water.position.at(i) + fall);
    }
    projection.project(water, nullptr, density, scene.gravity_m_s2, kSubstep_s);
  }
  const double middle = scene.blocks[0].centre_m().dot(fall);
  double farthest_m = 0;
  for (std::size_t i = 0; i < water.size(); ++i) {
    if (water.position.at(i).dot(fall) < middle) continue;
    farthest_m = std::max(farthest_m, (water.predicted.at(i) - water.position.at(i)).norm());
  }
  return farthest_m / fall.norm();
}

TEST(DisplacementProjectionCoarseTest, WhatTheFloorHoldsIsNotPushedThroughIt) {
  EXPECT_LT(fallOf(column({0, 0, 0})), 0.01);
  EXPECT_LT(fallOf(column({30, 20, 10})), 0.01);
}

}  // namespace displacement_projection_test
}  // namespace ice_ice_baby
