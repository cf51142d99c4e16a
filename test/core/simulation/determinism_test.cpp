// Whole scenes give the same bits in every run, on any number of threads, whatever is sampled. A
// program of its own, as it is what ThreadSanitizer checks.
#include <gtest/gtest.h>

#include "fixtures.h"
#include "ice_ice_baby/simulation.h"
#include "thermal/kettle.h"

namespace ice_ice_baby {
namespace {

using test::splash;

void run(Simulation& simulation, int frames) {
  for (int k = 0; k < frames; ++k) simulation.advanceFrame();
}

Scene freezingSplash(Preset preset) {
  Scene scene;
  applyPreset(scene, preset, 0.05);
  const Scene shapes = splash();
  scene.fluid.spacing_m = shapes.fluid.spacing_m;
  scene.blocks = shapes.blocks;
  scene.containers = shapes.containers;
  scene.schedule = {{0.15, -10, 0.2}, {0.5, 20, 0.1}};
  return scene;
}

TEST(DeterminismTest, AFreezingSplashGivesTheSameBitsOnOneTwoAndFourThreads) {
  for (const Preset preset : {Preset::kDefault, Preset::kPaper}) {
    for (const Precision precision : {Precision::kFloat, Precision::kDouble}) {
      std::vector<std::uint64_t> hashes;
      std::size_t springs = 0;
      for (const int threads : {1, 2, 4}) {
        const auto simulation = makeSimulation(freezingSplash(preset), precision, threads);
        run(*simulation, 24);
        springs = simulation->report().springs;
        run(*simulation, 21);
        hashes.push_back(simulation->stateHash());
      }
      EXPECT_GT(springs, 0u);
      EXPECT_EQ(hashes[0], hashes[1]);
      EXPECT_EQ(hashes[0], hashes[2]);
    }
  }
}

TEST(DeterminismTest, IceInAKettleGivesTheSameBitsOnOneTwoAndFourThreads) {
  const Scene scene = test::iceInKettle();
  for (const Precision precision : {Precision::kFloat, Precision::kDouble}) {
    std::vector<std::uint64_t> hashes;
    for (const int threads : {1, 2, 4}) {
      const auto simulation = makeSimulation(scene, precision, threads);
      run(*simulation, 60);
      hashes.push_back(simulation->stateHash());
    }
    EXPECT_EQ(hashes[0], hashes[1]);
    EXPECT_EQ(hashes[0], hashes[2]);
  }
}

TEST(DeterminismTest, TwoRunsGiveTheSameBitsAndAskingChangesNothing) {
  const auto quiet = makeSimulation(freezingSplash(Preset::kDefault));
  const auto asked = makeSimulation(freezingSplash(Preset::kDefault));
  std::vector<SpringSample> springs;
  std::vector<ParticleSample> samples;
  for (int k = 0; k < 30; ++k) {
    quiet->advanceFrame();
    asked->advanceFrame();
    asked->sampleSprings(springs, 10);
    asked->sample(samples);
  }
  EXPECT_EQ(quiet->stateHash(), asked->stateHash());
}

}  // namespace
}  // namespace ice_ice_baby
