// A scene pays only for what it contains: stages, memory and allocations, counted, not timed.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <map>
#include <new>

#include "fixtures.h"
#include "ice_ice_baby/simulation.h"

namespace {

std::atomic<std::uint64_t> allocations{0};

void* countedOrNull(std::size_t size, std::size_t alignment) {
  ++allocations;
  const std::size_t rounded = (size + alignment - 1) / alignment * alignment;
  return std::aligned_alloc(alignment, rounded);
}

void* counted(std::size_t size, std::size_t alignment) {
  void* memory = countedOrNull(size, alignment);
  if (!memory) throw std::bad_alloc();
  return memory;
}

}  // namespace

// Counts every allocation of this program but direct calls of malloc.
void* operator new(std::size_t size) { return counted(size, alignof(std::max_align_t)); }
void* operator new[](std::size_t size) { return counted(size, alignof(std::max_align_t)); }
void* operator new(std::size_t size, std::align_val_t a) { return counted(size, std::size_t(a)); }
void* operator new[](std::size_t size, std::align_val_t a) { return counted(size, std::size_t(a)); }
// std::stable_partition uses this one. The default calls the one above, but a sanitizer's does
// not.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  return countedOrNull(size, alignof(std::max_align_t));
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

namespace ice_ice_baby {
namespace {

using Names = std::vector<std::string>;

/// Water alone: no walls, no gravity, no viscosity.
Scene waterOnly() {
  Scene scene = test::floatingCube(8);
  scene.solver.viscosity_1_s = 0.0;
  return scene;
}

std::unique_ptr<Simulation> ran(const Scene& scene, int frames, int threads = 1) {
  auto simulation = makeSimulation(scene, Precision::kFloat, threads);
  for (int k = 0; k < frames; ++k) simulation->advanceFrame();
  return simulation;
}

Names namesOf(const Simulation& simulation) {
  Names names;
  for (const StageStats& stage : simulation.stages()) names.push_back(stage.name);
  return names;
}

std::map<std::string, StageStats> byName(const Simulation& simulation) {
  std::map<std::string, StageStats> stages;
  for (const StageStats& stage : simulation.stages()) stages[stage.name] = stage;
  return stages;
}

std::size_t bytesOf(const Simulation& simulation) {
  std::size_t bytes = 0;
  for (const StageStats& stage : simulation.stages()) bytes += stage.bytes;
  return bytes;
}

TEST(PayOnly, WaterAloneHasTheStagesOfWaterAlone) {
  EXPECT_EQ(namesOf(*ran(waterOnly(), 2)), (Names{"predict", "neighbours", "lambda", "delta_p",
                                                  "position", "velocity", "report"}));
}

TEST(PayOnly, EachThingOfASceneBringsItsOwnStageAndNoOther) {
  Scene viscous = waterOnly();
  viscous.solver.viscosity_1_s = 30.0;
  EXPECT_EQ(namesOf(*ran(viscous, 2)), (Names{"predict", "neighbours", "lambda", "delta_p",
                                              "position", "velocity", "viscosity", "report"}));
  Scene walled = test::fullTank(8);
  walled.solver.viscosity_1_s = 0.0;
  EXPECT_EQ(namesOf(*ran(walled, 2)),
            (Names{"predict", "coarse_level", "neighbours", "lambda", "delta_p", "collide",
                   "position", "velocity", "report"}));
  walled.solver.coarse_level = false;
  EXPECT_EQ(namesOf(*ran(walled, 2)), (Names{"predict", "neighbours", "lambda", "delta_p",
                                             "collide", "position", "velocity", "report"}));
}

TEST(PayOnly, EveryStageRunsAsOftenAsTheSettingSays) {
  Scene scene = test::fullTank(6);
  scene.solver.substeps = 5;
  scene.solver.iterations = 3;
  const auto simulation = ran(scene, 4);
  auto stages = byName(*simulation);
  for (const char* name : {"predict", "neighbours", "velocity", "viscosity"}) {
    EXPECT_EQ(stages[name].calls, 4u * 5) << name;
  }
  // Colliders that do not move are handled once an iteration, like the pressure.
  for (const char* name : {"lambda", "delta_p", "collide", "position"}) {
    EXPECT_EQ(stages[name].calls, 4u * 5 * 3) << name;
  }
  EXPECT_EQ(stages["report"].calls, 4u);
}

TEST(PayOnly, WhatASceneLacksTakesNoMemory) {
  const auto bare = ran(waterOnly(), 3);
  const std::size_t particles = bare->report().particles;
  auto stages = byName(*bare);

  Scene viscous = waterOnly();
  viscous.solver.viscosity_1_s = 30.0;
  const auto with_viscosity = ran(viscous, 3);
  EXPECT_EQ(bytesOf(*bare) + byName(*with_viscosity)["viscosity"].bytes, bytesOf(*with_viscosity));

  // A collider far from the water adds only its arrays.
  Scene walled = waterOnly();
  walled.planes.emplace_back();
  walled.planes[0].position_m.z() = -5;
  auto with_walls = byName(*ran(walled, 3));
  walled.fluid.boundary_density = false;
  auto without_density = byName(*ran(walled, 3));
  EXPECT_EQ(without_density["lambda"].bytes, stages["lambda"].bytes);
  EXPECT_GE(with_walls["lambda"].bytes, stages["lambda"].bytes + 3 * sizeof(float) * particles);
  EXPECT_GT(with_walls["collide"].bytes, 0u);
  EXPECT_LT(with_walls["collide"].bytes, 1000u) << "grows with the colliders, not the particles";
}

TEST(PayOnly, WaterTakesAtMost600BytesAParticle) {
  Scene pool = test::fullTank(20);
  EXPECT_LT(double(bytesOf(*ran(pool, 10))) / 8000, 600.0);
}

TEST(PayOnly, MeltedWaterCostsWhatWaterNeverFrozenDoes) {
  const auto water = ran(test::fullTank(6), 3);
  const auto melted = ran(test::fullTank(6), 1);
  melted->setTemperature(-10, 0);
  melted->advanceFrame();
  ASSERT_GT(byName(*melted)["make_springs"].bytes, 0u);
  melted->setTemperature(20, 0);
  melted->advanceFrame();
  EXPECT_EQ(namesOf(*melted), namesOf(*water));
  EXPECT_EQ(melted->report().springs, 0u);
}

/// A cube in which every particle has its own temperature.
Scene heated(double celsius) {
  Scene scene = test::floatingCube(6);
  scene.thermal.enabled = true;
  scene.blocks[0].celsius = celsius;
  return scene;
}

TEST(PayOnly, HeatBringsItsStagesAndIceItsOwn) {
  const Names water{"predict",  "neighbours", "lambda", "delta_p", "position",
                    "velocity", "viscosity",  "heat",   "phases",  "report"};
  EXPECT_EQ(namesOf(*ran(heated(20.0), 2)), water);
  const Names ice{"predict",    "neighbours", "ice_contacts", "lambda", "delta_p", "position",
                  "ice_bodies", "velocity",   "viscosity",    "heat",   "phases",  "report"};
  EXPECT_EQ(namesOf(*ran(heated(-5.0), 2)), ice);
  Scene elastic = heated(-5.0);
  elastic.ice.compliance_m_n = 1e-6;
  const Names soft{"predict",  "neighbours", "lambda", "delta_p", "correct_springs", "position",
                   "velocity", "viscosity",  "heat",   "phases",  "report"};
  EXPECT_EQ(namesOf(*ran(elastic, 2)), soft);
}

TEST(PayOnly, HeatWaitsAsLongAsOnePassCovers) {
  auto slow = byName(*ran(heated(20.0), 60));
  EXPECT_LE(slow["heat"].calls, 11u) << "a tenth of a second between passes";
  Scene fast = heated(20.0);
  fast.thermal.speedup = 1e5;
  EXPECT_EQ(byName(*ran(fast, 60))["heat"].calls, 60u);
}

/// Allocations in 30 frames, after a warm-up in which every array reaches its size.
std::uint64_t steadyAllocations(const Scene& scene, int warm_up_frames, int threads) {
  const auto simulation = ran(scene, warm_up_frames, threads);
  const std::uint64_t before = allocations;
  for (int k = 0; k < 30; ++k) simulation->advanceFrame();
  return allocations - before;
}

TEST(PayOnly, TheCounterCounts) {
  const std::uint64_t before = allocations;
  const auto made = std::make_unique<std::vector<int>>(3);
  EXPECT_EQ(allocations - before, 2u);
  delete new (std::nothrow) int;
  EXPECT_EQ(allocations - before, 3u);
}

class SteadyState : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Threads, SteadyState, testing::Values(1, 2));

TEST_P(SteadyState, OfAStillPoolAllocatesNothing) {
  EXPECT_EQ(steadyAllocations(test::fullTank(10, true), 10, GetParam()), 0u);
}

TEST_P(SteadyState, OfASplashAllocatesNothing) {
  EXPECT_EQ(steadyAllocations(test::splash(), 30, GetParam()), 0u);
}

TEST_P(SteadyState, OfFrozenWaterAllocatesNothing) {
  Scene scene = test::fullTank(6);
  scene.temperature.initial_c = -10.0;
  scene.springs.sleep_speed_m_s = 0.0;
  EXPECT_EQ(steadyAllocations(scene, 5, GetParam()), 0u);
}

}  // namespace
}  // namespace ice_ice_baby
