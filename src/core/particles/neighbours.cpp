#include "particles/neighbours.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <new>
#include <numeric>
#include <string>

#include "base/machine_memory.h"
#include "base/parallel.h"
#include "ice_ice_baby/errors.h"

namespace ice_ice_baby {

namespace {

// A key packs three 20-bit cell coordinates, x highest, so that cells along z are consecutive. The
// coarse level numbers its cells in the same order.
constexpr int kBits = 20;
constexpr std::int64_t kMaxCell = (std::int64_t(1) << kBits) - 2;

/// Fraction of the machine's memory that lists may take; the rest of a scene takes about as much.
constexpr double kListShare = 0.5;

/// A length in m as text, rounded to a micrometre.
std::string lengthText(double length_m) { return numberText(std::round(1e6 * length_m) / 1e6); }

constexpr std::uint64_t packKey(std::uint64_t x, std::uint64_t y, std::uint64_t z) {
  return (x << (2 * kBits)) | (y << kBits) | z;
}

}  // namespace

template <class Real>
Neighbours<Real>::Neighbours(Real support_m, Real skin_m)
    : reach_(support_m + skin_m), skin_(skin_m) {
  limitLists(kListShare * machineMemory_bytes());
}

template <class Real>
void Neighbours<Real>::limitLists(double max_bytes) {
  max_bytes_ = max_bytes;
  pages_.limit(max_bytes);
}

template <class Real>
bool Neighbours<Real>::stale(const VectorField<Real>& predicted) const {
  if (count_.size() != predicted.size()) return true;
  return !search_.allWithin(predicted, built_at_, skin_ / 2);
}

template <class Real>
std::uint64_t Neighbours<Real>::cellAlong(int axis, Real value) const {
  // Cell coordinates start at 1 and end before the last, so that a neighbouring cell never wraps
  // around. The clamp keeps neighbours in adjacent cells at any distance from the origin.
  // The cell edge is slightly longer than the reach, so that rounding cannot separate neighbours by
  // two cells.
  const double offset = double(value - origin_[axis]) / (1.0001 * double(reach_));
  // NaN goes to the first cell.
  return static_cast<std::uint64_t>(std::min(std::max(0.0, offset), double(kMaxCell - 1))) + 1;
}

template <class Real>
std::uint64_t Neighbours<Real>::cellKey(const Vec3<Real>& point) const {
  return packKey(cellAlong(0, point.x()), cellAlong(1, point.y()), cellAlong(2, point.z()));
}

/// Radix sort, axis by axis, x last.
template <class Real>
const std::vector<Index>& Neighbours<Real>::sortOrder(const VectorField<Real>& predicted) {
  const std::size_t n = predicted.size();
  for (auto* indices : {&order_, &place_, &count_}) indices->resize(n);
  std::iota(order_.begin(), order_.end(), Index(0));
  if (n == 0) return order_;
  origin_ = {*std::min_element(predicted.x.begin(), predicted.x.end()),
             *std::min_element(predicted.y.begin(), predicted.y.end()),
             *std::min_element(predicted.z.begin(), predicted.z.end())};
  sortAlong(2, predicted.z);
  sortAlong(1, predicted.y);
  sortAlong(0, predicted.x);
  return order_;
}

/// 10 bits per pass; passes in which all cells agree are skipped. Stable and linear, with one pass
/// per axis for scenes of usual size.
template <class Real>
void Neighbours<Real>::sortAlong(int axis, const std::vector<Real>& values) {
  constexpr int kDigitBits = 10;
  constexpr Index kDigits = 1 << kDigitBits;
  std::vector<Index>& cells = count_;
  std::vector<Index>& sorted = place_;
  parallelFor(values.size(),
              [&](std::size_t i) { cells[i] = static_cast<Index>(cellAlong(axis, values[i])); });
  for (int shift = 0; shift < kBits; shift += kDigitBits) {
    std::array<Index, kDigits + 1> start{};
    for (const Index cell : cells) ++start[((cell >> shift) & (kDigits - 1)) + 1];
    if (*std::max_element(start.begin(), start.end()) == cells.size()) continue;
    std::partial_sum(start.begin(), start.end(), start.begin());
    for (const Index i : order_) sorted[start[(cells[i] >> shift) & (kDigits - 1)]++] = i;
    order_.swap(sorted);
  }
}

template <class Real>
void Neighbours<Real>::findCells() {
  const auto n = static_cast<Index>(count_.size());
  cells_.clear();
  for (Index k = 0; k < n; ++k) {
    const std::uint64_t key = cellKey(built_at_.at(k));
    if (k == 0 || key != cells_.back().key) cells_.push_back({key, k});
  }
  cells_.push_back({~std::uint64_t(0), n});
}

/// Number of particles in a cell.
template <class Real>
std::size_t Neighbours<Real>::fullestCell() const {
  Index fullest = 0;
  for (std::size_t c = 0; c + 1 < cells_.size(); ++c) {
    fullest = std::max(fullest, cells_[c + 1].first - cells_[c].first);
  }
  return fullest;
}

/// Reserves for the largest number of candidates of any cell, so that no thread allocates more.
template <class Real>
void Neighbours<Real>::makeRoom(std::size_t builders) {
  const std::size_t fullest = fullestCell();
  if (candidates_.size() < builders) candidates_.resize(builders);
  for (auto& candidates : candidates_) {
    candidates.makeRoom(std::min(count_.size(), 27 * fullest));
  }
}

/// Rows of cells around a cell, for cells in ascending order: each row only moves forwards.
template <class Real>
class Neighbours<Real>::RowCursors {
 public:
  RowCursors(const std::vector<Cell>& cells, std::uint64_t first_key) {
    const auto before = [](const Cell& cell, std::uint64_t key) { return cell.key < key; };
    for (int k = 0; k < 9; ++k) {
      at_[std::size_t(k)] =
          &*std::lower_bound(cells.begin(), cells.end(), middle(first_key, k) - 1, before);
    }
  }

  CellRows rowsAround(std::uint64_t key) {
    CellRows rows{};
    for (int k = 0; k < 9; ++k) {
      const std::uint64_t centre = middle(key, k);
      const Cell*& cell = at_[std::size_t(k)];
      while (cell->key < centre - 1) ++cell;
      const Cell* end = cell;
      while (end->key <= centre + 1) ++end;
      rows[std::size_t(k)] = {cell->first, end->first};
    }
    return rows;
  }

 private:
  /// Key of the centre cell of row k.
  static std::uint64_t middle(std::uint64_t key, int k) {
    const std::int64_t dy = k % 3 - 1, dx = k / 3 - 1;
    return key + static_cast<std::uint64_t>(dx * (std::int64_t(1) << (2 * kBits)) +
                                            dy * (std::int64_t(1) << kBits));
  }

  std::array<const Cell*, 9> at_;
};

template <class Real>
void Neighbours<Real>::buildChunk(std::size_t chunk, Builder& builder) {
  const auto behind = [](Index i, const Cell& cell) { return i < cell.first; };
  const Index end = static_cast<Index>(std::min((chunk + 1) * kChunk, count_.size()));
  Index i = static_cast<Index>(chunk * kChunk);
  auto cell = std::upper_bound(cells_.begin(), cells_.end(), i, behind) - 1;
  RowCursors cursors(cells_, cell->key);
  for (; i < end; ++cell) {
    const IndexRange range{i, std::min(end, cell[1].first)};
    search_.gather(built_at_, range, cursors.rowsAround(cell->key), reach_ * reach_,
                   builder.candidates);
    for (; i < range.last; ++i) buildList(i, builder);
  }
}

/// Writes the list of one particle, followed by i itself, so that a vector that reaches beyond the
/// list reads valid indices. The next list overwrites them.
template <class Real>
void Neighbours<Real>::buildList(Index i, Builder& builder) {
  const Candidates<Real>& candidates = builder.candidates;
  Index* first = builder.lists.start(candidates.count + 2 * kPadding);  // writes whole vectors
  Index* last =
      search_.collect(candidates, built_at_, i, reach_ * reach_, first, builder.coincident);
  std::fill(last, last + kPadding, i);
  count_[i] = static_cast<Index>(last - first);
  place_[i] = builder.lists.finish(count_[i]);
}

template <class Real>
void Neighbours<Real>::build(const VectorField<Real>& predicted) {
  const std::size_t n = predicted.size();
  built_at_.resize(n + kPadding);  // before copying, as growing later would double the memory
  std::copy(predicted.x.begin(), predicted.x.end(), built_at_.x.begin());
  std::copy(predicted.y.begin(), predicted.y.end(), built_at_.y.begin());
  std::copy(predicted.z.begin(), predicted.z.end(), built_at_.z.begin());
  for (auto* axis : {&built_at_.x, &built_at_.y, &built_at_.z}) {
    std::fill(axis->end() - std::ptrdiff_t(kPadding), axis->end(), Real(0));
  }
  for (auto* indices : {&place_, &count_}) indices->resize(n);
  findCells();
  try {
    buildLists();
  } catch (const std::bad_alloc&) {
    const std::string crowd = numberText(double(fullestCell()));
    forgetLists();
    throw InvalidInput("the lists of neighbours take more than " +
                       numberText(std::floor(max_bytes_ / 1e6)) + " MB of memory: " + crowd +
                       " particles lie in one cube of " + lengthText(double(reach_)) +
                       " m; give the water more room or enlarge fluid.spacing_m");
  }
  ++builds_;
}

template <class Real>
void Neighbours<Real>::buildLists() {
  const std::size_t n = count_.size();
  const std::size_t chunks = (n + kChunk - 1) / kChunk;
  const std::size_t threads = std::size_t(tbb::this_task_arena::max_concurrency());
  const std::size_t builders = std::min(chunks, threads);
  makeRoom(builders);
  ListPages::Round round(pages_);
  std::atomic<std::size_t> next{0};
  std::atomic<bool> coincident{false};
  const auto buildSome = [&](std::size_t k) {
    Builder builder{candidates_[k], ListPages::Writer(round)};
    for (std::size_t chunk; (chunk = next++) < chunks;) buildChunk(chunk, builder);
    if (builder.coincident) coincident = true;
  };
  parallelFor(builders, buildSome, 1);
  if (n > 0) round.reserve(builders);
  coincident_ = coincident;
}

/// Frees the memory of the lists, which are stale then.
template <class Real>
void Neighbours<Real>::forgetLists() {
  count_.clear();
  candidates_.clear();
  pages_ = ListPages();
  pages_.limit(max_bytes_);
}

template <class Real>
std::size_t Neighbours<Real>::pairs() const {
  return std::accumulate(count_.begin(), count_.end(), std::size_t(0)) / 2;
}

template <class Real>
std::size_t Neighbours<Real>::bytes() const {
  std::size_t total = built_at_.bytes() + cells_.capacity() * sizeof(Cell) + pages_.bytes() +
                      (order_.capacity() + place_.capacity() + count_.capacity()) * sizeof(Index);
  for (const auto& candidates : candidates_) total += candidates.bytes();
  return total;
}

template class Neighbours<float>;
template class Neighbours<double>;

}  // namespace ice_ice_baby
