// Floating solids of PhaseChange.
#include "simulation/phase_change.h"
#include "solids/solid_points.h"

namespace ice_ice_baby {

/// The particles are sorted by cell now, and so are their phases; ids are those of the spawn.
template <class Real>
void PhaseChange<Real>::makeSolids(const Particles<Real>& particles,
                                   const Neighbours<Real>& neighbours,
                                   const std::vector<Spawn>& spawns) {
  const std::vector<Index> places = placesById(particles.id);
  std::vector<Vec3d> point_m(particles.size());
  body_labels_.assign(particles.size(), kNone);
  for (std::size_t k = 0; k < scene_.solids.size(); ++k) {
    std::uint32_t id = spawns[scene_.blocks.size() + k].first_id;
    const Index label = places[id];
    forEachSolidPoint(scene_.solids[k], scene_.fluid.spacing_m, [&](const Vec3d& point) {
      point_m[places[id]] = point;
      body_labels_[places[id++]] = label;
    });
  }
  makeBodies();
  bodies_->assign(particles, neighbours, body_labels_);
  for (std::size_t k = 0; k < scene_.solids.size(); ++k) {
    const Index body = bodies_->bodyOf(places[spawns[scene_.blocks.size() + k].first_id]);
    bodies_->makeSolid(body, Index(k), scene_.solids[k], point_m);
  }
}

template <class Real>
void PhaseChange<Real>::grip(Index solid, const Posed& pose) {
  bodies_->grip(bodies_->bodyOfSolid(solid), pose, 1.0 / scene_.solver.frame_rate_hz);
}

template <class Real>
void PhaseChange<Real>::keepWhole(std::vector<char>& gone) const {
  if (bodies_) bodies_->keepWhole(gone);
}

template class PhaseChange<float>;
template class PhaseChange<double>;

}  // namespace ice_ice_baby
