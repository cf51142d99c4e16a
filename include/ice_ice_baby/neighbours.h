// Neighbour search (the paper's spatial map): occupied cells in sorted order, and per particle the
// list of those nearer than the support radius.
#pragma once

#include <vector>

#include "ice_ice_baby/near_search.h"
#include "ice_ice_baby/particles.h"

namespace ice_ice_baby {

/// Memory grows with the particles alone, not with the space between them.
template <class Real>
class Neighbours {
 public:
  /// Neighbours of one particle: a range of indices in ascending cell order, itself left out.
  struct List {
    const Index* first;
    const Index* last;
    const Index* begin() const { return first; }
    const Index* end() const { return last; }
    std::size_t size() const { return static_cast<std::size_t>(last - first); }
  };

  /// @param support_m h, m
  /// @param skin_m lists reach h + skin and stay valid while no two particles have moved by skin
  /// against each other
  Neighbours(Real support_m, Real skin_m) : reach_(support_m + skin_m), skin_(skin_m) {}

  /// Whether some predicted position is further than skin / 2 from where the lists were built, but
  /// for a shift common to all: water that falls as one keeps its lists.
  bool stale(const VectorField<Real>& predicted) const;

  /// Order in which particles lie cell by cell: place k is for particle order[k].
  const std::vector<Index>& sortOrder(const VectorField<Real>& predicted);

  /// Builds every list from positions that lie in the order that sortOrder gave.
  void build(const VectorField<Real>& predicted);

  /// Every j with |x_j* - x_i*| < h, and some that are up to skin further.
  List of(std::size_t i) const {
    const Index* first = chunks_[i / kChunk].list.data() + begin_[i];
    return {first, first + count_[i]};
  }

  /// The same, filled up with i itself to a multiple of kPadding.
  List padded(std::size_t i) const {
    const List list = of(i);
    return {list.first, list.first + (list.size() + kPadding - 1) / kPadding * kPadding};
  }

  /// Lanes of the widest vectors in use, so that loops over a padded list need no remainder.
  static constexpr std::size_t kPadding = 16;

  /// Whether the latest build found two particles at exactly one point.
  bool coincident() const;

  std::size_t builds() const { return builds_; }
  std::size_t pairs() const;
  std::size_t bytes() const;

 private:
  static constexpr std::size_t kChunk = 256;

  /// Padded lists of kChunk particles in a row; never shrinks, so that steady states do not
  /// allocate.
  struct Chunk {
    std::vector<Index> list;
    bool coincident = false;
  };
  /// Particles first ... end of the next cell share this cell.
  struct Cell {
    std::uint64_t key;
    Index first;
  };
  std::uint64_t cellKey(const Vec3<Real>& point) const;
  void sortKeys(std::size_t count);
  void findCells();
  class RowCursors;
  void buildChunk(std::size_t chunk);
  Index buildList(Index i, const Candidates<Real>& candidates, Index begin, Chunk& chunk);

  Real reach_;
  Real skin_;
  Vec3<Real> origin_ = Vec3<Real>::Zero();
  NearSearch<Real> search_ = nearSearch<Real>();
  VectorField<Real> built_at_;       ///< (n + kPadding) positions at the last build
  std::vector<std::uint64_t> keys_;  ///< (n) cell of the particle at place k
  std::vector<Index> order_;         ///< (n)
  std::vector<std::uint64_t> key_scratch_;
  std::vector<Index> order_scratch_;
  std::vector<Cell> cells_;  ///< occupied cells by key, and one end mark
  std::vector<Chunk> chunks_;
  std::vector<Index> begin_, count_;  ///< (n) range in the chunk's list
  std::size_t builds_ = 0;
};

}  // namespace ice_ice_baby
