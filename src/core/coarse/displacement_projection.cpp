#include "coarse/displacement_projection.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/parallel.h"
#include "colliders/clearance.h"
#include "particles/kernels.h"

namespace ice_ice_baby {

namespace {

/// Water inside, and at the surface, may be this much less dense than at rest and still counts as
/// full.
constexpr double kSlack = 0.001, kSurfaceSlack = 0.02;
/// Slow water inside that is denser than this gives way, by this share in a substep.
constexpr double kDense = 0.0002, kRelief = 0.1;
/// At the surface a node counts as full with this much room left: fast and slow water.
constexpr double kFastMargin = 0.05, kSlowMargin = 0.20;
/// A node lies inside if all nodes around it are filled to this share.
constexpr double kInside = 0.7;
/// Largest rounding of positions, in displacements by gravity in a substep.
constexpr double kRounding_falls = 0.1;
/// A particle is at the surface if less than this share of its surroundings is filled, and if its
/// pressure is that of fewer layers.
constexpr double kAtSurface = 0.65, kSurfaceLayers = 5.0;
/// A node is fast beyond this many displacements by gravity in a substep.
constexpr double kFast_falls = 3.0;
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
}

/// Whether positions are precise enough for the displacement by gravity in a substep: in single
/// precision up to 60 m from the origin with the default settings.
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
  const Real held_m = static_cast<Real>(kHeld_falls) * gravity.norm() * dt * dt;
  sorted_.resize(order.size());
  touches_.assign(particles.size(), false);
  if (bodies) place_.assign(particles.size(), kNone);
  const VectorField<Real>& x = particles.position;
  if (!colliders_.empty()) {
    const Real margin = static_cast<Real>(kTouch_d) * spacing_;
    parallelForRanges(particles.size(), [&](std::size_t first, std::size_t last) {
      forEachNear(colliders_, Paths<Real>{x, x}, margin, first, last,
                  [&](std::size_t i) { touches_[i] = true; });
    });
  }
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
  oblique_.clear();
  pressed_.assign(particles.size(), false);
  for (std::size_t k = 0; k < order.size(); ++k) {
    const Index i = order[k];
    if (!touches_[i]) continue;
    if (sorted_.weight[k] == 0) {  // ice, whose contacts are its own, or steam
      pressed_[i] = true;
      touches_[i] = false;
      continue;
    }
    const CoarseRegion<Real>& region = grids_.gridOf(i).region;
    const Vec3<Real> step = region.frame.rotation.transpose() * (dt * particles.velocity.at(i));
    Hold<Real> hold = holdAtWalls(colliders_, region.frame, spacing_, x.at(i), step, held_m);
    for (int axis = 0; axis < 3; ++axis) {
      const auto a = std::size_t(axis);
      sorted_.step[a][k] = hold.step[axis] / region.cell_m[axis];
      sorted_.free[a][k] *= hold.free[axis];
    }
    pressed_[i] = hold.oblique.count > 0 || hold.free != Vec3<Real>::Ones();
    if (hold.oblique.count == 0) continue;
    hold.oblique.sorted = Index(k);
    oblique_.push_back(hold.oblique);
    sorted_.weight[k] = 0;
  }
  grids_.markSupported(pressed_);
}

template <class Real>
void DisplacementProjection<Real>::deposit() {
  deposits_.assign(grids_.nodeCount() * kDeposits, Real(0));
  grids_.forEachCell([&](const CoarseGrid<Real>& grid, CellRange cell, std::size_t lowest) {
    std::array<Real, kCellNodes * kDeposits> sums;
    passes_.deposit(sorted_, cell, sums.data());
    for (std::size_t a = 0; a < kCellNodes; ++a) {
      Real* out =
          deposits_.data() + std::size_t(std::ptrdiff_t(lowest) + grid.nodeOffset(a)) * kDeposits;
      for (std::size_t k = 0; k < kDeposits; ++k) out[k] += sums[a * kDeposits + k];
    }
  });
}

/// Nodes that are full, or that this substep would overfill.
/// @param fall displacement by gravity in a substep, cells
template <class Real>
void DisplacementProjection<Real>::findActive(Real fall) {
  active_.clear();
  excess_.clear();
  fill_.clear();
  active_.reserve(grids_.nodeCount());
  excess_.reserve(grids_.nodeCount());
  fill_.reserve(grids_.nodeCount());
  const std::vector<Real>& rest = free_volume_.atNodes();
  const Real fast = static_cast<Real>(kFast_falls) * fall;
  for (std::size_t node = 0; node < grids_.nodeCount(); ++node) {
    const Real flow = deposits_[node * kDeposits], fill = deposits_[node * kDeposits + 1];
    if (!(fill > 0)) continue;
    const Real speed = std::sqrt(deposits_[node * kDeposits + 2] / fill);
    const Real calm = fast > 0 ? std::clamp(2 - speed / fast, Real(0), Real(1)) : Real(0);
    const bool inside = interior(node);
    if (!inside && calm == 0) continue;
    const Real margin =
        static_cast<Real>(kFastMargin) + static_cast<Real>(kSlowMargin - kFastMargin) * calm;
    const Real density = deposits_[node * kDeposits + 3];
    const Real loose = (1 - static_cast<Real>(inside ? kSlack : kSurfaceSlack)) * fill - density;
    const Real room = inside ? loose : std::max(loose, (1 - margin) * rest[node] - fill);
    const Real dense = inside ? density - static_cast<Real>(1 + kDense) * fill : Real(0);
    const Real relief = static_cast<Real>(kRelief) * calm * std::max(Real(0), dense);
    const Real b = std::max(Real(0), room) - flow - relief;
    if (room > 0 && b >= 0) continue;
    active_.push_back(Index(node));
    excess_.push_back(b);
    fill_.push_back(fill);
  }
}

/// Whether all 26 nodes around a node are filled.
template <class Real>
bool DisplacementProjection<Real>::interior(std::size_t node) const {
  const CoarseGrid<Real>& grid = grids_.gridOfNode(node);
  const std::vector<Real>& rest = free_volume_.atNodes();
  const auto full = [&](std::ptrdiff_t offset) {
    const std::ptrdiff_t other = std::ptrdiff_t(node) + offset;
    if (other < 0 || other >= std::ptrdiff_t(rest.size())) return false;
    return deposits_[std::size_t(other) * kDeposits + 1] >=
           static_cast<Real>(kInside) * rest[std::size_t(other)];
  };
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      for (int z = -1; z <= 1; ++z) {
        if (!full(x * grid.strideX() + y * grid.strideY() + z)) return false;
      }
    }
  }
  return true;
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
  value_.resize(padded);
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

/// The splines of a grid end somewhere in its cells and not at the surface of the water, where the
/// pressure is that of half a layer. What is left there in the mean is taken off all the water of
/// the grid, if it is slow; forces do not change.
template <class Real>
void DisplacementProjection<Real>::levelPressure(const Vec3<Real>& gravity, Real dt) {
  if (active_.empty()) return;
  const std::vector<Index>& order = grids_.order();
  const CoarseGrid<Real>* first = grids_.grids().data();
  const Real layer = spacing_ * gravity.norm() * dt * dt;
  const Real fast = static_cast<Real>(2 * kFast_falls) * layer / (spacing_ * grids_.cell_m());
  const Real fast2 = fast * fast;
  surface_.assign(grids_.grids().size(), {0.0, 0.0});
  for (std::size_t k = 0; k < order.size(); ++k) {
    const Real value = multiplier_[order[k]];
    const bool candidate = value != 0 && -value <= static_cast<Real>(kSurfaceLayers) * layer &&
                           sorted_.drift2[k] <= fast2;
    if (!candidate || !atSurface(k)) continue;
    auto& [sum, count] = surface_[std::size_t(&grids_.gridOf(order[k]) - first)];
    sum += double(value);
    count += 1.0;
  }
  parallelFor(order.size(), [&](std::size_t k) {
    const Index i = order[k];
    const auto [sum, count] = surface_[std::size_t(&grids_.gridOf(i) - first)];
    if (count == 0.0 || multiplier_[i] == 0) return;
    const double excess = std::min(0.0, sum / count + double(layer) / 2);
    multiplier_[i] = std::min(Real(0), multiplier_[i] - static_cast<Real>(excess));
  });
}

/// Whether a third of the surroundings of particle k of the order, as its nodes see them, is empty.
template <class Real>
bool DisplacementProjection<Real>::atSurface(std::size_t k) const {
  const Index i = grids_.order()[k];
  const CoarseGrid<Real>& grid = grids_.gridOf(i);
  const std::size_t lowest = grids_.lowestNodeOf(i);
  const SplineAt<Real> spline(sorted_, k);
  Real filled = 0;
  for (std::size_t a = 0; a < kCellNodes; ++a) {
    const std::size_t node = std::size_t(std::ptrdiff_t(lowest) + grid.nodeOffset(a));
    const Real rest = free_volume_.atNodes()[node], fill = deposits_[node * kDeposits + 1];
    const Real share = rest > 0 ? std::min(Real(1), fill / rest) : Real(1);
    filled += share * spline.value(a);
  }
  return filled < static_cast<Real>(kAtSurface);
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
         (deposits_.capacity() + multiplier_.capacity() + 4 * value_.capacity()) * sizeof(Real) +
         guess_.capacity() * sizeof(Guess);
}

template class DisplacementProjection<float>;
template class DisplacementProjection<double>;

}  // namespace ice_ice_baby
