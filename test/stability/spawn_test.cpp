// Starts that a scene file may not have. scripts/stability checks that files with them are refused;
// here they are made in code, as water may be crowded later too. Each test is a row of
// doc/stability.md.
#include <set>

#include "../core/fixtures.h"
#include "../core/unchecked.h"
#include "resident_memory.h"
#include "watched_run.h"

namespace ice_ice_baby {
namespace {

using test::blockOf;
using test::stabilityScene;
using test::unchecked;
using test::WatchedRun;

constexpr double kSpacing_m = 0.05;  ///< of the scene

class Spawns : public test::SuiteCase {};

Block pointAt(const Vec3d& x) {
  const Vec3d half = Vec3d::Constant(kSpacing_m / 2);
  return blockOf(x - half, x + half);
}

/// The splash with other water.
Scene splashOf(const std::vector<Block>& blocks) {
  Scene scene = stabilityScene("splash");
  scene.blocks = blocks;
  return scene;
}

double nearest_m(const WatchedRun& run, const Vec3d& centre) {
  double min_m = std::numeric_limits<double>::max();
  for (const ParticleSample& p : run.particles()) {
    min_m = std::min(min_m, (Vec3d(p.x, p.y, p.z) - centre).norm());
  }
  return min_m;
}

TEST_F(Spawns, AllCoincidentOnAnyThreads) {
  line(3, "The same, made in code",
       "they separate in the same way in every run and reach their density");
  const Scene scene = splashOf(std::vector<Block>(1000, pointAt({0, 0, 0.3})));
  std::set<std::uint64_t> hashes;
  for (const int threads : {1, 2}) {
    WatchedRun run(figures_, unchecked(scene, threads));
    run.frames(180);
    hashes.insert(run->stateHash());
    EXPECT_LT(run.densityError(), 0.02);
  }
  EXPECT_EQ(hashes.size(), 1u);
}

TEST_F(Spawns, NearlyCoincidentPairInCode) {
  line(4, "The same, made in code", "bounded corrections");
  Scene scene = splashOf({pointAt({0, 0, 0.3}), pointAt({1e-12, 0, 0.3})});
  scene.gravity_m_s2.setZero();
  scene.solver.max_speed_m_s = 1e5;
  // Two corrections of a tenth of the support radius and the separation itself, 360 times a second.
  const double bound_m_s = (2 * 0.1 * 2 + 0.02) * kSpacing_m * 360;
  WatchedRun single(figures_, unchecked(scene, 1));
  WatchedRun twice(figures_, std::make_unique<Simulator<double>>(scene, 1));
  for (WatchedRun* run : {&single, &twice}) {
    run->frames(60);
    EXPECT_LT(run->fastest_m_s(), bound_m_s);
  }
}

TEST_F(Spawns, CentreOfASphereInCode) {
  line(5, "The same, made in code", "pushed out along a fixed normal, not pulled back");
  const auto deepest_d = [&](std::unique_ptr<Simulation> simulation, const Vec3d& centre) {
    WatchedRun run(figures_, std::move(simulation));
    run.frames(60);
    return (0.1 + kSpacing_m / 2 - nearest_m(run, centre)) / kSpacing_m;
  };
  Scene scene = stabilityScene("splash");
  scene.spheres = {test::ball({-0.3, 0, 0.4}, 0.1)};
  EXPECT_LT(deepest_d(unchecked(scene, 1), scene.spheres[0].position_m), 1e-3);
  scene.spheres[0].position_m = {0, 0, 0.3};
  scene.blocks = {pointAt({0, 0, 0.3})};
  EXPECT_LT(deepest_d(unchecked(scene, 1), {0, 0, 0.3}), 1e-3);
  EXPECT_LT(deepest_d(std::make_unique<Simulator<double>>(scene, 1), {0, 0, 0.3}), 1e-3);
}

TEST_F(Spawns, TooFullInCode) {
  line(6, "The same, made in code with an eighth of the million", "reported, none outside");
  Scene full = splashOf(std::vector<Block>(8, blockOf({-0.25, -0.25, 0}, {0.25, 0.25, 0.5})));
  full.containers[0].size_m = Vec3d::Constant(0.5);
  {
    WatchedRun run(figures_, unchecked(full, 1));
    run.frames(test::repeats(15));
    EXPECT_GT(run.densityError(), 6.0);
  }
  Scene crowd = splashOf(std::vector<Block>(2, blockOf({-0.5, -0.5, 0}, {0.5, 0.5, 0.5})));
  crowd.fluid.spacing_m = 0.02;
  crowd.containers[0].size_m = {1, 1, 0.5};
  crowd.solver.substeps = 1;
  crowd.solver.iterations = 1;
  WatchedRun run(figures_, unchecked(crowd, 1));
  run.frame();
  EXPECT_EQ(run.particles().size(), 125000u);
}

TEST_F(Spawns, TenThousandInACellInCode) {
  line(22, "The same, made in code", "bounded memory, none out");
  Scene scene = splashOf({});
  scene.containers[0].size_m = {1.6, 1, 2};
  for (int k = 0; k < 10000; ++k) {
    const Vec3d step(k % 10, k / 10 % 10, k / 100 % 10);
    scene.blocks.push_back(pointAt(Vec3d(-0.3, -0.1, 0.3) + 0.002 * step));
    scene.blocks.back().rpy_deg = {0, 0, 9.0 * (k / 1000)};
  }
  WatchedRun run(figures_, unchecked(scene, 1));
  run.frames(6);
  EXPECT_LT(peakResidentBytes(), std::size_t(4) << 30);
}

TEST_F(Spawns, OverlappingSpawnInCode) {
  line(23, "The same, made in code", "it relaxes");
  const Block block = blockOf({-0.5, -0.25, 0.1}, {-0.1, 0.25, 0.7});
  const Block shifted = blockOf({-0.475, -0.25, 0.1}, {-0.075, 0.225, 0.7});
  for (const Block& other : {block, shifted}) {
    WatchedRun run(figures_, unchecked(splashOf({block, other}), 1));
    run.frames(90);
    EXPECT_LT(run.densityError(), 0.02);
  }
}

TEST_F(Spawns, GapsInCode) {
  line(17,
       "The same, made in code: a sphere lowered onto the floor, two particles in space for one",
       "contained");
  Scene scene = stabilityScene("splash");
  scene.spheres = {test::ball({-0.3, 0, 0.17}, 0.15)};
  {
    WatchedRun run(figures_, unchecked(scene, 1));
    run.frames(60);
  }
  Scene cell = splashOf({pointAt({0, 0, 0.02}), pointAt({0, 0, 0.022})});
  cell.containers[0].size_m = Vec3d::Constant(0.03);
  WatchedRun run(figures_, unchecked(cell, 1));
  run.frames(60);
}

}  // namespace
}  // namespace ice_ice_baby
