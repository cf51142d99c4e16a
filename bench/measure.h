// What the benchmarks share: sizes, threads, and costs per particle and per pair.
#pragma once

#include <benchmark/benchmark.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <cstddef>

namespace ice_ice_baby::bench {

/// Wall time of an iteration over `count` things, in seconds each.
inline benchmark::Counter perEach(double count) {
  using benchmark::Counter;
  return Counter(count, Counter::kIsIterationInvariantRate | Counter::kInvert);
}

inline void countParticles(benchmark::State& state, std::size_t count) {
  state.counters["per_particle"] = perEach(double(count));
}

inline void countPairs(benchmark::State& state, double count) {
  state.counters["per_pair"] = perEach(count);
}

/// Arguments of a benchmark: particles, threads. Wall time, as more than one thread works.
inline void sizes(benchmark::internal::Benchmark* b, std::initializer_list<int> counts,
                  std::initializer_list<int> threads) {
  b->ArgNames({"n", "threads"})->UseRealTime()->Unit(benchmark::kMillisecond);
  for (const int count : counts) {
    for (const int t : threads) b->Args({count, t});
  }
}

inline void oneSize(benchmark::internal::Benchmark* b) { sizes(b, {30000}, {1, 2}); }
inline void allSizes(benchmark::internal::Benchmark* b) {
  sizes(b, {6000, 30000, 100000, 1000000}, {1, 2});
}

/// As many threads as a benchmark asks for.
class Threads {
 public:
  explicit Threads(int count) : arena_(count) {}

  template <class Work>
  void execute(const Work& work) {
    arena_.execute(work);
  }

  /// Calls work(first, last) for ranges that cover 0 ... count - 1.
  template <class Work>
  void run(std::size_t count, const Work& work) {
    arena_.execute([&] {
      tbb::parallel_for(
          tbb::blocked_range<std::size_t>(0, count, 256),
          [&](const tbb::blocked_range<std::size_t>& r) { work(r.begin(), r.end()); });
    });
  }

 private:
  tbb::task_arena arena_;
};

}  // namespace ice_ice_baby::bench
