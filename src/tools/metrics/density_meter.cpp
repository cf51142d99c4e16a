#include "metrics/density_meter.h"

#include <tbb/task_arena.h>

#include <algorithm>

#include "base/parallel.h"
#include "colliders/colliders.h"
#include "fluid/boundary_density.h"
#include "ice_ice_baby/each_collider.h"
#include "particles/kernels.h"
#include "particles/neighbours.h"

namespace ice_ice_baby {

namespace {

Scene withReferenceKernel(Scene scene) {
  scene.fluid.kernel = KernelPair::kCubic;
  scene.fluid.support_radius_m = 0.0;
  return scene;
}

/// Of densities relative to rest, summed in order.
DensityError densityError(const std::vector<float>& density) {
  DensityError error;
  for (const float relative : density) {
    const double excess = std::max(0.0, double(relative) - 1.0);
    error.mean += excess;
    error.max = std::max(error.max, excess);
    error.volume_lost += excess / (1.0 + excess);
  }
  if (density.empty()) return error;
  error.mean /= double(density.size());
  error.volume_lost /= double(density.size());
  return error;
}

}  // namespace

/// The kernel, and the colliders with what they add to the density near them.
class DensityMeter::Reference {
 public:
  Reference(const Scene& scene, int threads)
      : arena_(threads > 0 ? threads : tbb::task_arena::automatic),
        h_(static_cast<float>(2 * scene.fluid.spacing_m)),
        volume_m3_(1.0 / latticeSum(CubicSpline<double>(h_), scene.fluid.spacing_m, true)),
        colliders_(scene, scene.fluid.spacing_m / 2),
        boundary_(withReferenceKernel(scene), colliders_, volume_m3_) {
    forEachCollider(scene, [&](const Collider& c) { placed_.push_back({c.name, c.pose()}); });
  }

  /// Puts the colliders where the simulation has them.
  void follow(const Simulation& simulation) {
    bool moved = false;
    for (auto& [name, pose] : placed_) {
      const Posed now = simulation.colliderPose(name);
      if (now.position == pose.position && now.rotation == pose.rotation) continue;
      pose = now;
      colliders_.moveTo(name, now);
      moved = true;
    }
    if (!moved) return;
    colliders_.endFrame();
    colliders_.setSubstep(1.0, 1.0);
  }

  /// (n) rho / rho_0 in the order of the search; 0 for steam, which has no density to keep.
  /// @param volumes (n) of the particles over that of water
  std::vector<float> densities(const VectorField<float>& position,
                               const std::vector<float>& volumes) {
    std::vector<float> density(position.size());
    arena_.execute([&] {
      Neighbours<float> near(h_, 0);
      VectorField<float> sorted = position;
      std::vector<float> volume = volumes;
      const std::vector<Index> order = near.sortOrder(position);
      permute(sorted, order, density);
      permute(volume, order, density);
      near.build(sorted);
      parallelFor(sorted.size(), [&](std::size_t i) {
        density[i] = 0;
        if (volume[i] == 0) return;
        const Vec3<float> xi = sorted.at(i);
        float sum = volume[i] * kernel_.w(0);
        for (const Index j : near.of(i)) sum += volume[j] * kernel_.w((xi - sorted.at(j)).norm());
        density[i] = static_cast<float>(volume_m3_) * sum + boundary_.at(xi).value;
      });
    });
    return density;
  }

 private:
  struct Placed {
    std::string name;
    Posed pose;
  };

  tbb::task_arena arena_;
  float h_;
  CubicSpline<float> kernel_{h_};
  double volume_m3_;  ///< of a particle, by this kernel
  Colliders<float> colliders_;
  BoundaryDensity<float> boundary_;
  std::vector<Placed> placed_;
};

DensityMeter::DensityMeter(const Scene& scene, int threads)
    : reference_(std::make_unique<Reference>(scene, threads)) {}

DensityMeter::~DensityMeter() = default;

DensityError DensityMeter::measure(const Simulation& simulation,
                                   const std::vector<ParticleSample>& particles) {
  reference_->follow(simulation);
  simulation.sampleRelativeVolumes(volumes_);
  VectorField<float> position;
  position.resize(particles.size());
  for (std::size_t i = 0; i < particles.size(); ++i) {
    position.set(i, {particles[i].x, particles[i].y, particles[i].z});
  }
  return densityError(reference_->densities(position, volumes_));
}

DensityError measureDensityError(const Simulation& simulation) {
  std::vector<ParticleSample> particles;
  simulation.sample(particles);
  return DensityMeter(simulation.scene()).measure(simulation, particles);
}

}  // namespace ice_ice_baby
