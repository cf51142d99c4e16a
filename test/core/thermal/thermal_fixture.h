// The thermal solver alone, on particles that do not move.
#pragma once

#include <tbb/task_arena.h>

#include <algorithm>
#include <memory>

#include "fixtures.h"
#include "spawn/spawn_particles.h"
#include "thermal/thermal_solver.h"

namespace ice_ice_baby::test {

/// Neighbour lists have a skin, as in the simulation.
template <class Real>
struct StillHeat {
  explicit StillHeat(const Scene& s)
      : scene(s),
        colliders(scene, scene.fluid.spacing_m / 2),
        particles(spawnParticles<Real>(scene, spawns)),
        neighbours(static_cast<Real>(scene.supportRadius_m()),
                   static_cast<Real>(0.3 * scene.fluid.spacing_m)),
        heat(scene, colliders) {
    for (std::size_t k = 0; k < spawns.size(); ++k) {
      heat.add(spawns[k].count, scene.blocks[k].celsius);
    }
    const auto& order = neighbours.sortOrder(particles.predicted);
    particles.reorder(order);
    heat.reorder(order);
    neighbours.build(particles.predicted);
  }

  /// Advances by a time of heat, which speedup divides, in frames of a sixtieth of a second.
  void run(double heat_s, double air_c = 20.0) {
    const double frame_s = scene.thermal.speedup / 60;
    const int frames = std::max(1, int(std::ceil(heat_s / frame_s - 1e-9)));
    ThermalStep<Real> step;
    step.dt_s = heat_s / frames / scene.thermal.speedup;
    step.air_c = air_c;
    for (int k = 0; k < frames; ++k) heat.advance(particles, neighbours, step);
  }

  Scene scene;
  std::vector<Spawn> spawns;
  Colliders<Real> colliders;
  Particles<Real> particles;
  Neighbours<Real> neighbours;
  ThermalSolver<Real> heat;
};

/// Cube of n^3 particles, 2 cm apart, that exchanges no heat with the air.
inline Scene warmCube(int n, double celsius) {
  Scene scene;
  scene.fluid.spacing_m = 0.02;
  scene.thermal.enabled = true;
  scene.thermal.air_heat_transfer_w_m2k = 0.0;
  scene.blocks.push_back(blockOf(Vec3d::Zero(), Vec3d::Constant(0.02 * n)));
  scene.blocks[0].celsius = celsius;
  return scene;
}

/// A column of `across` x `across` x `layers` particles on the plane z = 0, which has a
/// temperature. The walls around it are insulated, so heat flows along z only.
inline Scene coldColumn(int across, int layers, double spacing_m, double wall_c) {
  Scene scene;
  scene.fluid.spacing_m = spacing_m;
  scene.thermal.enabled = true;
  scene.thermal.air_heat_transfer_w_m2k = 0.0;
  const double half = across * spacing_m / 2;
  const double depth = 10 * spacing_m;  // so that the floor of the walls is out of reach
  scene.blocks.push_back(blockOf({-half, -half, 0}, {half, half, layers * spacing_m}));
  scene.containers.push_back(
      tankOf({2 * half, 2 * half, depth + (layers + 10) * spacing_m}, false));
  scene.containers[0].position_m.z() = -depth;
  scene.planes.emplace_back();
  scene.planes[0].name = "plate";
  scene.planes[0].heat = ThermalBoundary::kTemperature;
  scene.planes[0].celsius = wall_c;
  return scene;
}

}  // namespace ice_ice_baby::test
