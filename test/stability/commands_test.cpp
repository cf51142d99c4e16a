// Extreme commands during a run. Each test is a row of doc/stability.md, named by its properties
// `number`, `title` and `expected`. Commands that are refused: test/core/loading/refusals_test.cpp.
#include <cmath>

#include "../core/fixtures.h"
#include "watched_run.h"

namespace ice_ice_baby {
namespace {

using test::Random;
using test::stabilityScene;
using test::WatchedRun;

class Commands : public test::SuiteCase {};

/// Alternates at 30 Hz between the two temperatures for two seconds, from the middle of a splash.
void alternate(WatchedRun& run, double cold_c, double warm_c) {
  run.frames(25);
  for (int half = 0; half < test::repeats(120); ++half) {
    run->setTemperature(half % 2 == 0 ? cold_c : warm_c, 0.0);
    run.frame();
    EXPECT_LE(run->report().springs, 20 * run->report().particles);
  }
}

TEST_F(Commands, FreezeAndThawOfSpringsAt30Hz) {
  line(8, "Springs frozen and thawed thirty times per second", "springs bounded, no energy gained");
  WatchedRun run(figures_, stabilityScene("splash"));
  alternate(run, -10, 20);
  EXPECT_LT(run.metric("energy_rise"), 1e-3);
  EXPECT_LT(run.fastest_m_s(), 10.0);
}

TEST_F(Commands, FreezeAndThawByHeatAt30Hz) {
  line(8, "Water frozen and thawed by heat thirty times per second",
       "springs bounded, no energy gained");
  WatchedRun run(figures_, stabilityScene("frost", {{"thermal.speedup", "1e6"}}));
  alternate(run, -200, 200);
  EXPECT_LT(run.metric("energy_rise"), 1e-3);
  EXPECT_LT(run.fastest_m_s(), 10.0);
}

TEST_F(Commands, GravityThatFlipsEveryFrame) {
  line(15, "Gravity that flips every frame, up to 10,000 m/s²", "contained");
  for (const char* scene : {"splash", "iceberg", "hail"}) {
    WatchedRun run(figures_, stabilityScene(scene));
    for (int k = 0; k < test::repeats(60); ++k) {
      const double size = k < test::repeats(30) ? 9.81 : 1e4;
      run->setGravity(Vec3d(0, 0, k % 2 == 0 ? size : -size));
      run.frame();
    }
    run->setGravity(Vec3d(0, 0, -9.81));
    run.frames(test::repeats(30));
  }
}

TEST_F(Commands, AContainerThatJumps) {
  line(16, "A closed tank jumps by up to 100 m within a frame, turning", "the contents move along");
  const Override wide{"bounds", "{min_m: [-100, -100, -100], max_m: [100, 100, 100]}"};
  for (const char* scene : {"splash", "iceberg", "hail"}) {
    WatchedRun run(figures_, stabilityScene(scene, {wide}));
    const std::string name = run->scene().containers[0].name;
    Random random(5);
    run.frames(20);
    for (int k = 0; k < test::repeats(12); ++k) {
      const Vec3d place = random.inBox(Vec3d::Constant(-50), Vec3d::Constant(50));
      const Vec3d turn = random.inBox(Vec3d::Constant(-180), Vec3d::Constant(180));
      run->moveCollider(name, poseOf(place, turn));
      run.frames(5);
    }
    // Viscosity acts after the limit, and in water that is too dense it adds a little.
    EXPECT_LE(run.fastest_m_s(), 1.05 * run->scene().solver.max_speed_m_s);
  }
}

TEST_F(Commands, AContainerThatShakes) {
  line(0, "A closed tank shaken by tenths of a metre every frame, turning", "all stay inside");
  for (const char* scene : {"splash", "iceberg", "hail"}) {
    WatchedRun run(figures_, stabilityScene(scene));
    const std::string name = run->scene().containers[0].name;
    for (int k = 0; k < test::repeats(60); ++k) {
      run->moveCollider(name,
                        poseOf({k % 2 == 0 ? 0.1 : -0.1, 0, 0.05 * (k % 3)}, {0, 9.0 * k, 0}));
      run.frame();
    }
    Random random(61);
    for (int k = 0; k < test::repeats(60); ++k) {
      Posed pose;
      pose.position = random.inBox(Vec3d::Constant(-0.2), Vec3d::Constant(0.2));
      pose.rotation = Eigen::AngleAxisd(random.uniform(-0.5, 0.5), random.direction()).matrix();
      run->moveCollider(name, pose);
      run.frame();
    }
  }
}

TEST_F(Commands, ATorchOfAGigawatt) {
  line(0, "A hundred heated and cooled regions of a gigawatt",
       "contained, temperatures within their range");
  WatchedRun run(figures_, stabilityScene("frost"));
  Random random(7);
  for (std::size_t k = 0; k < kMaxHeatedRegions; ++k) {
    HeatedRegion region;
    region.centre_m = random.inBox({-0.4, -0.2, 0}, {0.4, 0.2, 0.5});
    region.size_m = Vec3d::Constant(0.3);
    region.power_w = k % 2 == 0 ? 1e9 : -1e9;
    region.duration_s = random.uniform(0, 1);
    run->heatRegion(region);
  }
  run.frames(90);
  for (const ParticleSample& p : run.particles()) {
    EXPECT_GE(p.temperature_c, float(kTemperatureRange_c.min));
    EXPECT_LE(p.temperature_c, float(kTemperatureRange_c.max));
  }
}

TEST_F(Commands, EverythingAtOnce) {
  line(0, "Random commands at random frames, up to the limits of each", "contained");
  Random random(11);
  for (const char* scene : {"splash", "frost", "hail"}) {
    WatchedRun run(figures_, stabilityScene(scene));
    const bool heat = run->scene().thermal.enabled;
    const std::string name = run->scene().containers[0].name;
    for (int k = 0; k < test::repeats(60); ++k) {
      const double which = random.uniform(0, 4);
      if (which < 1) run->setGravity(random.direction() * std::pow(10.0, random.uniform(-3, 4)));
      if (which >= 1 && which < 2) {
        run->setTemperature(random.uniform(-273.15, 1000), random.uniform(0, 0.2));
      }
      if (heat && which >= 2 && which < 3) {
        run->setTemperature(random.uniform(-273.15, 1000), 0.0, name);
      }
      if (which >= 3) {
        const Vec3d place = random.inBox(Vec3d::Constant(-5), Vec3d::Constant(5));
        run->moveCollider(name, poseOf(place, 180 * random.inBox(-Vec3d::Ones(), Vec3d::Ones())));
      }
      run.frame();
    }
  }
}

}  // namespace
}  // namespace ice_ice_baby
