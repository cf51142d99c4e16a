// bound/...: the pair-kernel bound, beside which an iteration of the solver is judged.
#include <benchmark/benchmark.h>

#include <map>
#include <memory>

#include "measure.h"
#include "pair_bound.h"
#include "settled_water.h"

namespace ice_ice_baby::bench {
namespace {

/// Water, its lists and the arrays of the passes, made once per size and reach.
struct Bare {
  Bare(std::size_t count, float reach)
      : water(count), lists(water, reach), rows(4 * water.size()), results(4 * water.size()) {
    for (std::size_t i = 0; i < water.size(); ++i) {
      rows[4 * i] = water.x[i];
      rows[4 * i + 1] = water.y[i];
      rows[4 * i + 2] = water.z[i];
      rows[4 * i + 3] = -0.01f;
    }
  }

  BareIteration iteration() {
    const std::size_t n = water.size();
    float* out = results.data();
    return {n,
            lists.begin.data(),
            lists.padded.data(),
            rows.data(),
            water.x.data(),
            water.y.data(),
            water.z.data(),
            out,
            out + n,
            out + 2 * n,
            out + 3 * n};
  }

  SettledWater water;
  NearLists lists;
  std::vector<float> rows, results;
};

Bare& bareWater(std::size_t count, float reach) {
  static std::map<std::pair<std::size_t, float>, std::unique_ptr<Bare>> made;
  auto& bare = made[{count, reach}];
  if (!bare) bare = std::make_unique<Bare>(count, reach);
  return *bare;
}

void runBound(benchmark::State& state, Fetch fetch, float reach, bool lambda, bool correction) {
  Bare& bare = bareWater(std::size_t(state.range(0)), reach);
  const BareIteration iteration = bare.iteration();
  const BarePasses passes = barePasses(fetch);
  Threads threads(int(state.range(1)));
  for (auto _ : state) {
    if (lambda) {
      threads.run(iteration.size,
                  [&](auto first, auto last) { passes.lambda(iteration, first, last); });
    }
    if (correction) {
      threads.run(iteration.size,
                  [&](auto first, auto last) { passes.correction(iteration, first, last); });
    }
  }
  countParticles(state, iteration.size);
  countPairs(state, double(iteration.size) * bare.lists.perParticle());
}

// Lists of exactly the support radius, and of a skin of 0.3 spacings beyond it.
constexpr float kExact = 1.0f, kSkinned = 1.15f;

BENCHMARK_CAPTURE(runBound, iteration, Fetch::kRows, kExact, true, true)
    ->Name("bound/iteration")
    ->Apply(allSizes);
BENCHMARK_CAPTURE(runBound, lambda, Fetch::kRows, kExact, true, false)
    ->Name("bound/lambda")
    ->Apply(oneSize);
BENCHMARK_CAPTURE(runBound, correction, Fetch::kRows, kExact, false, true)
    ->Name("bound/correction")
    ->Apply(oneSize);
BENCHMARK_CAPTURE(runBound, skinned, Fetch::kRows, kSkinned, true, true)
    ->Name("bound/iteration_skinned")
    ->Apply(oneSize);
BENCHMARK_CAPTURE(runBound, gather, Fetch::kGather, kExact, true, true)
    ->Name("bound/iteration_gathered")
    ->Apply(oneSize);

}  // namespace
}  // namespace ice_ice_baby::bench
