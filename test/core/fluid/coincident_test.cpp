// Particles at the same point: spawned twice, or clamped into the same corner.
#include <gtest/gtest.h>

#include <array>
#include <set>

#include "fixtures.h"
#include "metrics/density_meter.h"
#include "unchecked.h"

namespace ice_ice_baby {
namespace coincident_test {

std::size_t countDuplicates(const Simulation& simulation) {
  std::vector<ParticleSample> samples;
  simulation.sample(samples);
  std::set<std::array<float, 3>> places;
  for (const ParticleSample& s : samples) places.insert({s.x, s.y, s.z});
  return samples.size() - places.size();
}

TEST(CoincidentTest, ABlockSpawnedTwiceSeparatesToRestDensity) {
  Scene scene = test::splash();
  scene.blocks.push_back(scene.blocks.front());
  const auto simulation = test::unchecked(scene, 1);
  ASSERT_EQ(countDuplicates(*simulation), 0U) << "displaced before the first step";
  for (int frame = 0; frame < 120; ++frame) simulation->advanceFrame();
  EXPECT_EQ(countDuplicates(*simulation), 0U);
  EXPECT_LT(measureDensityError(*simulation).mean, 0.02);
}

TEST(CoincidentTest, ParticlesThatFallAsOnePointSeparateToRestDensity) {
  Scene scene = test::floatingCube(1);
  scene.gravity_m_s2 = Vec3d(0, 0, -9.81);
  for (int k = 0; k < 49; ++k) scene.blocks.push_back(scene.blocks.front());
  const auto simulation = test::unchecked(scene, 1);
  for (int frame = 0; frame < 60; ++frame) simulation->advanceFrame();
  EXPECT_EQ(countDuplicates(*simulation), 0U);
  EXPECT_LT(measureDensityError(*simulation).mean, 0.02);
}

TEST(CoincidentTest, SeparationIsTheSameOnAnyNumberOfThreads) {
  Scene scene = test::splash();
  scene.blocks.push_back(scene.blocks.front());
  const auto hashAfter = [&](int threads) {
    const auto simulation = test::unchecked(scene, threads);
    for (int frame = 0; frame < 10; ++frame) simulation->advanceFrame();
    return simulation->stateHash();
  };
  EXPECT_EQ(hashAfter(1), hashAfter(2));
}

}  // namespace coincident_test
}  // namespace ice_ice_baby
