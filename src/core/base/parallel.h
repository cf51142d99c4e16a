// Loops over particles on the threads of the current task arena.
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cstddef>

#include "base/fork_join.h"

namespace ice_ice_baby {

/// Calls body(first, last) for ranges that cover 0 ... count - 1. Each call writes only what
/// belongs to its own range, so the result does not depend on the number of threads.
/// @param grain ranges of more than that many are split
template <class Body>
void parallelForRanges(std::size_t count, const Body& body, std::size_t grain = 256) {
  ForkJoin order;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, grain),
                    [&](const tbb::blocked_range<std::size_t>& range) {
                      order.beginRange();
                      body(range.begin(), range.end());
                      order.endRange();
                    });
  order.join();
}

/// Calls body(i) for every i < count. Each call writes only what belongs to its own i.
/// @param grain as above
template <class Body>
void parallelFor(std::size_t count, const Body& body, std::size_t grain = 256) {
  parallelForRanges(
      count,
      [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i != last; ++i) body(i);
      },
      grain);
}

}  // namespace ice_ice_baby
