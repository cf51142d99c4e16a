#include "base/list_pages.h"

#include <algorithm>
#include <new>

namespace ice_ice_baby {

ListPages::Round::Taken ListPages::Round::take(std::size_t room) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (taken_ == pages_.size()) pages_.emplace_back();
  Page& page = pages_[taken_];
  if (page.size < room) lists_.fit(page, std::max(room, kPageSize));
  return {static_cast<Index>(taken_++), page.values.get(), page.size};
}

void ListPages::Round::count(std::size_t written, std::size_t widest) {
  const std::lock_guard<std::mutex> lock(mutex_);
  written_ += written;
  widest_ = std::max(widest_, widest);
}

void ListPages::Round::reserve(std::size_t writers) {
  if (widest_ > kPageSize / 2) return;  // such long lists have pages of their own
  const std::size_t full = kPageSize - widest_;
  const std::size_t needed = (written_ + full - 1) / full + writers - 1;
  if (pages_.size() >= needed) return;
  if (double(needed + needed / 32) * kPageSize * sizeof(Index) > lists_.max_bytes_) return;
  const std::size_t before = pages_.size();
  pages_.resize(needed + needed / 32);
  for (std::size_t k = before; k < pages_.size(); ++k) lists_.fit(pages_[k], kPageSize);
}

/// Left uninitialized, so that unused memory of a page is never touched.
void ListPages::fit(Page& page, std::size_t size) {
  const std::size_t values = values_ - page.size + size;
  if (double(values) * sizeof(Index) > max_bytes_) throw std::bad_alloc();
  page.values.reset(new Index[size]);
  values_ = values;
  page.size = size;
}

std::size_t ListPages::bytes() const {
  std::size_t total = pages_.capacity() * sizeof(Page);
  for (const Page& page : pages_) total += page.size * sizeof(Index);
  return total;
}

}  // namespace ice_ice_baby
