// Neighbour search (the paper's spatial map): occupied cells in sorted order, and per particle the
// list of those nearer than the support radius.
#pragma once

#include <vector>

#include "base/list_pages.h"
#include "particles/near_search.h"
#include "particles/particles.h"

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
  Neighbours(Real support_m, Real skin_m);

  /// Memory that all lists may take, half of the machine's unless told otherwise: n particles at
  /// one place have n^2 neighbours, and the kernel would rather end the program than say no.
  void limitLists(double most_bytes);

  /// Whether some predicted position is further than skin / 2 from where the lists were built, but
  /// for a shift common to all: water that falls as one keeps its lists.
  bool stale(const VectorField<Real>& predicted) const;

  /// Order in which particles lie cell by cell: place k is for particle order[k]. The lists are
  /// gone until the next build, as the sort works in their memory.
  const std::vector<Index>& sortOrder(const VectorField<Real>& predicted);

  /// Builds every list from positions that lie in the order that sortOrder gave.
  /// @throws InvalidInput where they take too much memory; they are stale then, and nothing is lost
  void build(const VectorField<Real>& predicted);

  /// Every j with |x_j* - x_i*| < h, and some that are up to skin further. Behind the last lie
  /// enough other indices for a vector of up to kPadding to start in the list.
  List of(std::size_t i) const {
    const Index* first = pages_.at(place_[i]);
    return {first, first + count_[i]};
  }

  /// Lanes of the widest vectors in use.
  static constexpr std::size_t kPadding = 16;

  /// Whether the latest build found two particles at exactly one point.
  bool coincident() const { return coincident_; }

  std::size_t builds() const { return builds_; }
  std::size_t pairs() const;
  std::size_t bytes() const;

  /// Where the lists were built: they follow from it.
  template <class Self, class Archive>
  static void exchange(Self& self, Archive& archive) {
    archive(self.built_at_, self.builds_);
  }
  /// Builds the lists again where those that a checkpoint held were built.
  /// @throws InvalidInput when these are not positions of `particles` particles sorted by cell
  void restore(std::size_t particles);

 private:
  static constexpr std::size_t kChunk = 256;

  /// Particles first ... end of the next cell share this cell.
  struct Cell {
    std::uint64_t key;
    Index first;
  };
  /// What one thread needs to build lists.
  struct Builder {
    Candidates<Real>& candidates;
    ListPages::Writer lists;
    bool coincident = false;
  };
  std::uint64_t cellAlong(int axis, Real value) const;
  std::uint64_t cellKey(const Vec3<Real>& point) const;
  void sortAlong(int axis, const std::vector<Real>& values);
  void findCells();
  std::size_t fullestCell() const;
  void makeRoom(std::size_t builders);
  void buildLists();
  void forgetLists();
  class RowCursors;
  void buildChunk(std::size_t chunk, Builder& builder);
  void buildList(Index i, Builder& builder);

  Real reach_;
  Real skin_;
  Vec3<Real> origin_ = Vec3<Real>::Zero();
  NearSearch<Real> search_ = nearSearch<Real>();
  VectorField<Real> built_at_;  ///< (n + kPadding) positions at the last build
  std::vector<Index> order_;    ///< (n)
  std::vector<Cell> cells_;     ///< occupied cells by key, and one end mark
  std::vector<Index> place_;    ///< (n) where a list is in the pages; scratch of the sort
  std::vector<Index> count_;    ///< (n) its size; scratch of the sort
  ListPages pages_;
  double most_bytes_;                         ///< of the lists
  std::vector<Candidates<Real>> candidates_;  ///< one for each thread that builds
  bool coincident_ = false;
  std::size_t builds_ = 0;
};

}  // namespace ice_ice_baby
