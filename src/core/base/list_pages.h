// Paged memory for lists that several threads write at once; pages are reused by the next build.
#pragma once

#include <algorithm>
#include <limits>
#include <memory>
#include <mutex>
#include <vector>

#include "ice_ice_baby/types.h"

namespace ice_ice_baby {

/// Lists of any length, each contiguous. All lists share the pages, so moving water needs no
/// further allocations.
class ListPages {
 public:
  class Round;
  class Writer;

  /// Alignment of the start of a list, in values.
  static constexpr std::size_t kAlign = 4;

  /// The list at a place that Writer::finish returned.
  const Index* at(Index place) const {
    return pages_[place / kPlaces].values.get() + place % kPlaces * kAlign;
  }

  /// Allocating more than this many bytes throws std::bad_alloc.
  void limit(double max_bytes) { max_bytes_ = max_bytes; }

  std::size_t bytes() const;

 private:
  static constexpr std::size_t kPageSize = 8192;
  static constexpr std::size_t kPlaces = kPageSize / kAlign;

  struct Page {
    std::unique_ptr<Index[]> values;
    std::size_t size = 0;  ///< kPageSize, or larger for a list that does not fit
  };
  void fit(Page& page, std::size_t size);

  std::vector<Page> pages_;
  double max_bytes_ = std::numeric_limits<double>::infinity();
  std::size_t values_ = 0;  ///< total size of all pages
};

/// One build, which rewrites every list.
class ListPages::Round {
 public:
  explicit Round(ListPages& lists) : lists_(lists), pages_(lists.pages_) {}

  /// Call when the Writers are gone. Keeps as many pages as the same lists may need in any
  /// distribution over the writers, and a few more, so that a steady state does not allocate.
  void reserve(std::size_t writers);

 private:
  friend class Writer;
  struct Taken {
    Index number;
    Index* values;
    std::size_t size;
  };
  /// The next page, with room for this many values. Thread safe.
  Taken take(std::size_t room);
  void count(std::size_t written, std::size_t widest);

  std::mutex mutex_;
  ListPages& lists_;
  std::vector<Page>& pages_;
  std::size_t taken_ = 0;
  std::size_t written_ = 0;  ///< total size of all lists
  std::size_t widest_ = 0;   ///< largest room that a list asked for
};

/// One thread's part of a build: writes list after list.
class ListPages::Writer {
 public:
  explicit Writer(Round& round) : round_(round) {}
  ~Writer() { round_.count(written_, widest_); }

  /// Memory for the next list: at least `room` values. No list starts beyond kPageSize of a longer
  /// page, because a place cannot address it. @throws std::bad_alloc beyond the limit
  Index* start(std::size_t room) {
    widest_ = std::max(widest_, room);
    if (page_.size - used_ < room || used_ >= kPageSize) {
      page_ = round_.take(room);
      used_ = 0;
    }
    return page_.values + used_;
  }

  /// Ends the list after `size` values. Returns its place.
  Index finish(std::size_t size) {
    const std::size_t place = page_.number * kPlaces + used_ / kAlign;
    const std::size_t aligned = (size + kAlign - 1) / kAlign * kAlign;
    used_ += aligned;
    written_ += aligned;
    return static_cast<Index>(place);
  }

 private:
  Round& round_;
  Round::Taken page_{0, nullptr, 0};
  std::size_t used_ = 0;  ///< values used in the page
  std::size_t written_ = 0;
  std::size_t widest_ = 0;
};

}  // namespace ice_ice_baby
