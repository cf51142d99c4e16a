// Memory for lists that several threads write at once: pages, kept from build to build.
#pragma once

#include <algorithm>
#include <limits>
#include <memory>
#include <mutex>
#include <vector>

#include "ice_ice_baby/types.h"

namespace ice_ice_baby {

/// Lists of any length, each in one piece. All of them share the pages, so that water which only
/// moves from place to place needs no more of them than before.
class ListPages {
 public:
  class Round;
  class Writer;

  /// Lists start at multiples of so many values.
  static constexpr std::size_t kAlign = 4;

  /// The list at a place that a Writer gave.
  const Index* at(Index place) const {
    return pages_[place / kPlaces].values.get() + place % kPlaces * kAlign;
  }

  /// Pages beyond so many bytes are std::bad_alloc, as if the machine had no more.
  void limit(double most_bytes) { most_bytes_ = most_bytes; }

  std::size_t bytes() const;

 private:
  static constexpr std::size_t kPageSize = 8192;
  static constexpr std::size_t kPlaces = kPageSize / kAlign;

  struct Page {
    std::unique_ptr<Index[]> values;
    std::size_t size = 0;  ///< kPageSize, more for a list that does not fit
  };
  void fit(Page& page, std::size_t size);

  std::vector<Page> pages_;
  double most_bytes_ = std::numeric_limits<double>::infinity();
  std::size_t values_ = 0;  ///< of all pages
};

/// One build, which writes every list anew.
class ListPages::Round {
 public:
  explicit Round(ListPages& lists) : lists_(lists), pages_(lists.pages_) {}

  /// Once the Writers are gone: keeps as many pages as the same lists may need however they fall to
  /// so many of them, and a few more, so that steady states do not allocate.
  void reserve(std::size_t writers);

 private:
  friend class Writer;
  struct Taken {
    Index number;
    Index* values;
    std::size_t size;
  };
  /// The next page, with room for so many values. Safe from several threads.
  Taken take(std::size_t room);
  void count(std::size_t written, std::size_t widest);

  std::mutex mutex_;
  ListPages& lists_;
  std::vector<Page>& pages_;
  std::size_t taken_ = 0;
  std::size_t written_ = 0;  ///< values of all lists
  std::size_t widest_ = 0;   ///< most that a list asked room for
};

/// One thread's share in a build: writes list after list.
class ListPages::Writer {
 public:
  explicit Writer(Round& round) : round_(round) {}
  ~Writer() { round_.count(written_, widest_); }

  /// Where the next list goes: at least `room` values. Behind kPageSize of a longer page nothing
  /// starts, as no place tells of that. @throws std::bad_alloc beyond the limit
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
  std::size_t used_ = 0;  ///< of the page
  std::size_t written_ = 0;
  std::size_t widest_ = 0;
};

}  // namespace ice_ice_baby
