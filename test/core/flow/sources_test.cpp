// Sources emit water at their rate, with their velocity and at rest density, whatever the spacing,
// the direction and the frame rate.
#include "flow/sources.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "flow/flow_fixtures.h"
#include "simulation/simulator.h"

namespace ice_ice_baby {
namespace sources_test {

using test::jet;
using test::particles_1_s;
using test::tap;

constexpr double kPlenty = 1e9;

/// Layers of a source, as their distance from the disc when `time_s` has passed, nearest last.
struct Emitted {
  std::size_t particles = 0;
  std::vector<double> distance_m;
};

Emitted emit(const Scene& scene, double dt_s, int steps) {
  Sources sources(scene);
  const Vec3d along = scene.sources[0].direction.normalized();
  const double speed_m_s = scene.sources[0].speedInForce_m_s();
  const std::size_t sites = Outlet(scene.sources[0], scene.fluid.spacing_m).sites.size();
  Emitted all;
  for (int k = 0; k < steps; ++k) {
    const std::vector<Drop>& drops = sources.advance(scene, 0, dt_s, kPlenty);
    all.particles += drops.size();
    for (std::size_t i = 0; i < drops.size(); i += sites) {
      const double rest_s = dt_s * (steps - 1 - k);
      const Vec3d way_m = drops[i].position_m - drops[i].from_m;
      all.distance_m.push_back(way_m.dot(along) + rest_s * speed_m_s);
    }
  }
  return all;
}

TEST(Sources, RateAndSpacingOfLayersOverDecades) {
  test::Random random(1);
  for (const double spacing_m : {1e-3, 1e-2, 0.2}) {
    for (const double radius_d : {0.01, 0.5, 0.8, 1.2, 3.7, 20.0}) {
      for (const double layers_per_step : {0.01, 0.13, 1.0, 7.7}) {
        for (const double dt_s : {1e-4, 1.0 / 180, 0.1}) {
          Source source = tap({0.1, -0.2, 0.3}, radius_d * spacing_m, 0.0);
          source.direction = 7.0 * random.direction();
          const double layer_m3 = Outlet(source, spacing_m).layer_m3;
          source.flow_l_min = kLitresPerMinute * layer_m3 * layers_per_step / dt_s;
          const Scene scene = jet(source, spacing_m);
          const int steps = static_cast<int>(300 / layers_per_step);
          const Emitted all = emit(scene, dt_s, steps);
          const double due = particles_1_s(source, spacing_m) * dt_s * steps;
          ASSERT_NEAR(double(all.particles), due, 0.01 * due) << spacing_m << " " << radius_d;
          const double step_m = layer_m3 / source.area_m2();
          for (std::size_t k = 1; k < all.distance_m.size(); ++k) {
            ASSERT_NEAR(all.distance_m[k - 1] - all.distance_m[k], step_m, 1e-6 * step_m);
          }
        }
      }
    }
  }
}

TEST(Sources, ALayerIsRoundAndFillsTheDisc) {
  for (const double radius_d : {0.1, 0.6, 0.8, 1.0, 2.0, 5.0, 12.0}) {
    Source source = tap({1, 2, 3}, 0.01 * radius_d, 1.0);
    source.direction = {1, -2, 0.5};
    const Outlet outlet(source, 0.01);
    const double filled_d2 = M_PI * radius_d * radius_d;
    ASSERT_EQ(double(outlet.sites.size()), std::max(1.0, std::round(filled_d2)));
    Vec3d mean = Vec3d::Zero();
    double nearest_m = 1.0, farthest_m = 0.0;
    for (const Vec3d& site : outlet.sites) {
      const Vec3d from_centre = source.pose().rotation * site;
      mean += from_centre / double(outlet.sites.size());
      EXPECT_LT(std::abs(from_centre.dot(source.direction)), 1e-12);
      farthest_m = std::max(farthest_m, from_centre.norm());
      for (const Vec3d& other : outlet.sites) {
        if (&other != &site) nearest_m = std::min(nearest_m, (other - site).norm());
      }
    }
    EXPECT_LT(farthest_m, 1.01 * source.radius_m + 0.005) << radius_d;
    EXPECT_LT(mean.norm(), 0.005) << radius_d;
    EXPECT_GT(nearest_m, 0.0085) << radius_d;
  }
}

TEST(Sources, TheDiscOfAPlainDirectionLiesAlongTheAxes) {
  const Outlet outlet(tap(Vec3d::Zero(), 0.011, 1.0), 0.01);  // 4 particles
  ASSERT_EQ(outlet.sites.size(), 4U);
  const double half_m = 1.01 * std::sqrt(M_PI) * 0.011 / 4;
  for (const Vec3d& site : outlet.sites) {
    EXPECT_NEAR(std::abs(site.x()), half_m, 1e-12);
    EXPECT_NEAR(std::abs(site.y()), half_m, 1e-12);
    EXPECT_EQ(site.z(), 0.0);
  }
}

template <class Real>
class JetTest : public testing::Test {};

using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(JetTest, Reals);

/// Without gravity and walls nothing but the source changes the momentum.
TYPED_TEST(JetTest, ItsRateAndMomentumAreThoseOfTheSource) {
  struct Case {
    double spacing_m, radius_d, speed_m_s, frame_rate_hz;
  };
  test::Random random(2);
  for (const Case& c :
       {Case{0.02, 1.6, 1.0, 60}, Case{0.005, 2.2, 0.1, 60}, Case{0.05, 0.7, 25.0, 60},
        Case{0.02, 1.0, 10.0, 24}, Case{0.02, 1.6, 3.0, 600}}) {
    Source source = tap(Vec3d::Zero(), c.radius_d * c.spacing_m, c.speed_m_s);
    source.direction = random.direction();
    Scene scene = jet(source, c.spacing_m);
    scene.solver.frame_rate_hz = c.frame_rate_hz;
    scene.solver.quality = Quality::kFast;
    Simulator<TypeParam> simulator(scene, 1);
    const double rate_1_s = particles_1_s(source, c.spacing_m);
    const double layers_1_s = rate_1_s / siteCount(source, c.spacing_m);
    const int frames = static_cast<int>(std::ceil(110 / layers_1_s * c.frame_rate_hz));
    for (int k = 0; k < frames; ++k) simulator.advanceFrame();
    const StepReport& report = simulator.report();
    const double due = rate_1_s * report.time_s;
    EXPECT_NEAR(double(report.poured), due, 0.01 * due);
    EXPECT_EQ(report.blocked, 0U);
    EXPECT_EQ(report.particles, report.poured);
    const Vec3d momentum = test::sumOf(simulator.particles().velocity);
    const Vec3d wanted = double(report.poured) * c.speed_m_s * source.direction.normalized();
    EXPECT_LT((momentum - wanted).norm(), 0.01 * wanted.norm()) << c.spacing_m;
  }
}

double densest(const Simulation& simulation) {
  std::vector<ParticleSample> samples;
  simulation.sample(samples);
  double densest = 0.0;
  for (const ParticleSample& s : samples) densest = std::max(densest, double(s.density));
  return densest;
}

/// A jet 8 particles across. Layers that come too close to each other would show.
TEST(Sources, AJetHasRestDensityWhateverTheFrameRateAndTheSubsteps) {
  for (const double frame_rate_hz : {24.0, 60.0, 250.0}) {
    for (const int substeps : {1, 3, 7}) {
      for (const double speed_m_s : {0.7, 4.3}) {
        Source source = tap(Vec3d::Zero(), 0.08, speed_m_s);
        source.direction = {0.3, 0.5, 1.0};
        Scene scene = jet(source, 0.02);
        scene.solver.frame_rate_hz = frame_rate_hz;
        scene.solver.substeps = substeps;
        const auto simulation = makeSimulation(scene, Precision::kFloat, 1);
        double highest = 0.0;
        const double length_m = 0.5;
        while (simulation->report().time_s < length_m / speed_m_s) {
          simulation->advanceFrame();
          highest = std::max(highest, densest(*simulation));
        }
        EXPECT_LT(highest, 1.0) << frame_rate_hz << " " << substeps << " " << speed_m_s;
        EXPECT_GT(highest, 0.97) << "the middle of the jet is full";
        EXPECT_LT(simulation->report().max_speed_m_s, 1.05 * speed_m_s);
      }
    }
  }
}

/// Water that falls from rest height z has the speed sqrt(v^2 + 2 g z).
TEST(Sources, AFallingJetIsAsFastAsItsFallMakesIt) {
  Scene scene = jet(tap({0, 0, 1}, 0.02, 0.5), 0.01);
  scene.gravity_m_s2 = Vec3d(0, 0, -9.81);
  scene.bounds.min_m.z() = 0.0;
  Simulator<float> simulator(scene, 1);
  for (int k = 0; k < 60; ++k) simulator.advanceFrame();
  EXPECT_GT(simulator.report().spilled, 0U);
  std::size_t low = 0;
  for (std::size_t i = 0; i < simulator.particles().size(); ++i) {
    const double fall_m = 1.0 - double(simulator.particles().position.z[i]);
    const double speed_m_s = -double(simulator.particles().velocity.z[i]);
    EXPECT_NEAR(speed_m_s, std::sqrt(0.25 + 2 * 9.81 * fall_m), 0.05 * speed_m_s + 0.05);
    low += fall_m > 0.8;
  }
  EXPECT_GT(low, 0U);
}

TEST(Sources, ThatAreOffEmitNothingAndFlowFollowsTheLatestCommand) {
  Source source = tap(Vec3d::Zero(), 0.04, 1.0);
  source.open = false;
  Simulator<float> simulator(jet(source, 0.02), 1);
  const auto poured = [&](int frames) {
    const std::uint64_t before = simulator.report().poured;
    for (int k = 0; k < frames; ++k) simulator.advanceFrame();
    return double(simulator.report().poured - before);
  };
  EXPECT_EQ(poured(30), 0.0);
  const double due = particles_1_s(source, 0.02);
  const double layer = siteCount(source, 0.02);
  simulator.setSource("tap", true, 0.0);
  EXPECT_NEAR(poured(60), due, layer);
  const double flow_l_min = source.flowInForce_m3_s() * kLitresPerMinute;
  simulator.setSource("tap", true, 3 * flow_l_min);
  EXPECT_NEAR(simulator.scene().sources[0].speedInForce_m_s(), 3.0, 1e-9);
  EXPECT_NEAR(poured(60), 3 * due, layer);
  EXPECT_GT(simulator.report().max_speed_m_s, 2.9);
  simulator.setSource("tap", false, flow_l_min);
  EXPECT_EQ(poured(30), 0.0);
  simulator.setSource("tap", true, 0.0);
  EXPECT_NEAR(poured(60), due, layer);
}

}  // namespace sources_test
}  // namespace ice_ice_baby
