#include "ice_ice_baby/neighbours.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "ice_ice_baby/parallel.h"

namespace ice_ice_baby {

namespace {

// A key packs three 20-bit cell coordinates, z highest, so that cells along x follow each other.
constexpr int kBits = 20;
constexpr std::int64_t kMaxCell = (std::int64_t(1) << kBits) - 2;

constexpr std::uint64_t packKey(std::uint64_t x, std::uint64_t y, std::uint64_t z) {
  return (z << (2 * kBits)) | (y << kBits) | x;
}

}  // namespace

template <class Real>
bool Neighbours<Real>::stale(const VectorField<Real>& predicted) const {
  if (count_.size() != predicted.size()) return true;
  return !search_.allWithin(predicted, built_at_, skin_ / 2);
}

template <class Real>
std::uint64_t Neighbours<Real>::cellKey(const Vec3<Real>& point) const {
  std::uint64_t cell[3];
  for (int axis = 0; axis < 3; ++axis) {
    // Cells start at 1 and end before the last, so that a neighbouring cell never wraps round. The
    // clamp keeps cells of neighbours next to each other, however far out they are.
    // The edge is a hair longer than the reach, so that rounding cannot part neighbours by two
    // cells.
    const double offset = double(point[axis] - origin_[axis]) / (1.0001 * double(reach_));
    cell[axis] = static_cast<std::uint64_t>(std::clamp(offset, 0.0, double(kMaxCell - 1))) + 1;
  }
  return packKey(cell[0], cell[1], cell[2]);
}

template <class Real>
const std::vector<Index>& Neighbours<Real>::sortOrder(const VectorField<Real>& predicted) {
  const std::size_t n = predicted.size();
  keys_.resize(n);
  order_.resize(n);
  std::iota(order_.begin(), order_.end(), Index(0));
  if (n == 0) return order_;
  origin_ = {*std::min_element(predicted.x.begin(), predicted.x.end()),
             *std::min_element(predicted.y.begin(), predicted.y.end()),
             *std::min_element(predicted.z.begin(), predicted.z.end())};
  parallelFor(n, [&](std::size_t i) { keys_[i] = cellKey(predicted.at(i)); });
  sortKeys(n);
  return order_;
}

/// Radix sort, 10 bits a pass, leaving out passes in which all keys agree: stable, linear, and two
/// or three passes for scenes of usual size.
template <class Real>
void Neighbours<Real>::sortKeys(std::size_t count) {
  constexpr int kDigitBits = 10;
  constexpr std::uint64_t kDigits = 1 << kDigitBits;
  key_scratch_.resize(count);
  order_scratch_.resize(count);
  for (int shift = 0; shift < 3 * kBits; shift += kDigitBits) {
    std::array<Index, kDigits + 1> start{};
    for (const std::uint64_t key : keys_) ++start[((key >> shift) & (kDigits - 1)) + 1];
    if (*std::max_element(start.begin(), start.end()) == count) continue;
    std::partial_sum(start.begin(), start.end(), start.begin());
    for (std::size_t k = 0; k < count; ++k) {
      const Index place = start[(keys_[k] >> shift) & (kDigits - 1)]++;
      key_scratch_[place] = keys_[k];
      order_scratch_[place] = order_[k];
    }
    keys_.swap(key_scratch_);
    order_.swap(order_scratch_);
  }
}

template <class Real>
void Neighbours<Real>::findCells() {
  cells_.clear();
  for (std::size_t k = 0; k < keys_.size(); ++k) {
    if (k == 0 || keys_[k] != keys_[k - 1]) cells_.push_back({keys_[k], Index(k)});
  }
  cells_.push_back({~std::uint64_t(0), Index(keys_.size())});
}

/// Rows of cells around cells that come in ascending order: each row's place only moves on.
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
  /// Key of the middle cell of row k.
  static std::uint64_t middle(std::uint64_t key, int k) {
    const std::int64_t dy = k % 3 - 1, dz = k / 3 - 1;
    return key + static_cast<std::uint64_t>(dz * (std::int64_t(1) << (2 * kBits)) +
                                            dy * (std::int64_t(1) << kBits));
  }

  std::array<const Cell*, 9> at_;
};

template <class Real>
void Neighbours<Real>::buildChunk(std::size_t chunk) {
  thread_local Candidates<Real> candidates;
  const Index end = static_cast<Index>(std::min((chunk + 1) * kChunk, keys_.size()));
  Index i = static_cast<Index>(chunk * kChunk);
  RowCursors cursors(cells_, keys_[i]);
  Index begin = 0;
  chunks_[chunk].coincident = false;
  while (i < end) {
    IndexRange cell{i, i};
    while (cell.last < end && keys_[cell.last] == keys_[i]) ++cell.last;
    search_.gather(built_at_, cell, cursors.rowsAround(keys_[i]), reach_ * reach_, candidates);
    for (; i < cell.last; ++i) begin = buildList(i, candidates, begin, chunks_[chunk]);
  }
}

/// Writes the list of one particle and its padding at `begin`. Returns where the next one starts.
template <class Real>
Index Neighbours<Real>::buildList(Index i, const Candidates<Real>& candidates, Index begin,
                                  Chunk& chunk) {
  const std::size_t room = begin + candidates.count + 2 * kPadding;  // whole vectors are written
  if (chunk.list.size() < room) chunk.list.resize(room + room / 8);
  Index* first = chunk.list.data() + begin;
  Index* last = search_.collect(candidates, built_at_, i, reach_ * reach_, first, chunk.coincident);
  begin_[i] = begin;
  count_[i] = static_cast<Index>(last - first);
  std::fill(last, last + kPadding, i);
  return begin + static_cast<Index>(padded(i).size());
}

template <class Real>
void Neighbours<Real>::build(const VectorField<Real>& predicted) {
  const std::size_t n = predicted.size();
  findCells();
  built_at_ = predicted;
  built_at_.resize(n + kPadding);
  begin_.resize(n);
  count_.resize(n);
  const std::size_t chunks = (n + kChunk - 1) / kChunk;
  chunks_.resize(chunks);
  tbb::parallel_for(std::size_t(0), chunks, [&](std::size_t k) { buildChunk(k); });
  ++builds_;
}

template <class Real>
bool Neighbours<Real>::coincident() const {
  return std::any_of(chunks_.begin(), chunks_.end(), [](const Chunk& c) { return c.coincident; });
}

template <class Real>
std::size_t Neighbours<Real>::pairs() const {
  return std::accumulate(count_.begin(), count_.end(), std::size_t(0)) / 2;
}

template <class Real>
std::size_t Neighbours<Real>::bytes() const {
  std::size_t total =
      built_at_.bytes() + (keys_.capacity() + key_scratch_.capacity()) * sizeof(std::uint64_t) +
      (order_.capacity() + order_scratch_.capacity() + begin_.capacity() + count_.capacity()) *
          sizeof(Index) +
      cells_.capacity() * sizeof(Cell);
  for (const Chunk& chunk : chunks_) total += chunk.list.capacity() * sizeof(Index);
  return total;
}

template class Neighbours<float>;
template class Neighbours<double>;

}  // namespace ice_ice_baby
