#include "coarse/wall_pressure.h"

#include <algorithm>
#include <limits>

namespace ice_ice_baby {

namespace {

/// Parts of a cell along each axis between the walls of a container.
constexpr int kSlices = 4;
/// Steps in which a wall is found between two of them.
constexpr int kBisections = 6;

}  // namespace

/// A part of a cell along one axis, in cells from its start. The first of a cell is the last of the
/// cell before it.
template <class Real>
struct WallPressure<Real>::Slice {
  Real from, middle;
  bool inside;                 ///< between the walls of the container
  std::array<Real, 3> within;  ///< integrals of the splines over it

  Slice(Real begin, Real end, bool between)
      : from(begin),
        middle((begin + end) / 2),
        inside(between),
        within(splineIntegrals(begin, end)) {}
};

template <class Real>
struct WallPressure<Real>::Cell {
  const CoarseGrid<Real>* grid;
  Eigen::Vector3i at;  ///< coordinates in the region
  std::array<Real, kCellNodes> mu;
  std::array<std::vector<Slice>, 3> slices;

  Vec3<Real> toWorld(const Vec3<Real>& place) const {
    const CoarseRegion<Real>& region = grid->region;
    return region.frame.toWorld(region.cell_m.cwiseProduct(at.template cast<Real>() + place));
  }

  void slice(int axis) {
    std::vector<Slice>& list = slices[std::size_t(axis)];
    const bool walled = grid->region.collider != kNone;
    const Real high = grid->region.high_c[axis];
    list.clear();
    addSlices(at[axis] - 1, high, walled, list);
    Slice before = list.back();
    before.middle -= 1;
    list.assign(1, before);
    addSlices(at[axis], high, walled, list);
  }

 private:
  static void addSlices(int cell, Real high, bool walled, std::vector<Slice>& list) {
    const Real first = walled ? std::clamp(Real(-cell), Real(0), Real(1)) : Real(0);
    const Real last = walled ? std::clamp(high - Real(cell), first, Real(1)) : Real(1);
    if (first > 0) list.emplace_back(Real(0), first, false);
    const Real step = (last - first) / kSlices;
    for (int k = 0; k < kSlices && step > 0; ++k) {
      list.emplace_back(first + Real(k) * step, first + Real(k + 1) * step, true);
    }
    if (last < 1) list.emplace_back(last, Real(1), false);
  }
};

template <class Real>
void WallPressure<Real>::addLoads(std::vector<WallLoad<Real>>& loads) const {
  Cell cell;
  for (const CoarseGrid<Real>& grid : grids_.grids()) {
    if (grid.empty()) continue;
    for (int x = -2; x <= grid.cells.x() + 1; ++x) {
      for (int y = -2; y <= grid.cells.y() + 1; ++y) {
        for (int z = -2; z <= grid.cells.z() + 1; ++z) {
          if (!load(grid, {x, y, z}, cell) || !nearWall(cell)) continue;
          for (int axis = 0; axis < 3; ++axis) addFaces(cell, axis, loads);
        }
      }
    }
  }
}

/// @param at relative to the box of the grid
/// @return whether there is pressure in the cell
template <class Real>
bool WallPressure<Real>::load(const CoarseGrid<Real>& grid, const Eigen::Vector3i& at,
                              Cell& cell) const {
  bool pressed = false;
  for (std::size_t a = 0; a < kCellNodes; ++a) {
    const Eigen::Vector3i node = at + Eigen::Vector3i(int(a / 9), int(a / 3 % 3), int(a % 3));
    const bool within = (node.array() >= 0).all() && (node.array() < grid.nodes().array()).all();
    cell.mu[a] = within ? mu_[grid.lowestNode(node.x(), node.y(), node.z())] : Real(0);
    pressed = pressed || cell.mu[a] != 0;
  }
  if (!pressed) return false;
  cell.grid = &grid;
  cell.at = grid.low + at;
  for (int axis = 0; axis < 3; ++axis) cell.slice(axis);
  return true;
}

/// Whether a part of the cell, or of those before it, may be taken.
template <class Real>
bool WallPressure<Real>::nearWall(const Cell& cell) const {
  for (const auto& slices : cell.slices) {
    for (const Slice& slice : slices) {
      if (!slice.inside) return true;
    }
  }
  const Vec3<Real> middle = cell.toWorld(Vec3<Real>::Constant(Real(0.5)));
  const Real reach = Real(0.75) * cell.grid->region.cell_m.norm();
  if (takerOf(cell, Vec3<Real>::Constant(Real(0.5))) != kNone) return true;
  return std::any_of(colliders_.begin(), colliders_.end(), [&](const MovingShape<Real>& collider) {
    const Vec3<Real> local = collider.motion.from.toLocal(middle);
    return !collider.shape.clear(local, local, reach + collider.shape.particleRadius());
  });
}

/// Who takes the space at a place between the walls from the water of the grid; kNone: nobody.
template <class Real>
Index WallPressure<Real>::takerOf(const Cell& cell, const Vec3<Real>& place) const {
  const Vec3<Real> point = cell.toWorld(place);
  for (std::size_t c = 0; c < colliders_.count(); ++c) {
    const MovingShape<Real>& collider = colliders_[c];
    if (collider.shape.solid(collider.motion.from.toLocal(point))) return Index(c);
  }
  const CoarseGrid<Real>& there = grids_.grids()[grids_.regionAt(point, colliders_)];
  if (&there == cell.grid) return kNone;
  if (there.region.collider != kNone) return there.region.collider;
  // What is above the rim of an open container is free.
  const Index own = cell.grid->region.collider;
  const auto& collider = colliders_[own];
  const bool open = collider.shape.room().high.z() == std::numeric_limits<Real>::infinity();
  return open && collider.motion.from.toLocal(point).z() > 0 ? kNone : own;
}

/// Where the taker of the space changes along an axis, by bisection.
/// @param between two coordinates
/// @param last taker at the second
template <class Real>
Real WallPressure<Real>::crossing(const Cell& cell, Vec3<Real> place, int axis,
                                  std::array<Real, 2> between, Index last) const {
  for (int k = 0; k < kBisections; ++k) {
    place[axis] = (between[0] + between[1]) / 2;
    between[takerOf(cell, place) == last ? 1 : 0] = place[axis];
  }
  return (between[0] + between[1]) / 2;
}

/// Faces across one axis.
template <class Real>
void WallPressure<Real>::addFaces(const Cell& cell, int axis,
                                  std::vector<WallLoad<Real>>& loads) const {
  const int next = (axis + 1) % 3, last = (axis + 2) % 3;
  const auto& across = cell.slices[std::size_t(axis)];
  const auto& along = cell.slices[std::size_t(next)];
  const auto& beside = cell.slices[std::size_t(last)];
  const CoarseRegion<Real>& region = cell.grid->region;
  const Real cell_m = grids_.cell_m();
  const Real left = left_[std::size_t(cell.grid - grids_.grids().data())] / (cell_m * cell_m);
  const Real scale = static_cast<Real>(kCell_d * kCell_d * kCell_d) * region.cell_m.prod() /
                     (cell_m * region.cell_m[axis]);
  for (std::size_t j = 1; j < along.size(); ++j) {
    for (std::size_t k = 1; k < beside.size(); ++k) {
      if (!along[j].inside || !beside[k].inside) continue;
      Vec3<Real> place;
      place[next] = along[j].middle;
      place[last] = beside[k].middle;
      const auto taker = [&](const Slice& slice) {
        place[axis] = slice.middle;
        return slice.inside ? takerOf(cell, place) : region.collider;
      };
      Index before = taker(across[0]);
      for (std::size_t i = 1; i < across.size(); ++i) {
        const Index here = taker(across[i]);
        const Index collider = before != kNone ? before : here;
        const bool face = (before == kNone) != (here == kNone);
        before = here;
        if (!face) continue;
        const Slice &near = across[i - 1], &far = across[i];
        const bool exact = !near.inside || !far.inside;
        const Real at =
            exact ? far.from : crossing(cell, place, axis, {near.middle, far.middle}, here);
        const std::array<Real, 3> at_face = SplineAlong<Real>(at).value;
        Real sum = 0, area = 0;
        for (std::size_t a = 0; a < kCellNodes; ++a) {
          const std::array<std::size_t, 3> node{a / 9, a / 3 % 3, a % 3};
          const Real spline = at_face[node[std::size_t(axis)]] *
                              along[j].within[node[std::size_t(next)]] *
                              beside[k].within[node[std::size_t(last)]];
          area += spline;
          sum += cell.mu[a] * spline;
        }
        sum = std::min(Real(0), sum - area * left);
        place[axis] = at;
        const Real push = (here == kNone ? scale : -scale) * sum;
        loads.push_back({collider, cell.toWorld(place), push * region.frame.rotation.col(axis)});
      }
    }
  }
}

template class WallPressure<float>;
template class WallPressure<double>;

}  // namespace ice_ice_baby
