#include "promises.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "ice_ice_baby/errors.h"

namespace ice_ice_baby::fuzz {

namespace {

constexpr std::int64_t kMaxParticles = 300;
constexpr std::size_t kMaxColliders = 20;
constexpr int kMaxSweeps = 100;  ///< solver iterations of a frame
constexpr std::size_t kMaxMessage = 4000;

bool finite(const ParticleSample& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z) && std::isfinite(p.vx) &&
         std::isfinite(p.vy) && std::isfinite(p.vz) && std::isfinite(p.temperature_c) &&
         std::isfinite(p.ice_fraction) && std::isfinite(p.density);
}

}  // namespace

void requireReadable(const std::string& message) {
  if (message.empty()) throw Broken("a refusal without a word");
  if (message.size() > kMaxMessage) {
    throw Broken("a refusal of " + std::to_string(message.size()) + " characters");
  }
  const auto control = [](unsigned char c) { return c < 0x20 || c == 0x7f; };
  if (std::any_of(message.begin(), message.end(), control)) {
    throw Broken("a control character in the refusal: " + message);
  }
}

std::size_t particlesEver(const Simulation& simulation) {
  const StepReport& report = simulation.report();
  return report.particles + report.spilled + report.drained - report.poured;
}

void requireWhole(const Simulation& simulation, std::size_t particles) {
  std::vector<ParticleSample> samples;
  simulation.sample(samples);
  const bool counted = samples.size() == simulation.report().particles;
  if (!counted || particlesEver(simulation) != particles) {
    throw Broken(std::to_string(samples.size()) + " particles of " + std::to_string(particles));
  }
  const auto bad = std::find_if_not(samples.begin(), samples.end(), finite);
  if (bad != samples.end()) throw Broken("particle " + std::to_string(bad->id) + " is not finite");
}

bool isSmall(const Scene& scene, std::int64_t particles) {
  std::size_t colliders = 0;
  forEachColliderList(scene,
                      [&](const auto& list, const ColliderKind&) { colliders += list.size(); });
  return particles <= kMaxParticles && colliders <= kMaxColliders &&
         scene.substeps() * std::max(1, scene.solver.iterations) <= kMaxSweeps;
}

void runTwoFrames(Simulation& simulation) {
  const std::size_t particles = particlesEver(simulation);
  requireWhole(simulation, particles);
  for (int frame = 0; frame < 2; ++frame) {
    simulation.advanceFrame();
    requireWhole(simulation, particles);
  }
}

/// Tables of the distance from round solids take seconds with sanitizers if they are large.
void leaveOutLargeSurfaces(Scene& scene) {
  const double most_m = 10 * scene.fluid.spacing_m;
  const auto leaveOut = [&](auto& list, const auto& size_m) {
    list.erase(std::remove_if(list.begin(), list.end(),
                              [&](const auto& solid) { return size_m(solid) > most_m; }),
               list.end());
  };
  leaveOut(scene.cylinders, [](const Cylinder& c) { return c.radius_m + c.height_m; });
  leaveOut(scene.capsules, [](const Capsule& c) { return c.radius_m + c.length_m; });
  leaveOut(scene.cups, [](const Cup& c) { return c.radius_m + c.depth_m + c.wall_m; });
}

void runIfSmall(Scene scene) {
  if (!isSmall(scene, particleCount(scene))) return;
  leaveOutLargeSurfaces(scene);
  // Tables of the boundary density take a second with sanitizers; heat needs them for containers.
  scene.fluid.boundary_density = false;
  scene.limits.max_particles = std::min(scene.limits.max_particles, 2.0 * kMaxParticles);
  if (scene.thermal.enabled) scene.containers.clear();
  runTwoFrames(*makeSimulation(scene, Precision::kFloat, 1));
}

}  // namespace ice_ice_baby::fuzz
