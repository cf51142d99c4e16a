#include "coarse/displacement_projection.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "colliders/clearance.h"
#include "particles/kernels.h"

namespace ice_ice_baby {

namespace {

/// Room that is left at a node: fast water is less ordered than a lattice and needs more of it.
constexpr double kLeastMargin = 0.05, kMostMargin = 0.20;
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
template <class Visit>
void DisplacementProjection<Real>::forEachCell(const Visit& visit) {
  for (int colour = 0; colour < CoarseGrids<Real>::kColours; ++colour) {
    const std::vector<CellPlane>& planes = grids_.planes(colour);
    parallelFor(
        planes.size(),
        [&](std::size_t k) {
          const CoarseGrid<Real>& grid = grids_.grids()[planes[k].grid];
          for (int y = 0; y < grid.cells.y(); ++y) {
            for (int z = 0; z < grid.cells.z(); ++z) {
              const CellRange cell = grids_.particlesIn(grid.cell(planes[k].x, y, z));
              if (cell.count > 0) visit(grid, cell, grid.lowestNode(planes[k].x, y, z));
            }
          }
        },
        1);
  }
}

template <class Real>
void DisplacementProjection<Real>::project(Particles<Real>& particles,
                                           const IceBodies<Real>* bodies, const Vec3<Real>& gravity,
                                           Real dt) {
  multiplier_.assign(particles.size(), Real(0));
  grids_.sort(particles.position, colliders_);
  free_volume_.update(grids_, colliders_);
  gather(particles, bodies, gravity, dt);
  deposit();
  findActive(gravity.norm() * dt * dt / grids_.cell_m());
  mu_.reset(grids_.nodeCount(), grids_.nodePadding());
  if (!active_.empty()) {
    loadGuess();
    matrix_.assemble(grids_, passes_, sorted_, oblique_, active_);
    matrix_.addBodies(bodies, particles, particle_kg_, grids_, sorted_, place_, fill_);
    solver_.solve(matrix_, active_, excess_, mu_);
    iterations_ += std::uint64_t(solver_.iterations());
    ++solves_;
  }
  keepGuess();
  move(particles, dt);
}

/// Displacements of the sorted particles in the frames of their grids.
template <class Real>
void DisplacementProjection<Real>::gather(const Particles<Real>& particles,
                                          const IceBodies<Real>* bodies,
                                          const Vec3<Real>& gravity, Real dt) {
  const std::vector<Index>& order = grids_.order();
  const Real cell = grids_.cell_m();
  const Real held_m = static_cast<Real>(kHeld_falls) * gravity.norm() * dt * dt;
  sorted_.resize(order.size());
  held_.assign(particles.size(), false);
  if (bodies) place_.assign(particles.size(), kNone);
  const VectorField<Real>& x = particles.position;
  if (!colliders_.empty()) {
    const Real margin = static_cast<Real>(0.01) * spacing_;
    parallelForRanges(particles.size(), [&](std::size_t first, std::size_t last) {
      forEachNear(colliders_, Paths<Real>{x, x}, margin, first, last,
                  [&](std::size_t i) { held_[i] = true; });
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
    sorted_.weight[k] = member ? Real(0) : volume * volume;
    if (bodies) place_[i] = Index(k);
    if (member) held_[i] = false;
    for (int axis = 0; axis < 3; ++axis) {
      const auto a = std::size_t(axis);
      sorted_.place[a][k] = grids_.placeOf(i, a);
      const Real ratio = cell / grid.region.cell_m[axis];
      sorted_.step[a][k] = step[axis] / grid.region.cell_m[axis];
      sorted_.free[a][k] = ratio * ratio;
    }
  });
  oblique_.clear();
  if (colliders_.empty()) return;
  for (std::size_t k = 0; k < order.size(); ++k) {
    const Index i = order[k];
    if (!held_[i]) continue;
    const CoarseGrid<Real>& grid = grids_.gridOf(i);
    const Vec3<Real> step =
        grid.region.frame.rotation.transpose() * (dt * particles.velocity.at(i));
    Hold<Real> hold =
        holdAtWalls(colliders_, grid.region.frame, spacing_, x.at(i), step, held_m);
    for (int axis = 0; axis < 3; ++axis) {
      const auto a = std::size_t(axis);
      sorted_.step[a][k] = hold.step[axis] / grid.region.cell_m[axis];
      sorted_.free[a][k] *= hold.free[axis];
    }
    if (hold.oblique.count == 0) continue;
    hold.oblique.sorted = Index(k);
    oblique_.push_back(hold.oblique);
    sorted_.weight[k] = 0;
  }
}

template <class Real>
void DisplacementProjection<Real>::deposit() {
  deposits_.assign(grids_.nodeCount() * kDeposits, Real(0));
  forEachCell([&](const CoarseGrid<Real>& grid, CellRange cell, std::size_t lowest) {
    std::array<Real, kCellNodes * kDeposits> sums;
    passes_.deposit(sorted_, cell, sums.data());
    for (std::size_t a = 0; a < kCellNodes; ++a) {
      Real* out = deposits_.data() +
                  std::size_t(std::ptrdiff_t(lowest) + grid.nodeOffset(a)) * kDeposits;
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
  const std::vector<Real>& rest = free_volume_.atNodes();
  const Real fast = static_cast<Real>(kFast_falls) * fall;
  for (std::size_t node = 0; node < grids_.nodeCount(); ++node) {
    const Real flow = deposits_[node * kDeposits], fill = deposits_[node * kDeposits + 1];
    if (!(fill > 0)) continue;
    const Real speed = std::sqrt(deposits_[node * kDeposits + 2] / fill);
    const Real calm = fast > 0 ? std::clamp(2 - speed / fast, Real(0), Real(1)) : Real(0);
    const Real margin = static_cast<Real>(kLeastMargin) +
                        static_cast<Real>(kMostMargin - kLeastMargin) * calm;
    const Real room = std::max(Real(0), (1 - margin) * rest[node] - fill);
    const Real b = room - flow;
    if (room > 0 && b >= 0) continue;
    active_.push_back(Index(node));
    excess_.push_back(b);
    fill_.push_back(fill);
  }
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
  const std::vector<Index>& order = grids_.order();
  const Real cell = grids_.cell_m();
  for (std::vector<Real>& axis : moved_) axis.assign(order.size() + kCellPadding, Real(0));
  value_.assign(order.size() + kCellPadding, Real(0));
  if (!active_.empty()) {
    forEachCell([&](const CoarseGrid<Real>& grid, CellRange range, std::size_t lowest) {
      std::array<Real, kCellNodes> mu;
      bool pushed = false;
      for (std::size_t a = 0; a < kCellNodes; ++a) {
        mu[a] = mu_[std::size_t(std::ptrdiff_t(lowest) + grid.nodeOffset(a))];
        pushed = pushed || mu[a] != 0;
      }
      if (!pushed) return;
      passes_.interpolate(sorted_, range, mu.data(),
                          {moved_[0].data(), moved_[1].data(), moved_[2].data()}, value_.data());
    });
  }
  for (const ObliqueHold<Real>& hold : oblique_) {
    const std::size_t k = hold.sorted;
    Vec3<Real> scale, moved;
    for (int axis = 0; axis < 3; ++axis) {
      scale[axis] = std::sqrt(sorted_.free[std::size_t(axis)][k]);
      moved[axis] = moved_[std::size_t(axis)][k] / scale[axis];
    }
    moved = hold.project(moved).cwiseProduct(scale);
    for (int axis = 0; axis < 3; ++axis) moved_[std::size_t(axis)][k] = moved[axis];
  }
  parallelFor(order.size(), [&](std::size_t k) {
    const Index i = order[k];
    const CoarseGrid<Real>& grid = grids_.gridOf(i);
    multiplier_[i] = value_[k] * cell * cell;
    const Vec3<Real>& cell_m = grid.region.cell_m;
    Vec3<Real> change = cell_m.cwiseProduct(Vec3<Real>(moved_[0][k], moved_[1][k], moved_[2][k]));
    if (held_[i]) {
      const Vec3<Real> flight =
          grid.region.frame.rotation.transpose() * (dt * particles.velocity.at(i));
      const Vec3<Real> step(sorted_.step[0][k], sorted_.step[1][k], sorted_.step[2][k]);
      change += cell_m.cwiseProduct(step) - flight;
    }
    particles.predicted.add(i, grid.region.frame.rotation * change);
  });
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
