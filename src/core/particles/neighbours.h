// Neighbour search (the paper's spatial map): particles sorted by cell, and for each particle the
// list of particles within the support radius.
#pragma once

#include <vector>

#include "base/list_pages.h"
#include "particles/near_search.h"
#include "particles/particles.h"

namespace ice_ice_baby {

/// Only occupied cells are stored, so memory depends on the number of particles alone.
template <class Real>
class Neighbours {
 public:
  /// Neighbours of one particle, without the particle itself, in ascending cell order.
  struct List {
    const Index* first;
    const Index* last;
    const Index* begin() const { return first; }
    const Index* end() const { return last; }
    std::size_t size() const { return static_cast<std::size_t>(last - first); }
  };

  /// @param support_m h, m
  /// @param skin_m lists reach h + skin and stay valid until two particles have moved by skin
  /// relative to each other
  Neighbours(Real support_m, Real skin_m);

  /// Limits the memory of all lists; half of the machine's memory by default. n particles at one
  /// point have n^2 neighbours, and Linux would kill the program rather than refuse the memory.
  void limitLists(double max_bytes);

  /// Whether some predicted position has moved more than skin / 2 since the lists were built,
  /// apart from a displacement common to all (water in free fall keeps its lists).
  bool stale(const VectorField<Real>& predicted) const;

  /// Order of the particles by cell: place k belongs to particle order[k]. Invalidates the lists
  /// until the next build, because the sort uses their memory.
  const std::vector<Index>& sortOrder(const VectorField<Real>& predicted);

  /// Builds every list from positions in the order that sortOrder returned.
  /// @throws InvalidInput if the lists take too much memory; they are stale then, and no other
  /// state has changed
  void build(const VectorField<Real>& predicted);

  /// Every j with |x_j* - x_i*| < h, and some that are up to skin further away. The list is
  /// followed by enough valid indices for a vector of kPadding lanes to start at any entry.
  List of(std::size_t i) const {
    const Index* first = pages_.at(place_[i]);
    return {first, first + count_[i]};
  }

  /// Lanes of the widest vectors in use.
  static constexpr std::size_t kPadding = 16;

  /// Whether the latest build found two particles at exactly the same point.
  bool coincident() const { return coincident_; }

  std::size_t builds() const { return builds_; }
  std::size_t pairs() const;
  std::size_t bytes() const;

  /// Lists the positions at the latest build; the lists are recomputed from them.
  template <class Self, class Archive>
  static void exchange(Self& self, Archive& archive) {
    archive(self.built_at_, self.builds_);
  }
  /// Rebuilds the lists from the positions that a checkpoint holds.
  /// @throws InvalidInput when these are not positions of `particles` particles sorted by cell
  void restore(std::size_t particles);

 private:
  static constexpr std::size_t kChunk = 256;

  /// The cell holds the particles from `first` up to `first` of the next cell.
  struct Cell {
    std::uint64_t key;
    Index first;
  };
  /// Scratch memory of one thread for building lists.
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
  std::vector<Cell> cells_;     ///< occupied cells by key, and a sentinel at the end
  std::vector<Index> place_;    ///< (n) place of a list in the pages; scratch of the sort
  std::vector<Index> count_;    ///< (n) length of a list; scratch of the sort
  ListPages pages_;
  double max_bytes_;                          ///< of the lists
  std::vector<Candidates<Real>> candidates_;  ///< one for each thread that builds
  bool coincident_ = false;
  std::size_t builds_ = 0;
};

}  // namespace ice_ice_baby
