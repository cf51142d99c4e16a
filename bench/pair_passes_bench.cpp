// passes/...: the solver's passes over pairs with their bookkeeping, but without walls.
#include <benchmark/benchmark.h>

#include "core_water.h"
#include "fluid/density_constraint.h"
#include "fluid/viscosity.h"
#include "measure.h"
#include "water_scenes.h"

namespace ice_ice_baby::bench {
namespace {

template <class Pass>
void runPass(benchmark::State& state, const Pass& pass) {
  CoreWater water{std::size_t(state.range(0))};
  Threads threads(int(state.range(1)));
  for (auto _ : state) threads.execute([&] { pass(water); });
  countParticles(state, water.particles.size());
  countPairs(state, 2.0 * double(water.neighbours.pairs()));
}

void lambda(benchmark::State& state) {
  DensityConstraint<float> density(floatingWater(1), nullptr);
  runPass(state, [&](CoreWater& w) { density.computeLambda(w.particles, w.neighbours); });
}

void correction(benchmark::State& state) {
  DensityConstraint<float> density(floatingWater(1), nullptr);
  bool first = true;
  runPass(state, [&](CoreWater& w) {
    if (first) density.computeLambda(w.particles, w.neighbours);
    first = false;
    density.computeDeltaP(w.particles, w.neighbours);
  });
}

void viscosity(benchmark::State& state) {
  const Scene scene = floatingWater(1);
  Viscosity<float> stage(scene, particleVolume_m3(scene.fluid, scene.supportRadius_m()));
  PackedXyzw<float> rows;
  runPass(state, [&](CoreWater& w) { stage.apply(w.particles, w.neighbours, 1.0 / 480, rows); });
}

BENCHMARK(lambda)->Name("passes/lambda")->Apply(allSizes);
BENCHMARK(correction)->Name("passes/correction")->Apply(allSizes);
BENCHMARK(viscosity)->Name("passes/viscosity")->Apply(oneSize);

}  // namespace
}  // namespace ice_ice_baby::bench
