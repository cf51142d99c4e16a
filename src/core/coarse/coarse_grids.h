// The grids of the coarse level: cells of three spacings, in the frame of each container and of the
// world, and which particle lies in which cell.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/parallel.h"
#include "coarse/cell_passes.h"
#include "colliders/colliders.h"
#include "particles/particles.h"

namespace ice_ice_baby {

/// Edge of a cell, in spacings.
constexpr double kCell_d = 3.0;

/// Where water is, as far as the coarse level is concerned: in a container, or outside of all.
template <class Real>
struct CoarseRegion {
  Index collider;     ///< its number; kNone: outside of all containers
  Pose<Real> frame;   ///< of the grid: its origin is a corner of a cell
  Vec3<Real> cell_m;  ///< sides of a cell, such that opposite walls of a container are aligned
  Vec3<Real> high_c;  ///< of a container with flat walls: its inner size, cells; else infinite
};

/// A box of cells in one region. Nodes lie in the middle of cells, in the box and one cell around.
template <class Real>
struct CoarseGrid {
  CoarseRegion<Real> region;
  Eigen::Vector3i low = Eigen::Vector3i::Zero();    ///< coordinates of the first cell
  Eigen::Vector3i cells = Eigen::Vector3i::Zero();  ///< along each axis
  std::size_t first_cell = 0;
  std::size_t first_node = 0;

  bool empty() const { return cells.x() == 0; }
  std::size_t count() const {
    return std::size_t(cells.x()) * std::size_t(cells.y()) * std::size_t(cells.z());
  }
  Eigen::Vector3i nodes() const { return cells + Eigen::Vector3i::Constant(2); }
  /// Distance of the numbers of two nodes that are neighbours along x and y; along z it is 1.
  std::ptrdiff_t strideX() const { return std::ptrdiff_t(nodes().y()) * nodes().z(); }
  std::ptrdiff_t strideY() const { return nodes().z(); }
  std::size_t nodeCount() const { return std::size_t(strideX()) * std::size_t(nodes().x()); }
  std::size_t cell(int x, int y, int z) const {
    return first_cell +
           (std::size_t(x) * std::size_t(cells.y()) + std::size_t(y)) * std::size_t(cells.z()) +
           std::size_t(z);
  }
  /// The lowest of the 27 nodes of a cell.
  std::size_t lowestNode(int x, int y, int z) const {
    return first_node + std::size_t(x * strideX() + y * strideY() + z);
  }
  /// Number of node k of a cell, k < kCellNodes, relative to its lowest.
  std::ptrdiff_t nodeOffset(std::size_t k) const {
    return std::ptrdiff_t(k / 9) * strideX() + std::ptrdiff_t(k / 3 % 3) * strideY() +
           std::ptrdiff_t(k % 3);
  }
};

/// A plane of cells of one grid at one x. Planes whose x differs by 3 share no node.
struct CellPlane {
  Index grid;
  int x;
};

template <class Real>
class CoarseGrids {
 public:
  CoarseGrids(const Scene& scene, const Colliders<Real>& colliders);

  /// Sorts the particles by cell. The boxes are those that just hold the water, and cover at most
  /// about one cell per particle: water far away from the rest has no coarse level.
  void sort(const VectorField<Real>& position, const Colliders<Real>& colliders);

  /// Region of a point: the smallest container that holds it, or the world. An index of grids().
  std::size_t regionAt(const Vec3<Real>& point, const Colliders<Real>& colliders) const;

  const std::vector<CoarseGrid<Real>>& grids() const { return grids_; }
  /// (sorted) index of each particle that lies in a cell.
  const std::vector<Index>& order() const { return order_; }
  /// Calls visit(grid, particles, lowest node) for every cell that holds particles, on all threads:
  /// cells that share a node one after the other, and in the same order for any number of threads.
  template <class Visit>
  void forEachCell(const Visit& visit) const;
  /// Grid of particle i.
  const CoarseGrid<Real>& gridOf(Index i) const { return grids_[grid_of_[i]]; }
  const CoarseGrid<Real>& gridOfNode(std::size_t node) const;
  /// The lowest node of the cell of particle i.
  std::size_t lowestNodeOf(Index i) const {
    const CoarseGrid<Real>& grid = gridOf(i);
    return grid.lowestNode(cell_at_[0][i] - grid.low.x(), cell_at_[1][i] - grid.low.y(),
                           cell_at_[2][i] - grid.low.z());
  }
  /// Place of particle i in its cell, 0 ... 1.
  Real placeOf(Index i, std::size_t axis) const { return inside_[axis][i]; }
  CellRange particlesIn(std::size_t cell) const {
    return {start_[cell], supported_[cell] ? start_[cell + 1] - start_[cell] : 0};
  }
  /// Edge of a cell that is not fitted between walls.
  Real cell_m() const { return cell_m_; }
  /// Leaves out all water that is not connected to a supported particle: in free flight nothing
  /// presses on water, so it needs no coarse level.
  /// @param supported (n)
  void markSupported(const std::vector<char>& supported);
  std::size_t nodeCount() const { return node_count_; }
  /// Values at nodes are preceded and followed by this many zeros, so that the stencil of every
  /// node lies in the array.
  std::size_t nodePadding() const { return node_padding_; }
  /// Number of a node that does not depend on the boxes, ascending with that in the boxes.
  std::uint64_t nodeKey(std::size_t node) const;
  /// Planes of one colour share no node.
  static constexpr int kColours = 3;

  std::size_t bytes() const;

 private:
  Vec3<Real> fittedCell(const AlignedBox<Real>& room) const;
  void locate(const VectorField<Real>& position, const Colliders<Real>& colliders);
  void chooseBoxes(std::size_t particles);
  void shrink(std::size_t max_cells);
  void numberCells();
  void countingSort();

  Real cell_m_;
  std::vector<CoarseGrid<Real>> grids_;
  std::vector<std::size_t> by_size_;                  ///< grids of containers, the smallest first
  std::vector<Eigen::Vector3i> lowest_, highest_;     ///< (grids) cells that hold particles
  std::vector<Index> grid_of_;                        ///< (n)
  std::array<std::vector<std::int32_t>, 3> cell_at_;  ///< (n) cell coordinates
  std::array<std::vector<Real>, 3> inside_;           ///< (n) place in the cell
  std::vector<Index> cell_of_;                        ///< (n) kNone: in no cell
  std::vector<std::array<std::int32_t, 4>> flood_;    ///< grid and cell still to visit
  std::vector<Index> start_;                          ///< (cells + 1)
  std::vector<char> supported_;                       ///< (cells)
  std::vector<Index> order_;
  std::array<std::vector<CellPlane>, kColours> planes_;
  std::size_t node_count_ = 0;
  std::size_t node_padding_ = 0;
};

template <class Real>
template <class Visit>
void CoarseGrids<Real>::forEachCell(const Visit& visit) const {
  for (const std::vector<CellPlane>& planes : planes_) {
    parallelFor(
        planes.size(),
        [&](std::size_t k) {
          const CoarseGrid<Real>& grid = grids_[planes[k].grid];
          for (int y = 0; y < grid.cells.y(); ++y) {
            for (int z = 0; z < grid.cells.z(); ++z) {
              const CellRange cell = particlesIn(grid.cell(planes[k].x, y, z));
              if (cell.count > 0) visit(grid, cell, grid.lowestNode(planes[k].x, y, z));
            }
          }
        },
        1);
  }
}

}  // namespace ice_ice_baby
