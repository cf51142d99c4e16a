#include "ice_ice_baby/list_pages.h"

#include <algorithm>

namespace ice_ice_baby {

ListPages::Round::Taken ListPages::Round::take(std::size_t room) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (taken_ == pages_.size()) {
    // A sixteenth more than needed, so that steady states do not allocate.
    pages_.reserve(taken_ + 1 + taken_ / 16);
    pages_.resize(pages_.capacity());
    for (std::size_t k = taken_; k < pages_.size(); ++k) fit(pages_[k], kPageSize);
  }
  Page& page = pages_[taken_];
  if (page.size < room) fit(page, room);
  return {static_cast<Index>(taken_++), page.values.get(), page.size};
}

/// Uninitialized: a page that no list reaches costs nothing.
void ListPages::Round::fit(Page& page, std::size_t size) {
  page.values.reset(new Index[size]);
  page.size = size;
}

std::size_t ListPages::bytes() const {
  std::size_t total = pages_.capacity() * sizeof(Page);
  for (const Page& page : pages_) total += page.size * sizeof(Index);
  return total;
}

}  // namespace ice_ice_baby
