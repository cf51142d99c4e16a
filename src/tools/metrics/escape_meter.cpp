#include "metrics/escape_meter.h"

#include <algorithm>
#include <cstdint>

#include "colliders/colliders.h"
#include "spawn/spawn_points.h"

namespace ice_ice_baby {

/// Which block spawned its particles in which collider.
class EscapeMeter::Enclosed {
 public:
  explicit Enclosed(const Scene& scene) : colliders_(scene, scene.fluid.spacing_m / 2) {
    const SpawnPoints points(scene);
    std::uint32_t first = 0;
    for (std::size_t block = 0; block < scene.blocks.size(); ++block) {
      std::uint32_t count = 0;
      points.forEach(block, [&](const Vec3d&) { ++count; });
      for (const MovingShape<double>& collider : colliders_) {
        if (collider.shape.closed()) hold(points, block, first, collider);
      }
      first += count;
    }
  }

  std::size_t countEscaped(const Simulation& simulation,
                           const std::vector<ParticleSample>& particles) const {
    std::size_t escaped = 0;
    for (const Held& held : held_) {
      const Posed pose = simulation.colliderPose(held.collider.name);
      const auto out = [&](const ParticleSample& p) {
        if (p.id < held.first_id || p.id >= held.last_id) return false;
        return !held.collider.shape.holds(pose.toLocal(Vec3d(p.x, p.y, p.z)));
      };
      escaped += static_cast<std::size_t>(std::count_if(particles.begin(), particles.end(), out));
    }
    return escaped;
  }

 private:
  /// Particles with consecutive ids in one collider.
  struct Held {
    std::uint32_t first_id, last_id;  ///< last_id is not among them
    const MovingShape<double>& collider;
  };

  /// Adds the particles of a block that begin in a collider. A carved block may have others too.
  /// @param id of its first particle
  void hold(const SpawnPoints& points, std::size_t block, std::uint32_t id,
            const MovingShape<double>& collider) {
    bool begun = false;
    points.forEach(block, [&](const Vec3d& x) {
      const bool inside = collider.shape.holds(collider.placed.toLocal(x));
      if (inside && !begun) held_.push_back({id, id, collider});
      begun = inside;
      ++id;
      if (inside) held_.back().last_id = id;
    });
  }

  Colliders<double> colliders_;
  std::vector<Held> held_;
};

EscapeMeter::EscapeMeter(const Scene& scene) : enclosed_(std::make_unique<Enclosed>(scene)) {}

EscapeMeter::~EscapeMeter() = default;

std::size_t EscapeMeter::count(const Simulation& simulation,
                               const std::vector<ParticleSample>& particles) const {
  return enclosed_->countEscaped(simulation, particles);
}

std::size_t countEscaped(const Simulation& simulation) {
  std::vector<ParticleSample> particles;
  simulation.sample(particles);
  return EscapeMeter(simulation.scene()).count(simulation, particles);
}

}  // namespace ice_ice_baby
