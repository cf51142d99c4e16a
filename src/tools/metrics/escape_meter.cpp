#include "metrics/escape_meter.h"

#include <algorithm>

#include "colliders/colliders.h"
#include "spawn/spawn_points.h"

namespace ice_ice_baby {

/// Which particles begin in which closed collider.
class EscapeMeter::Enclosed {
 public:
  explicit Enclosed(const Scene& scene) : colliders_(scene, scene.fluid.spacing_m / 2) {
    const SpawnPoints points(scene);
    for (const MovingShape<double>& collider : colliders_) {
      if (!collider.shape.closed()) continue;
      Held held{{}, collider};
      std::size_t inside = 0;
      for (std::size_t block = 0; block < scene.blocks.size(); ++block) {
        points.forEach(block, [&](const Vec3d& x) {
          held.begins.push_back(collider.shape.holds(collider.placed.toLocal(x)));
          inside += held.begins.back();
        });
      }
      if (inside > 0) held_.push_back(std::move(held));
    }
  }

  std::size_t countEscaped(const Simulation& simulation,
                           const std::vector<ParticleSample>& particles) const {
    std::size_t escaped = 0;
    for (const Held& held : held_) {
      const Posed pose = simulation.colliderPose(held.collider.name);
      const auto out = [&](const ParticleSample& p) {
        if (p.id >= held.begins.size() || !held.begins[p.id]) return false;
        return !held.collider.shape.holds(pose.toLocal(Vec3d(p.x, p.y, p.z)));
      };
      escaped += static_cast<std::size_t>(std::count_if(particles.begin(), particles.end(), out));
    }
    return escaped;
  }

 private:
  struct Held {
    std::vector<bool> begins;  ///< (ids) whether a particle begins in the collider
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
