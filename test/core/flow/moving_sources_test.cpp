// Sources that move and turn: their rate, and where and how fast water leaves them.
#include <gtest/gtest.h>

#include <cmath>

#include "flow/flow_fixtures.h"
#include "flow/sources.h"
#include "ice_ice_baby/checkpoint.h"
#include "simulation/simulator.h"

namespace ice_ice_baby {
namespace moving_sources_test {

using test::jet;
using test::particles_1_s;
using test::tap;

constexpr double kPlenty = 1e9;

/// Pose of a source that moves and turns evenly.
Posed carried(const Posed& start, double time_s, double speed_m_s, double turning_rad_s) {
  const Vec3d along = Vec3d(1, -0.5, 0.3).normalized(), axis = Vec3d(3, 0, 1).normalized();
  return {start.position + speed_m_s * time_s * along,
          Eigen::AngleAxisd(turning_rad_s * time_s, axis) * start.rotation};
}

/// Each drop has left a site of the outlet as it was when its layer was due, with the velocity of
/// that site and of the flow.
TEST(MovingSources, WaterLeavesWhereTheOutletIsWithItsVelocity) {
  for (const double frame_rate_hz : {24.0, 60.0, 500.0}) {
    for (const int substeps : {1, 3, 8}) {
      Scene scene = jet(tap(Vec3d::Zero(), 0.03, 2.0), 0.01);
      scene.gravity_m_s2 = {0.0, 0.0, -9.81};
      scene.solver.frame_rate_hz = frame_rate_hz;
      Sources sources(scene);
      const Outlet outlet(scene.sources[0], 0.01);
      const double layers_1_s = scene.sources[0].flowInForce_m3_s() / outlet.layer_m3;
      const Posed start = scene.sources[0].pose();
      const Vec3d step_m(0.05, 0.02, -0.03), turn_rad(0.0, 0.4, 0.0);
      Posed target = start;
      target.position += step_m;
      target.rotation = Eigen::AngleAxisd(turn_rad.norm(), Vec3d::UnitY()) * start.rotation;
      sources.motion(0).moveTo(target);
      const double dt_s = 1.0 / frame_rate_hz / substeps;
      std::size_t layer = 0;
      for (int k = 0; k < substeps; ++k) {
        sources.setSubstep(double(k) / substeps, double(k + 1) / substeps);
        const std::vector<Drop>& drops = sources.advance(scene, 0, dt_s, kPlenty);
        for (std::size_t i = 0; i < drops.size(); ++i) {
          if (i % outlet.sites.size() == 0) ++layer;
          const double born_s = double(layer) / layers_1_s;
          const double age_s = (k + 1) * dt_s - born_s;
          const double part = born_s * frame_rate_hz;
          const Mat3<double> rotation =
              Eigen::AngleAxisd(part * turn_rad.norm(), Vec3d::UnitY()) * start.rotation;
          const Vec3d arm_m = rotation * outlet.sites[drops[i].site];
          const Vec3d site_m = start.position + part * step_m + arm_m;
          const Vec3d velocity_m_s =
              2.0 * rotation.col(2) + frame_rate_hz * (step_m + turn_rad.cross(arm_m));
          const Vec3d fall_m_s = age_s * scene.gravity_m_s2;
          ASSERT_LT((drops[i].velocity_m_s - velocity_m_s - fall_m_s).norm(), 1e-9);
          const Vec3d flown_m = drops[i].position_m - site_m - age_s * velocity_m_s;
          ASSERT_LT((flown_m - fall_m_s * (age_s + dt_s) / 2).norm(), 1e-9);
        }
      }
      EXPECT_EQ(layer, std::size_t(layers_1_s / frame_rate_hz)) << frame_rate_hz;
    }
  }
}

template <class Real>
class MovingJetTest : public testing::Test {};

using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(MovingJetTest, Reals);

/// The edge of the disc turns with at most 8 % of the speed of the flow; more presses layers
/// together.
TYPED_TEST(MovingJetTest, TheRateIsThatOfTheSourceHoweverTheOutletMovesAndTurns) {
  struct Case {
    double spacing_m, flow_m_s, moving_m_s, turning_rad_s, frame_rate_hz;
  };
  for (const Case& c : {Case{0.02, 1.0, 0.1, 0.0, 60}, Case{0.02, 1.0, 5.0, 0.5, 60},
                        Case{0.02, 3.0, 0.0, 3.0, 60}, Case{0.002, 0.3, 0.3, 1.0, 60},
                        Case{0.1, 10.0, 2.0, 5.0, 24}, Case{0.01, 0.5, 0.5, -2.0, 240}}) {
    Scene scene = jet(tap(Vec3d::Zero(), 1.6 * c.spacing_m, c.flow_m_s), c.spacing_m);
    scene.solver.frame_rate_hz = c.frame_rate_hz;
    scene.solver.quality = Quality::kFast;
    Simulator<TypeParam> simulator(scene, 1);
    const Posed start = simulator.sourcePose("tap");
    const double rate_1_s = particles_1_s(scene.sources[0], c.spacing_m);
    const double layers_1_s = rate_1_s / siteCount(scene.sources[0], c.spacing_m);
    const int frames = static_cast<int>(std::ceil(110 / layers_1_s * c.frame_rate_hz));
    for (int k = 1; k <= frames; ++k) {
      const double time_s = k / c.frame_rate_hz;
      simulator.moveSource("tap", carried(start, time_s, c.moving_m_s, c.turning_rad_s));
      simulator.advanceFrame();
    }
    const double due = rate_1_s * simulator.report().time_s;
    EXPECT_NEAR(double(simulator.report().poured), due, 0.01 * due) << c.moving_m_s;
    EXPECT_EQ(simulator.report().blocked, 0U) << c.moving_m_s;
    EXPECT_EQ(simulator.report().particles, simulator.report().poured);
  }
}

/// What the water does relative to the outlet does not depend on the speed of both.
TEST(MovingSources, TheJetOfAnEvenlyMovingOutletIsThatOfOneAtRest) {
  const Source source = tap(Vec3d::Zero(), 0.03, 1.0);
  Simulator<double> still(jet(source, 0.01), 1), moved(jet(source, 0.01), 1);
  const Vec3d speed_m_s(1.5, -0.7, 0.4);
  for (int k = 1; k <= 30; ++k) {
    Posed pose = source.pose();
    pose.position += speed_m_s * k / 60;
    moved.moveSource("tap", pose);
    still.advanceFrame();
    moved.advanceFrame();
  }
  std::vector<ParticleSample> at_rest, along;
  still.sample(at_rest, 1);
  moved.sample(along, 1);
  ASSERT_GT(at_rest.size(), 300U);
  ASSERT_EQ(along.size(), at_rest.size());
  const Vec3d way_m = speed_m_s / 2;
  for (std::size_t i = 0; i < along.size(); ++i) {
    EXPECT_NEAR(double(along[i].x) - way_m.x(), double(at_rest[i].x), 2e-4);
    EXPECT_NEAR(double(along[i].y) - way_m.y(), double(at_rest[i].y), 2e-4);
    EXPECT_NEAR(double(along[i].z) - way_m.z(), double(at_rest[i].z), 2e-4);
  }
}

/// A spout half a millimetre behind the disc, which moves and turns with it.
TEST(MovingSources, ASpoutThatIsCarriedAlongIsNotInTheWay) {
  Scene scene = jet(tap(Vec3d::Zero(), 0.02, 1.0), 0.01);
  scene.spheres = {test::ball({0, 0, 0.0555}, 0.05)};
  Simulator<float> simulator(scene, 1);
  const Vec3d spout_m = Vec3d(0, 0, -0.0555);
  for (int k = 1; k <= 40; ++k) {
    const double s = 0.02 * k;
    const Posed pose = poseOf({3 * s, 0, s}, {180 + 100 * s, 60 * s, 0});
    simulator.moveSource("tap", pose);
    simulator.moveCollider("ball", {pose.toWorld(spout_m), pose.rotation});
    simulator.advanceFrame();
  }
  EXPECT_GT(simulator.report().poured, 300U);
  EXPECT_EQ(simulator.report().blocked, 0U);
}

TEST(MovingSources, FastOnesJumpAndLendTheWaterNoSpeed) {
  Simulator<float> simulator(jet(tap(Vec3d::Zero(), 0.02, 1.0), 0.01), 1);
  const Vec3d far(10, 0, 0);
  Posed pose = simulator.sourcePose("tap");
  pose.position = far;
  simulator.moveSource("tap", pose);
  simulator.advanceFrame();
  EXPECT_EQ(simulator.sourcePose("tap").position, far);
  for (int k = 0; k < 10; ++k) simulator.advanceFrame();
  ASSERT_GT(simulator.report().poured, 0U);
  for (std::size_t i = 0; i < simulator.particles().size(); ++i) {
    EXPECT_LT((simulator.particles().position.at(i).cast<double>() - far).norm(), 0.5);
    EXPECT_LT(simulator.particles().velocity.at(i).norm(), 1.1);
  }
}

TEST(MovingSources, OneWithAFrameIsClosedUntilItHasAPlace) {
  Source source = tap(Vec3d::Zero(), 0.02, 1.0);
  source.follow_frame = "hand";
  Scene scene = jet(source, 0.01);
  scene.spheres = {test::ball(Vec3d::Zero(), 0.1)};  // where it would be
  Simulator<float> simulator(scene, 1);
  for (int k = 0; k < 20; ++k) simulator.advanceFrame();
  EXPECT_EQ(simulator.report().poured + simulator.report().blocked, 0U);
  simulator.moveSource("tap", poseOf({1, 0, 0}, Vec3d::Zero()));
  EXPECT_EQ(simulator.sourcePose("tap").position.x(), 1.0) << "placed, not moved";
  const std::string saved = encodeCheckpoint(simulator);
  for (int k = 0; k < 60; ++k) simulator.advanceFrame();
  const double due = particles_1_s(source, 0.01);
  EXPECT_NEAR(double(simulator.report().poured), due, 0.01 * due + 13);
  const auto loaded = decodeCheckpoint(saved, "memory", 1);
  for (int k = 0; k < 60; ++k) loaded->advanceFrame();
  EXPECT_EQ(loaded->stateHash(), simulator.stateHash());
}

TEST(MovingSources, PosesThatAreNoneAreRefusedAndChangeNothing) {
  Simulator<float> simulator(jet(tap(Vec3d::Zero(), 0.02, 1.0), 0.01), 1);
  const std::uint64_t hash = simulator.stateHash();
  Posed stretched;
  stretched.rotation *= 2.0;
  const auto refused = [&](const std::string& name, const Posed& pose) {
    const std::string why = test::refusalOf([&] { simulator.moveSource(name, pose); });
    EXPECT_EQ(test::refusalOf([&] { simulator.placeSource(name, pose); }), why);
    EXPECT_EQ(simulator.stateHash(), hash);
    return why;
  };
  EXPECT_EQ(refused("tab", Posed()), "no source \"tab\"; scene unnamed has: tap");
  EXPECT_EQ(refused("tap", poseOf({0, 101, 0}, Vec3d::Zero())),
            "position of source tap = 101 is outside the allowed range [-100, 100]");
  EXPECT_NE(refused("tap", poseOf({std::nan(""), 0, 0}, Vec3d::Zero())), "");
  EXPECT_EQ(refused("tap", stretched), "rotation of source tap must be a unit quaternion");
  EXPECT_NE(test::refusalOf([&] { simulator.sourcePose("tab"); }), "");
}

}  // namespace moving_sources_test
}  // namespace ice_ice_baby
