#include "metrics/escape_meter.h"

#include <algorithm>
#include <cstdint>

#include "colliders/colliders.h"
#include "scene/lattice.h"

namespace ice_ice_baby {

/// Which block spawned its particles in which collider.
class EscapeMeter::Enclosed {
 public:
  explicit Enclosed(const Scene& scene) : colliders_(scene, scene.fluid.spacing_m / 2) {
    std::uint32_t first = 0;
    for (const Block& block : scene.blocks) {
      const double count = particleCount(block, scene.spacing_m(block), scene.limits.max_particles);
      const std::uint32_t last = first + static_cast<std::uint32_t>(count);
      for (const MovingShape<double>& collider : colliders_) {
        const Vec3d local = collider.placed.toLocal(block.centre_m());
        if (!collider.shape.closed() || !collider.shape.holds(local)) continue;
        held_.push_back({first, last, collider});
      }
      first = last;
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
  /// Particles of one block in one collider.
  struct Held {
    std::uint32_t first_id, last_id;  ///< last_id is not among them
    const MovingShape<double>& collider;
  };

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
