// Particles that come and go in mid-run, as from a tap and down a drain, through every stage that a
// scene may have.
#include <gtest/gtest.h>

#include <set>
#include <tuple>

#include "ice_ice_baby/checkpoint.h"
#include "ice_ice_baby/errors.h"
#include "simulation/simulator.h"
#include "simulation/stories.h"

namespace ice_ice_baby {
namespace coming_and_going_test {

using test::blockOf;
using test::Story;

/// A story into which particles come, and out of which others go.
struct Traffic {
  Story story;
  Vec3d tap_m;     ///< where there is room for 2 x 2 x 2 particles
  double celsius;  ///< of what comes
  double drain_m;  ///< what is below goes, in two of the frames
  int frames = 24;

  friend std::ostream& operator<<(std::ostream& out, const Traffic& traffic) {
    return out << traffic.story.name;
  }
};

Traffic traffic(Story story, const Vec3d& tap_m, double celsius, double drain_m) {
  return {std::move(story), tap_m, celsius, drain_m};
}

std::uint32_t openTap(Simulator<float>& simulator, const Vec3d& at_m, double celsius) {
  const std::vector<Vec3d> drops = test::lattice(2, simulator.scene().fluid.spacing_m, at_m);
  return simulator.addParticles(drops, std::vector<Vec3d>(drops.size(), {0.1, 0, -0.2}), celsius);
}

/// What happens before frame `frame`, the commands of the story included.
void act(const Traffic& traffic, Simulator<float>& simulator, int frame) {
  traffic.story.act(simulator, frame);
  if (frame % 9 == 4) openTap(simulator, traffic.tap_m, traffic.celsius);
  if (frame == 7) {
    simulator.removeParticles([](std::uint32_t id, const Vec3d&) { return id % 7 == 3; });
  }
  if (frame == 12 || frame == 13) {
    simulator.removeParticles(
        [&](std::uint32_t, const Vec3d& x) { return x.z() < traffic.drain_m; });
  }
  if (frame == 13) openTap(simulator, traffic.tap_m + Vec3d(0, 0, 0.1), 20.0);
}

void run(const Traffic& traffic, Simulator<float>& simulator, int first, int last) {
  for (int frame = first; frame < last; ++frame) {
    act(traffic, simulator, frame);
    simulator.advanceFrame();
  }
}

Traffic kettle(double compliance_m_n) {
  Story story = test::kettleStory(compliance_m_n);
  story.act = [act = story.act](Simulation& simulation, int frame) {
    act(simulation, frame + 3);  // so that all of it happens in a short run
  };
  return traffic(story, {-0.02, -0.02, 0.25}, -15.0, 0.02);
}

Traffic frozenTank() {
  Story story{"frozen", test::splash()};
  story.scene.temperature.initial_c = 20.0;
  story.scene.schedule = {{0.02, -10, 0.05}};
  return traffic(story, {0.2, 0.0, 0.5}, 20.0, 0.15);
}

std::vector<Traffic> allTraffic() {
  return {traffic({"water", test::splash()}, {0.2, 0.0, 0.7}, 20.0, 0.08),
          traffic(test::sheetStory(), {-0.05, 0.0, 0.8}, 20.0, 0.35),
          traffic(test::targetStory(), {0.2, 0.0, 0.7}, 20.0, 0.08),
          frozenTank(),
          kettle(0.0),
          kettle(1e-6),
          traffic(test::hailStory(), {0.2, -0.2, 0.3}, -20.0, 0.03),
          traffic(test::coldTankStory(), {-0.02, -0.02, 0.15}, 0.2, 0.01),
          traffic(test::jumpStory(), {-0.1, 0.0, 0.45}, -5.0, 0.02)};
}

std::vector<ParticleSample> samplesOf(const Simulation& simulation) {
  std::vector<ParticleSample> samples;
  simulation.sample(samples);
  return samples;
}

void expectWhole(const Simulator<float>& simulator, std::size_t particles) {
  const std::vector<ParticleSample> samples = samplesOf(simulator);
  ASSERT_EQ(samples.size(), particles);
  ASSERT_EQ(simulator.report().particles, particles);
  ASSERT_EQ(simulator.report().non_finite, 0U);
  for (std::size_t k = 0; k < samples.size(); ++k) {
    const ParticleSample& s = samples[k];
    ASSERT_TRUE(k == 0 || samples[k - 1].id < s.id) << "ordered by id, each once";
    for (const float value : {s.x, s.y, s.z, s.vx, s.vy, s.vz, s.temperature_c, s.ice_fraction,
                              s.density, s.pressure_pa}) {
      ASSERT_TRUE(std::isfinite(value)) << s.id;
    }
  }
}

class ComingAndGoingTest : public testing::TestWithParam<Traffic> {};

TEST_P(ComingAndGoingTest, EveryParticleIsCountedAndFiniteAndNoIdIsUsedTwice) {
  Simulator<float> simulator(GetParam().story.scene, 2);
  std::set<std::uint32_t> ids, gone;
  for (int frame = 0; frame < GetParam().frames; ++frame) {
    act(GetParam(), simulator, frame);
    std::set<std::uint32_t> now;
    for (const ParticleSample& s : samplesOf(simulator)) now.insert(s.id);
    for (const std::uint32_t id : now) ASSERT_EQ(gone.count(id), 0U) << "used twice";
    for (const std::uint32_t id : ids) {
      if (now.count(id) == 0) gone.insert(id);
    }
    ids = now;
    expectWhole(simulator, ids.size());
    simulator.advanceFrame();
    expectWhole(simulator, ids.size());
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(gone.size(), 0U);
}

TEST_P(ComingAndGoingTest, HasTheSameBitsOnOneTwoAndFourThreads) {
  std::vector<std::uint64_t> hashes;
  for (const int threads : {1, 2, 4}) {
    Simulator<float> simulator(GetParam().story.scene, threads);
    run(GetParam(), simulator, 0, GetParam().frames);
    hashes.push_back(simulator.stateHash());
  }
  EXPECT_EQ(hashes[0], hashes[1]);
  EXPECT_EQ(hashes[0], hashes[2]);
}

std::unique_ptr<Simulation> reloaded(const Simulation& simulation, int threads) {
  return decodeCheckpoint(encodeCheckpoint(simulation), "memory", threads);
}

/// Saved both before and after a frame in which particles came or went.
TEST_P(ComingAndGoingTest, ACheckpointInBetweenGoesOnWithTheSameBits) {
  const Traffic& traffic = GetParam();
  Simulator<float> whole(traffic.story.scene, 1);
  std::vector<std::unique_ptr<Simulation>> others;
  for (int frame = 0; frame < traffic.frames; ++frame) {
    act(traffic, whole, frame);
    for (const auto& other : others) act(traffic, dynamic_cast<Simulator<float>&>(*other), frame);
    if (frame == 7 || frame == 13) others.push_back(reloaded(whole, 2));
    ASSERT_EQ(reloaded(whole, 1)->stateHash(), whole.stateHash()) << frame;
    whole.advanceFrame();
    for (const auto& other : others) other->advanceFrame();
    if (frame == 4 || frame == 12) others.push_back(reloaded(whole, 2));
  }
  ASSERT_EQ(others.size(), 4U);
  for (const auto& other : others) EXPECT_EQ(other->stateHash(), whole.stateHash());
}

/// Momentum of a particle is its velocity, mass its number.
TEST_P(ComingAndGoingTest, NothingElseChangesInTheMoment) {
  const Traffic& traffic = GetParam();
  Simulator<float> simulator(traffic.story.scene, 1);
  run(traffic, simulator, 0, 11);
  const auto enthalpy_j = [&] {
    return simulator.phaseChange() ? simulator.phaseChange()->heat()->totalEnthalpy_j() : 0.0;
  };
  const auto expectSame = [](const ParticleSample& a, const ParticleSample& b) {
    ASSERT_EQ(a.id, b.id);
    ASSERT_EQ(std::make_tuple(a.x, a.y, a.z, a.vx, a.vy, a.vz, a.temperature_c, a.ice_fraction),
              std::make_tuple(b.x, b.y, b.z, b.vx, b.vy, b.vz, b.temperature_c, b.ice_fraction));
  };
  const std::vector<ParticleSample> before = samplesOf(simulator);
  const double enthalpy_before_j = enthalpy_j();

  const std::uint32_t first = openTap(simulator, traffic.tap_m, traffic.celsius);
  const std::vector<ParticleSample> more = samplesOf(simulator);
  ASSERT_EQ(more.size(), before.size() + 8);
  for (std::size_t k = 0; k < before.size(); ++k) expectSame(before[k], more[k]);
  for (std::size_t k = before.size(); k < more.size(); ++k) {
    EXPECT_EQ(more[k].id, first + (k - before.size()));
    EXPECT_EQ(more[k].vz, -0.2f);
  }
  if (simulator.phaseChange()) {
    const Scene& scene = simulator.scene();
    const double each_j = particleMass_kg(scene.fluid, scene.supportRadius_m()) *
                          EnthalpyCurve(scene.thermal).enthalpy(traffic.celsius);
    EXPECT_NEAR(enthalpy_j() - enthalpy_before_j, 8 * each_j, 1e-12 * std::abs(enthalpy_before_j));
  }

  const std::size_t went =
      simulator.removeParticles([&](std::uint32_t id, const Vec3d&) { return id >= first; });
  EXPECT_EQ(went, 8U);
  const std::vector<ParticleSample> after = samplesOf(simulator);
  ASSERT_EQ(after.size(), before.size());
  for (std::size_t k = 0; k < before.size(); ++k) expectSame(before[k], after[k]);
  EXPECT_NEAR(enthalpy_j(), enthalpy_before_j, 1e-12 * std::abs(enthalpy_before_j));
}

INSTANTIATE_TEST_SUITE_P(In, ComingAndGoingTest, testing::ValuesIn(allTraffic()),
                         [](const auto& made) { return made.param.story.name; });

TEST(ComingAndGoing, NothingChangesWhereNobodyComesOrGoes) {
  Simulator<float> simulator(test::splash(), 1);
  simulator.advanceFrame();
  const std::uint64_t hash = simulator.stateHash();
  EXPECT_EQ(simulator.addParticles({}, {}, 20.0), simulator.particles().size());
  EXPECT_EQ(simulator.removeParticles([](std::uint32_t, const Vec3d&) { return false; }), 0U);
  EXPECT_EQ(simulator.stateHash(), hash);
}

TEST(ComingAndGoing, ATankRunsEmptyAndFillsAgain) {
  for (const bool heat : {false, true}) {
    Scene scene = test::splash();
    scene.thermal.enabled = heat;
    scene.blocks[0].celsius = heat ? -5.0 : 20.0;
    Simulator<float> simulator(scene, 1);
    simulator.advanceFrame();
    const std::size_t particles = simulator.particles().size();
    EXPECT_EQ(simulator.removeParticles([](std::uint32_t, const Vec3d&) { return true; }),
              particles);
    expectWhole(simulator, 0);
    simulator.advanceFrame();
    const auto empty = reloaded(simulator, 1);
    EXPECT_EQ(empty->stateHash(), simulator.stateHash());
    for (Simulator<float>* one : {&simulator, dynamic_cast<Simulator<float>*>(empty.get())}) {
      EXPECT_EQ(openTap(*one, {0, 0, 0.3}, -5.0), particles) << "ids go on where they ended";
      for (int k = 0; k < 5; ++k) one->advanceFrame();
      expectWhole(*one, 8);
    }
    EXPECT_EQ(empty->stateHash(), simulator.stateHash());
    EXPECT_EQ(simulator.report().ice_particles, heat ? 8U : 0U);
  }
}

/// A bar in free flight whose middle goes is two bodies, which fly on as they did.
TEST(ComingAndGoing, IceWhoseMiddleGoesIsTwoBodies) {
  Scene scene = test::heated(0.02);
  scene.gravity_m_s2.setZero();
  scene.thermal.air_heat_transfer_w_m2k = 0.0;
  scene.blocks = {blockOf({-0.1, 0, 0}, {0.1, 0.04, 0.04})};
  scene.blocks[0].celsius = -20.0;
  scene.blocks[0].velocity_m_s = {1, 0, 0};
  scene.blocks[0].angular_velocity_rad_s = {0, 0, 3};
  Simulator<float> simulator(scene, 1);
  simulator.advanceFrame();
  ASSERT_EQ(simulator.report().ice_bodies, 1U);
  const auto& particles = simulator.particles();
  const double middle = simulator.report().time_s;
  const std::size_t went = simulator.removeParticles(
      [&](std::uint32_t, const Vec3d& x) { return std::abs(x.x() - middle) < 0.035; });
  ASSERT_GT(went, 0U);
  const Vec3d momentum = test::sumOf(particles.velocity);
  simulator.advanceFrame();
  EXPECT_EQ(simulator.report().ice_bodies, 2U);
  EXPECT_EQ(simulator.report().ice_particles, particles.size());
  EXPECT_LT((test::sumOf(particles.velocity) - momentum).norm(), 1e-4 * double(particles.size()));
}

TEST(ComingAndGoing, WhatComesIntoFrozenWaterFreezesToIt) {
  Scene scene = test::floatingCube(3);
  scene.temperature.initial_c = -10.0;
  Simulator<float> simulator(scene, 1);
  simulator.advanceFrame();
  const std::size_t springs = simulator.report().springs;
  simulator.addParticles({{0.075, 0.075, 0.175}}, {Vec3d::Zero()}, 20.0);
  EXPECT_GT(simulator.report().springs, springs);
  simulator.removeParticles([](std::uint32_t id, const Vec3d&) { return id == 27; });
  EXPECT_EQ(simulator.report().springs, springs);
}

TEST(ComingAndGoing, NonsenseIsRefusedAndChangesNothing) {
  Scene scene = test::floatingCube(2);
  scene.limits.max_particles = 10;
  Simulator<float> simulator(scene, 1);
  simulator.advanceFrame();
  const std::uint64_t hash = simulator.stateHash();
  const Vec3d zero = Vec3d::Zero(), nan = Vec3d::Constant(std::nan(""));
  const Vec3d fast = Vec3d::Constant(2 * scene.solver.max_speed_m_s);
  const auto refused = [&](const std::vector<Vec3d>& x, const std::vector<Vec3d>& v, double c) {
    EXPECT_THROW(simulator.addParticles(x, v, c), InvalidInput);
    EXPECT_EQ(simulator.stateHash(), hash);
  };
  refused({zero}, {}, 20.0);
  refused({nan}, {zero}, 20.0);
  refused({Vec3d::Constant(1e9)}, {zero}, 20.0);
  refused({zero}, {nan}, 20.0);
  refused({zero}, {fast}, 20.0);
  refused({zero}, {zero}, -300.0);
  refused({zero}, {zero}, std::nan(""));
  refused({zero, zero, zero}, {zero, zero, zero}, 20.0);  // the cube has 8 of at most 10
}

}  // namespace coming_and_going_test
}  // namespace ice_ice_baby
