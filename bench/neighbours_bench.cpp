// neighbours/...: sorting and building the lists anew, and asking whether they are still good.
#include <benchmark/benchmark.h>

#include "core_water.h"
#include "measure.h"

namespace ice_ice_baby::bench {
namespace {

void sortAndBuild(benchmark::State& state) {
  CoreWater water{std::size_t(state.range(0))};
  Threads threads(int(state.range(1)));
  for (auto _ : state) {
    threads.execute([&] {
      water.particles.reorder(water.neighbours.sortOrder(water.particles.predicted));
      water.neighbours.build(water.particles.predicted);
    });
  }
  countParticles(state, water.particles.size());
  countPairs(state, 2.0 * double(water.neighbours.pairs()));
}

/// They are, so every particle is looked at.
void askStale(benchmark::State& state) {
  CoreWater water{std::size_t(state.range(0))};
  Threads threads(int(state.range(1)));
  for (auto _ : state) {
    threads.execute(
        [&] { benchmark::DoNotOptimize(water.neighbours.stale(water.particles.predicted)); });
  }
  countParticles(state, water.particles.size());
}

BENCHMARK(sortAndBuild)->Name("neighbours/build")->Apply(allSizes);
BENCHMARK(askStale)->Name("neighbours/stale")->Apply(allSizes);

}  // namespace
}  // namespace ice_ice_baby::bench
