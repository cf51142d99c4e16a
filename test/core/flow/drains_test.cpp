// Drains remove water at their rate, nearest to their centre first, and leave solids alone.
#include "flow/drains.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "flow/flow_fixtures.h"
#include "simulation/simulator.h"
#include "simulation/stories.h"

namespace ice_ice_baby {
namespace drains_test {

using test::outflow;

/// A cube of 12^3 particles of 5 cm in free space, with a drain around all of it.
Scene drainedCube(double particles_1_s) {
  Scene scene = test::floatingCube(12);
  const double litres = scene.fluid.spacing_m * scene.fluid.spacing_m * scene.fluid.spacing_m;
  scene.drains = {
      outflow(Vec3d::Constant(-5), Vec3d::Constant(5), particles_1_s * litres * kLitresPerMinute)};
  return scene;
}

TEST(Drains, RemoveAtTheirRateOverDecades) {
  for (const double frame_rate_hz : {24.0, 60.0, 600.0}) {
    for (const double particles_1_s : {0.7, 13.0, 190.0, 1500.0}) {
      const Scene scene = [&] {
        Scene one = drainedCube(particles_1_s);
        one.solver.frame_rate_hz = frame_rate_hz;
        return one;
      }();
      const double wanted = std::min(500.0, 20 * particles_1_s);
      const int frames = static_cast<int>(std::ceil(wanted / particles_1_s * frame_rate_hz));
      Drains drains(scene);
      const auto particles = test::particlesAt<float>(test::lattice(10, 0.05));
      const std::vector<char> stays(particles.size(), false);
      std::vector<char> gone(particles.size(), false);
      std::size_t all = 0;
      for (int k = 0; k < frames; ++k) all += drains.choose(scene, particles, gone, stays);
      const double due = particles_1_s * frames / frame_rate_hz;
      EXPECT_NEAR(double(all), due, std::max(1.0, 0.001 * due)) << particles_1_s;
    }
  }
}

TEST(Drains, ReportWhatTheyRemovedAndIdsStayUnique) {
  Simulator<float> simulator(drainedCube(300.0), 1);
  const std::size_t start = simulator.report().particles;
  for (int k = 0; k < 120; ++k) {
    const StepReport& report = simulator.advanceFrame();
    ASSERT_EQ(report.particles + report.drained, start);
    ASSERT_EQ(report.drained, std::uint64_t(5 * (k + 1))) << "300 a second are 5 a frame";
  }
  std::set<std::uint32_t> ids;
  for (const std::uint32_t id : simulator.particles().id) ids.insert(id);
  EXPECT_EQ(ids.size(), simulator.particles().size());
}

TEST(Drains, TakeTheNearestToTheirCentreFirst) {
  const Scene scene = drainedCube(60.0);
  const auto particles = test::particlesAt<double>({{0, 0, 3}, {0, 1, 0}, {2, 0, 0}, {0, -1, 0}});
  const std::vector<char> stays(4, false);
  std::vector<char> gone(4, false);
  Drains drains(scene);
  for (const char* step : {"0100", "0101", "0111", "1111"}) {
    EXPECT_EQ(drains.choose(scene, particles, gone, stays), 1U);
    std::string now;
    for (const char one : gone) now += one ? '1' : '0';
    EXPECT_EQ(now, step) << "of two at the same distance the one with the lower id";
  }
}

/// Otherwise a drain below a jet that has been off for a minute would swallow a litre at once.
TEST(Drains, DoNotMakeUpForWhatWasNotThere) {
  const Scene scene = drainedCube(60.0);
  Drains drains(scene);
  std::vector<char> none;
  for (int k = 0; k < 100; ++k) drains.choose(scene, Particles<float>(), none, none);
  const auto particles = test::particlesAt<float>(test::lattice(5, 0.05));
  const std::vector<char> stays(particles.size(), false);
  std::vector<char> gone(particles.size(), false);
  EXPECT_LE(drains.choose(scene, particles, gone, stays), 2U);
}

TEST(Drains, WithoutARateTakeAllThatIsInTheirRotatedBox) {
  Scene scene = test::floatingCube(12);
  scene.drains = {outflow({0.1, 0.25, 0.25}, {0.5, 0.35, 0.35})};
  scene.drains[0].rpy_deg = {0, 0, 90};
  Simulator<float> simulator(scene, 1);
  simulator.advanceFrame();
  EXPECT_EQ(simulator.report().drained, 2U * 8 * 2);
  for (std::size_t i = 0; i < simulator.particles().size(); ++i) {
    const auto& x = simulator.particles().position;
    EXPECT_FALSE(std::abs(x.x[i] - 0.3) < 0.04 && std::abs(x.y[i] - 0.3) < 0.19 &&
                 std::abs(x.z[i] - 0.3) < 0.04);
  }
}

TEST(Drains, LeaveIceFrozenWaterAndSheets) {
  Scene frozen = drainedCube(0.0);
  frozen.temperature.initial_c = -10.0;
  Scene sheet = test::sheetStory().scene;
  sheet.drains = {outflow(Vec3d::Constant(-5), Vec3d::Constant(5))};
  Scene ice = test::heated(0.02);
  ice.blocks = {test::blockOf(Vec3d::Zero(), Vec3d::Constant(0.1)),
                test::blockOf({0.5, 0, 0}, {0.6, 0.1, 0.1})};
  ice.blocks[0].celsius = -20.0;
  ice.drains = sheet.drains;
  std::size_t cloth = 0;
  for (const Block& block : sheet.blocks) {
    if (block.sheet)
      cloth += std::size_t(particleCount([&] {
        Scene one = sheet;
        one.blocks = {block};
        return one;
      }()));
  }
  ASSERT_GT(cloth, 0U);
  Simulator<float> of_frozen(frozen, 1), of_sheet(sheet, 1), of_ice(ice, 1);
  const std::size_t cube = of_frozen.report().particles;
  const std::size_t bodies = of_ice.report().ice_particles;
  for (int k = 0; k < 5; ++k) {
    for (Simulator<float>* each : {&of_frozen, &of_sheet, &of_ice}) each->advanceFrame();
  }
  EXPECT_EQ(of_frozen.report().particles, cube);
  EXPECT_EQ(of_sheet.report().particles, cloth);
  EXPECT_EQ(of_ice.report().particles, bodies) << "the water has gone, the ice is there";
  of_frozen.setTemperature(20.0, 0.0, "");
  of_frozen.advanceFrame();
  EXPECT_EQ(of_frozen.report().particles, 0U) << "once it has melted";
}

}  // namespace drains_test
}  // namespace ice_ice_baby
