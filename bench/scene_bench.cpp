// scene/...: whole frames by the interface that every user has. Wall time per particle and substep,
// and the same for each stage.
#include <benchmark/benchmark.h>

#include <functional>
#include <map>

#include "ice_ice_baby/simulation.h"
#include "measure.h"
#include "water_scenes.h"

namespace ice_ice_baby::bench {
namespace {

using MakeScene = Scene (*)(std::size_t count);

std::map<std::string, double> stageTimes_s(const Simulation& simulation) {
  std::map<std::string, double> times;
  for (const StageStats& stage : simulation.stages()) times[stage.name] = stage.time_s;
  return times;
}

double bytesPerParticle(const Simulation& simulation) {
  double bytes = 0.0;
  for (const StageStats& stage : simulation.stages()) bytes += double(stage.bytes);
  return bytes / double(simulation.report().particles);
}

/// @param from_s simulated time at which the measured frames begin
void runScene(benchmark::State& state, MakeScene make, double from_s) {
  const auto simulation =
      makeSimulation(make(std::size_t(state.range(0))), Precision::kFloat, int(state.range(1)));
  const SolverParams& solver = simulation->scene().solver;
  // The first frame takes memory that the later ones keep.
  do simulation->advanceFrame();
  while (simulation->report().time_s < from_s);
  auto before = stageTimes_s(*simulation);
  for (auto _ : state) simulation->advanceFrame();
  const double substeps = double(solver.substeps) * double(state.iterations());
  const double work = substeps * double(simulation->report().particles);
  state.counters["per_particle_substep"] =
      perEach(solver.substeps * double(simulation->report().particles));
  for (const auto& [name, time_s] : stageTimes_s(*simulation)) {
    state.counters["stage_" + name] = (time_s - before[name]) / work;
  }
  state.counters["iterations_per_substep"] = solver.iterations;
  state.counters["bytes_per_particle"] = bytesPerParticle(*simulation);
}

void fewFrames(benchmark::internal::Benchmark* b) { sizes(b, {6000, 30000, 100000}, {1, 2}); }

// A benchmark of its own for the largest, as its frames take seconds.
void largest(benchmark::internal::Benchmark* b) { sizes(b, {1000000}, {1, 2}); }

BENCHMARK_CAPTURE(runScene, still_pool, stillPool, 0.1)
    ->Name("scene/still_pool")
    ->Apply(fewFrames)
    ->Iterations(20);
BENCHMARK_CAPTURE(runScene, still_pool_large, stillPool, 0.0)
    ->Name("scene/still_pool")
    ->Apply(largest)
    ->Iterations(3);
BENCHMARK_CAPTURE(runScene, floating, floatingWater, 0.0)
    ->Name("scene/floating")
    ->Apply(oneSize)
    ->Iterations(20);
BENCHMARK_CAPTURE(runScene, dam_break, damBreak, 0.5)
    ->Name("scene/dam_break")
    ->Apply(oneSize)
    ->Iterations(20);

}  // namespace
}  // namespace ice_ice_baby::bench
