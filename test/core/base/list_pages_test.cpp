#include "base/list_pages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace ice_ice_baby {
namespace list_pages_test {

/// Writes lists, each filled with its own number. @return their places
std::vector<Index> writeLists(ListPages& pages, Index lists, std::size_t length) {
  ListPages::Round round(pages);
  std::vector<Index> places;
  {
    ListPages::Writer writer(round);
    for (Index k = 0; k < lists; ++k) {
      std::fill_n(writer.start(length), length, k);
      places.push_back(writer.finish(length));
    }
  }
  round.reserve(1);
  return places;
}

void expectLists(const ListPages& pages, const std::vector<Index>& places, std::size_t length) {
  for (Index k = 0; k < places.size(); ++k) {
    const Index* list = pages.at(places[k]);
    EXPECT_TRUE(std::all_of(list, list + length, [&](Index value) { return value == k; })) << k;
  }
}

TEST(ListPagesTest, PagesAreReusedForListsOfAnotherLength) {
  ListPages pages;
  expectLists(pages, writeLists(pages, 3, 50000), 50000);
  expectLists(pages, writeLists(pages, 10000, 6), 6);
  expectLists(pages, writeLists(pages, 3, 50000), 50000);
}

TEST(ListPagesTest, TheSameListsTakeNoMemoryTheSecondTime) {
  ListPages pages;
  writeLists(pages, 10000, 6);
  const std::size_t bytes = pages.bytes();
  writeLists(pages, 10000, 6);
  EXPECT_EQ(pages.bytes(), bytes);
}

TEST(ListPagesTest, PagesBeyondTheLimitAreRefused) {
  ListPages pages;
  pages.limit(1e6);
  EXPECT_THROW(writeLists(pages, 1, 300000), std::bad_alloc);
  expectLists(pages, writeLists(pages, 100, 6), 6);
  EXPECT_LE(pages.bytes(), 1'001'000u);
}

}  // namespace list_pages_test
}  // namespace ice_ice_baby
