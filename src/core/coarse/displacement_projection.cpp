#include "coarse/displacement_projection.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/parallel.h"
#include "colliders/clearance.h"
#include "particles/kernels.h"

namespace ice_ice_baby {

namespace {

/// Largest rounding of positions, in displacements by gravity in a substep.
constexpr double kRounding_falls = 0.12;
/// Share of the displacement by gravity in a substep from which on a wall holds a particle.
constexpr double kHeld_falls = 0.25;

}  // namespace

template <class Real>
DisplacementProjection<Real>::DisplacementProjection(const Scene& scene,
                                                     const Colliders<Real>& colliders,
                                                     const Phases<Real>* phases)
    : colliders_(colliders),
      phases_(phases),
      spacing_(static_cast<Real>(scene.fluid.spacing_m)),
      particle_kg_(particleMass_kg(scene.fluid, scene.supportRadius_m())),
      grids_(scene, colliders) {}

template <class Real>
void DisplacementProjection<Real>::project(Particles<Real>& particles,
                                           const IceBodies<Real>* bodies,
                                           const std::vector<Real>& density,
                                           const Vec3<Real>& gravity, Real dt) {
  multiplier_.assign(particles.size(), Real(0));
  grids_.sort(particles.position, colliders_);
  active_.clear();
  if (!resolved(gravity.norm() * dt * dt)) return;
  free_volume_.update(grids_, colliders_);
  gather(particles, bodies, density, gravity, dt);
  hold(particles, gravity, dt);
  deposit();
  findActive(gravity.norm() * dt * dt / grids_.cell_m());
  mu_.reset(grids_.nodeCount(), grids_.nodePadding());
  guess_.reserve(grids_.nodeCount());
  if (!active_.empty()) {
    loadGuess();
    matrix_.assemble(grids_, passes_, sorted_, oblique_, active_);
    matrix_.addBodies(bodies, particles, particle_kg_, grids_, sorted_, place_, fill_);
    solver_.solve(matrix_, active_, excess_, mu_);
  }
  keepGuess();
  move(particles, dt);
  levelPressure(gravity, dt);
  if (bodies && !active_.empty()) levelBodies(particles, *bodies);
}

/// Whether positions are precise enough for the displacement by gravity in a substep: in single
/// precision up to 110 m from the origin with the default settings.
template <class Real>
bool DisplacementProjection<Real>::resolved(Real fall_m) const {
  Real farthest_m = 0;
  for (const CoarseGrid<Real>& grid : grids_.grids()) {
    if (grid.empty()) continue;
    const Vec3<Real> corner = grid.low.template cast<Real>().cwiseProduct(grid.region.cell_m);
    farthest_m =
        std::max(farthest_m, grid.region.frame.toWorld(corner).template lpNorm<Eigen::Infinity>());
  }
  const Real rounding_m = std::numeric_limits<Real>::epsilon() * farthest_m;
  return rounding_m <= static_cast<Real>(kRounding_falls) * fall_m;
}

/// Displacements of the sorted particles in the frames of their grids.
template <class Real>
void DisplacementProjection<Real>::gather(const Particles<Real>& particles,
                                          const IceBodies<Real>* bodies,
                                          const std::vector<Real>& density,
                                          const Vec3<Real>& gravity, Real dt) {
  const std::vector<Index>& order = grids_.order();
  const Real cell = grids_.cell_m();
  sorted_.resize(order.size());
  if (bodies) place_.assign(particles.size(), kNone);
  const VectorField<Real>& x = particles.position;
  parallelFor(order.size(), [&](std::size_t k) {
    const Index i = order[k];
    const CoarseGrid<Real>& grid = grids_.gridOf(i);
    const Vec3<Real> v = particles.velocity.at(i);
    const bool member = bodies && bodies->memberAt(i) != kNone;
    const Vec3<Real> flight =
        member ? Vec3<Real>(particles.predicted.at(i) - x.at(i)) : Vec3<Real>(dt * v);
    const Vec3<Real> step = grid.region.frame.rotation.transpose() * flight;
    const Vec3<Real> before = dt * (v - dt * gravity);
    const Real volume = phases_ ? phases_->relativeVolume()[i] : Real(1);
    sorted_.drift2[k] = before.squaredNorm() / (cell * cell);
    sorted_.volume[k] = volume;
    sorted_.density[k] = member ? Real(1) : density[i];
    sorted_.weight[k] = member ? Real(0) : volume * volume;
    if (bodies) place_[i] = Index(k);
    for (int axis = 0; axis < 3; ++axis) {
      const auto a = std::size_t(axis);
      sorted_.place[a][k] = grids_.placeOf(i, a);
      const Real ratio = cell / grid.region.cell_m[axis];
      sorted_.step[a][k] = step[axis] / grid.region.cell_m[axis];
      sorted_.free[a][k] = ratio * ratio;
    }
  });
}

/// Finds the particles that touch walls.
template <class Real>
void DisplacementProjection<Real>::findTouching(const VectorField<Real>& position) {
  touches_.assign(position.size(), false);
  pressed_.assign(position.size(), false);
  touching_.clear();
  if (colliders_.empty()) return;
  const Real margin = static_cast<Real>(kTouch_d) * spacing_;
  parallelForRanges(position.size(), [&](std::size_t first, std::size_t last) {
    forEachNear(colliders_, Paths<Real>{position, position}, margin, first, last,
                [&](std::size_t i) { touches_[i] = true; });
  });
  const std::vector<Index>& order = grids_.order();
  for (std::size_t k = 0; k < order.size(); ++k) {
    const Index i = order[k];
    if (!touches_[i]) continue;
    const bool water = sorted_.weight[k] != 0;  // ice has contacts of its own, steam none
    if (water) touching_.push_back(Index(k));
    pressed_[i] = !water;
    touches_[i] = water;
  }
}

/// Walls hold the particles that press on them.
template <class Real>
void DisplacementProjection<Real>::hold(const Particles<Real>& particles, const Vec3<Real>& gravity,
                                        Real dt) {
  findTouching(particles.position);
  const Real held_m = static_cast<Real>(kHeld_falls) * gravity.norm() * dt * dt;
  const std::vector<Index>& order = grids_.order();
  holds_.resize(touching_.size());
  parallelFor(touching_.size(), [&](std::size_t t) {
    const Index k = touching_[t], i = order[k];
    const CoarseRegion<Real>& region = grids_.gridOf(i).region;
    const Vec3<Real> step = region.frame.rotation.transpose() * (dt * particles.velocity.at(i));
    const Vec3<Real> from = particles.position.at(i);
    const Hold<Real> hold = holdAtWalls(colliders_, region.frame, spacing_, from, step, held_m);
    for (int axis = 0; axis < 3; ++axis) {
      const auto a = std::size_t(axis);
      sorted_.step[a][k] = hold.step[axis] / region.cell_m[axis];
      sorted_.free[a][k] *= hold.free[axis];
    }
    pressed_[i] = hold.oblique.count > 0 || hold.free != Vec3<Real>::Ones();
    holds_[t] = hold.oblique;
    holds_[t].sorted = k;
    if (hold.oblique.count > 0) sorted_.weight[k] = 0;
  });
  oblique_.clear();
  for (const ObliqueHold<Real>& hold : holds_) {
    if (hold.count > 0) oblique_.push_back(hold);
  }
  grids_.markSupported(pressed_);
}

/// Both lists ascend by node, and the key of a node does not depend on the boxes.
template <class Real>
void DisplacementProjection<Real>::loadGuess() {
  if (guess_.empty()) return;
  auto known = guess_.begin();
  for (const Index node : active_) {
    const std::uint64_t key = grids_.nodeKey(node);
    while (known != guess_.end() && known->key < key) ++known;
    if (known == guess_.end()) break;
    if (known->key == key) mu_[node] = known->mu;
  }
}

template <class Real>
void DisplacementProjection<Real>::keepGuess() {
  guess_.clear();
  for (const Index node : active_) {
    if (mu_[node] < 0) guess_.push_back({grids_.nodeKey(node), mu_[node]});
  }
}

template <class Real>
void DisplacementProjection<Real>::move(Particles<Real>& particles, Real dt) {
  if (active_.empty()) return;
  const std::size_t padded = grids_.order().size() + kCellPadding;
  for (std::vector<Real>& axis : moved_) axis.resize(padded);
  value_.assign(padded, Real(0));  // where nothing is pushed
  grids_.forEachCell([&](const CoarseGrid<Real>& grid, CellRange range, std::size_t lowest) {
    std::array<Real, kCellNodes> mu;
    bool pushed = false;
    for (std::size_t a = 0; a < kCellNodes; ++a) {
      mu[a] = mu_[std::size_t(std::ptrdiff_t(lowest) + grid.nodeOffset(a))];
      pushed = pushed || mu[a] != 0;
    }
    if (!pushed) return;
    passes_.interpolate(sorted_, range, mu.data(),
                        {moved_[0].data(), moved_[1].data(), moved_[2].data()}, value_.data());
    auto hold = firstHold(oblique_, range.first);
    for (std::size_t k = range.first; k < range.first + range.count; ++k) {
      const bool held = hold != oblique_.end() && hold->sorted == k;
      moveParticle(particles, grid.region, k, held ? &*hold : nullptr, dt);
      if (held) ++hold;
    }
  });
}

/// The push on a held particle without what would pull it off its walls.
/// @param flight its displacement in free flight, into those walls
template <class Real>
Vec3<Real> DisplacementProjection<Real>::withoutPull(Vec3<Real> push, const Vec3<Real>& flight,
                                                     std::size_t k,
                                                     const ObliqueHold<Real>* oblique) const {
  const auto keepInward = [&](const Vec3<Real>& normal) {
    const Real along = push.dot(normal);
    if (along * flight.dot(normal) < 0) push -= along * normal;
  };
  for (int axis = 0; axis < 3; ++axis) {
    if (sorted_.free[std::size_t(axis)][k] == 0) keepInward(Vec3<Real>::Unit(axis));
  }
  if (oblique) {
    for (int n = 0; n < oblique->count; ++n) keepInward(oblique->normal[std::size_t(n)]);
  }
  return push;
}

/// x*_k += v_k sum_a mu_a grad phi_a. At walls the collision response follows, so that friction
/// feels the pressure.
template <class Real>
void DisplacementProjection<Real>::moveParticle(Particles<Real>& particles,
                                                const CoarseRegion<Real>& region, std::size_t k,
                                                const ObliqueHold<Real>* oblique, Real dt) {
  const Index i = grids_.order()[k];
  const Real cell = grids_.cell_m();
  const Vec3<Real> slope(moved_[0][k], moved_[1][k], moved_[2][k]);
  const Vec3<Real> pushed = cell * cell * slope.cwiseQuotient(region.cell_m);
  multiplier_[i] = value_[k] * cell * cell;
  if (!touches_[i]) {
    particles.predicted.add(i, region.frame.rotation * pushed);
    return;
  }
  const Vec3<Real> flight = dt * particles.velocity.at(i);
  const Vec3<Real> from = particles.position.at(i);
  const Vec3<Real> inward =
      withoutPull(pushed, region.frame.rotation.transpose() * flight, k, oblique);
  const Vec3<Real> wanted = from + flight + region.frame.rotation * inward;
  const Vec3<Real> end = colliders_.respond(from, wanted, false);
  particles.predicted.add(i, (end - from) - flight);
}

template <class Real>
void DisplacementProjection<Real>::rescale(double ratio) {
  const auto square = static_cast<Real>(ratio * ratio);
  for (Guess& guess : guess_) guess.mu *= square;
  for (Real& value : multiplier_) value *= square;
}

template <class Real>
void DisplacementProjection<Real>::reorder(const std::vector<Index>& order) {
  if (multiplier_.size() < order.size()) multiplier_.resize(order.size());
  permute(multiplier_, order, scratch_);
}

template <class Real>
std::size_t DisplacementProjection<Real>::bytes() const {
  return grids_.bytes() + free_volume_.bytes() + sorted_.bytes() + matrix_.bytes() +
         solver_.bytes() + mu_.bytes() +
         (deposits_.capacity() + share_.capacity() + multiplier_.capacity() +
          4 * value_.capacity()) *
             sizeof(Real) +
         guess_.capacity() * sizeof(Guess);
}

template class DisplacementProjection<float>;
template class DisplacementProjection<double>;

}  // namespace ice_ice_baby
