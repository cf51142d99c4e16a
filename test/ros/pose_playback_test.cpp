// Poses of a tf frame played back: exact at constant velocity, smooth whatever arrives.
#include "pose_playback.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "turns.h"

namespace ice_ice_baby {
namespace {

constexpr double kFrame_s = 1.0 / 60.0;

using Path = std::function<Posed(double)>;

Posed at(const Vec3d& position, const Vec3d& turn = Vec3d::Zero()) {
  return {position, rotationBy(turn)};
}

/// A path of constant velocity, m/s, and spin, rad/s.
Path steady(const Vec3d& origin, const Vec3d& velocity, const Vec3d& spin = Vec3d::Zero()) {
  return [=](double t) { return at(origin + t * velocity, t * spin); };
}

double angleBetween(const Posed& a, const Posed& b) {
  return turnOf(a.rotation.transpose() * b.rotation).norm();
}

/// A robot that sends its pose, and frames that play it back.
struct Stream {
  Path path;
  double rate_hz = 100.0;
  double latency_s = 0.002;
  double noise_m = 0.0;
  double noise_rad = 0.0;
  /// Whether the sample of a stamp is never sent.
  std::function<bool(double)> lost = [](double) { return false; };
  double start_s = 0.0;
  double clock_s = 0.0;  ///< how far the clock of the node is ahead of that of the stamps

  struct Frame {
    double stamp_s;
    double delay_s;
    Posed pose;
    bool placed;
  };

  std::vector<Frame> run(PosePlayback& playback, double duration_s) {
    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    const auto vector = [&] { return Vec3d(normal(random), normal(random), normal(random)); };
    std::vector<Frame> frames;
    long sent = 0;
    for (long frame = 0; double(frame) * kFrame_s < duration_s; ++frame) {
      const double now_s = start_s + double(frame) * kFrame_s;
      while (start_s + double(sent) / rate_hz + latency_s <= now_s) {
        const double stamp_s = start_s + double(sent++) / rate_hz;
        if (lost(stamp_s)) continue;
        Posed pose = path(stamp_s);
        pose.position += noise_m * vector();
        pose.rotation = rotationBy(noise_rad * vector()) * pose.rotation;
        playback.add({stamp_s, stamp_s + latency_s + clock_s, pose});
      }
      if (const auto played = playback.play(now_s + clock_s)) {
        frames.push_back({now_s, playback.delay_s() - clock_s, played->pose, played->placed});
      }
    }
    return frames;
  }
};

/// Largest speed and acceleration of the frames after `from_s`.
struct Motion {
  double speed_m_s = 0.0;
  double acceleration_m_s2 = 0.0;
};
Motion motionOf(const std::vector<Stream::Frame>& frames, double from_s) {
  Motion motion;
  for (std::size_t k = 2; k < frames.size(); ++k) {
    if (frames[k - 2].stamp_s < from_s) continue;
    const Vec3d before = (frames[k - 1].pose.position - frames[k - 2].pose.position) / kFrame_s;
    const Vec3d after = (frames[k].pose.position - frames[k - 1].pose.position) / kFrame_s;
    motion.speed_m_s = std::max(motion.speed_m_s, after.norm());
    motion.acceleration_m_s2 =
        std::max(motion.acceleration_m_s2, (after - before).norm() / kFrame_s);
  }
  return motion;
}

/// Every frame after `from_s` has to be where the path was `delay_s` before.
void expectOnPath(const std::vector<Stream::Frame>& frames, const Path& path, double from_s,
                  double within_m, double within_rad) {
  ASSERT_GT(frames.size(), 10u);
  for (const auto& frame : frames) {
    if (frame.stamp_s < from_s) continue;
    const Posed expected = path(frame.stamp_s - frame.delay_s);
    ASSERT_LT((frame.pose.position - expected.position).norm(), within_m) << frame.stamp_s;
    ASSERT_LT(angleBetween(frame.pose, expected), within_rad) << frame.stamp_s;
  }
}

TEST(PosePlayback, ConstantVelocityIsExactAtEveryRateDelayAndDistance) {
  for (const double rate_hz : {5.0, 10.0, 20.0, 30.0, 31.0, 50.0, 100.0, 1000.0}) {
    for (const double latency_s : {0.0, 0.002, 0.05}) {
      for (const double delay_s : {-1.0, 0.3, 0.5}) {
        for (const double far_m : {0.0, 10.0, 1e6}) {
          const Path path = steady(Vec3d(far_m, -far_m, 0.3), {0.5, -0.2, 0.1}, {0, 6, 8});
          PlaybackSettings settings;
          settings.delay_s = delay_s;
          PosePlayback playback(settings);
          const auto frames = Stream{path, rate_hz, latency_s}.run(playback, 4.0);
          SCOPED_TRACE(testing::Message() << rate_hz << " Hz, latency " << latency_s << " s, delay "
                                          << delay_s << " s, " << far_m << " m away");
          expectOnPath(frames, path, 2.5, 1e-9 + 1e-14 * far_m, 1e-7);
        }
      }
    }
  }
}

TEST(PosePlayback, TheDelayIsTheLongestSilenceAndAFrame) {
  for (const double rate_hz : {5.0, 20.0, 100.0}) {
    for (const double latency_s : {0.0, 0.05}) {
      PosePlayback playback;
      Stream{steady({0, 0, 0}, {1, 0, 0}), rate_hz, latency_s}.run(playback, 4.0);
      EXPECT_NEAR(playback.delay_s(), 1 / rate_hz + latency_s + kFrame_s, 1e-9) << rate_hz;
    }
  }
  PosePlayback slow;
  Stream{steady({0, 0, 0}, {1, 0, 0}), 1.0, 0.0}.run(slow, 8.0);
  EXPECT_NEAR(slow.delay_s(), 0.5, 1e-9) << "at most";
}

TEST(PosePlayback, ClocksThatDifferAreNoDelay) {
  for (const double difference_s : {-3600.0, -0.2, 10.0, 3600.0}) {
    const Path path = steady({0, 0, 0}, {0.5, 0, 0});
    PosePlayback playback;
    Stream stream{path, 50.0};
    stream.clock_s = difference_s;
    const auto frames = stream.run(playback, 4.0);
    SCOPED_TRACE(difference_s);
    expectOnPath(frames, path, 2.5, 1e-9, 1e-7);
    EXPECT_NEAR(playback.delay_s(), difference_s + 0.022 + kFrame_s, 1e-6);
  }
}

TEST(PosePlayback, InSimulatedTimeTheDelayIsZeroOrAnInterval) {
  PlaybackSettings settings;
  settings.simulated_time = true;
  const Path path = steady({0, 0, 0}, {0.5, 0, 0}, {1, 0, 0});
  for (const double rate_hz : {60.0, 120.0, 600.0}) {
    PosePlayback playback(settings);
    const auto frames = Stream{path, rate_hz, 0.0}.run(playback, 2.0);
    EXPECT_EQ(playback.delay_s(), 0.0) << rate_hz;
    expectOnPath(frames, path, 0.5, 1e-9, 1e-7);
  }
  for (const double rate_hz : {10.0, 20.0, 50.0}) {
    PosePlayback playback(settings);
    const auto frames = Stream{path, rate_hz, 0.0}.run(playback, 2.0);
    EXPECT_NEAR(playback.delay_s(), 1 / rate_hz, 1e-9);
    expectOnPath(frames, path, 1.0, 1e-9, 1e-7);
  }
  PosePlayback late(settings);
  const auto frames = Stream{path, 120.0, 0.05}.run(late, 2.0);
  EXPECT_NEAR(late.delay_s(), 0.05, 1e-9);
  expectOnPath(frames, path, 1.0, 1e-9, 1e-7);
}

TEST(PosePlayback, NoiseIsReducedAboveThirtyHertz) {
  for (const double rate_hz : {50.0, 100.0, 1000.0}) {
    const Path path = steady({0, 0, 0}, {0.5, 0, 0}, {0, 0, 1});
    PosePlayback playback;
    Stream stream{path, rate_hz};
    stream.noise_m = 0.002;
    stream.noise_rad = 0.017;
    const auto frames = stream.run(playback, 12.0);
    double sum_m2 = 0.0, sum_rad2 = 0.0, sum_m2_s2 = 0.0;
    int count = 0;
    for (std::size_t k = 180; k < frames.size(); ++k) {
      const Posed truth = path(frames[k].stamp_s - frames[k].delay_s);
      sum_m2 += (frames[k].pose.position - truth.position).squaredNorm() / 3;
      sum_rad2 += std::pow(angleBetween(frames[k].pose, truth), 2) / 3;
      const Vec3d velocity = (frames[k].pose.position - frames[k - 1].pose.position) / kFrame_s;
      sum_m2_s2 += (velocity - Vec3d(0.5, 0, 0)).squaredNorm() / 3;
      ++count;
    }
    EXPECT_LT(std::sqrt(sum_m2 / count), 0.0014) << rate_hz;
    EXPECT_LT(std::sqrt(sum_rad2 / count), 0.7 * 0.017) << rate_hz;
    // Two independent samples of 2 mm a frame apart differ by 0.17 m/s.
    EXPECT_LT(std::sqrt(sum_m2_s2 / count), 0.07) << rate_hz;
  }
}

TEST(PosePlayback, TheFirstPoseIsAPlacementAndNoOtherOne) {
  PosePlayback playback;
  EXPECT_FALSE(playback.play(0.0));
  const auto frames = Stream{steady({3, 0, 0}, {0.5, 0, 0}), 20.0}.run(playback, 2.0);
  for (std::size_t k = 0; k < frames.size(); ++k) EXPECT_EQ(frames[k].placed, k == 0) << k;
  playback.restart();
  EXPECT_TRUE(playback.play(2.0)->placed);
  EXPECT_FALSE(playback.play(2.02)->placed);
}

TEST(PosePlayback, ATeleportIsAPlacementAndNotAMotion) {
  const Path path = [](double t) { return at(t < 1.0 ? Vec3d(0.1, 0, 0) : Vec3d(3, 0, 0)); };
  PosePlayback playback;
  int placed = 0;
  for (const auto& frame : Stream{path, 20.0}.run(playback, 2.0)) {
    placed += frame.placed;
    const double x = frame.pose.position.x();
    EXPECT_TRUE(std::abs(x - 0.1) < 1e-12 || std::abs(x - 3.0) < 1e-12) << x;
  }
  EXPECT_EQ(placed, 2);
}

TEST(PosePlayback, AGapMovesSmoothly) {
  for (const double rate_hz : {10.0, 20.0, 100.0}) {
    for (const double speed_m_s : {0.3, 1.0}) {
      const Path path = [=](double t) { return at({0.3 * std::sin(speed_m_s * t / 0.3), 0, 0}); };
      PosePlayback playback;
      Stream stream{path, rate_hz};
      stream.lost = [](double stamp) { return stamp > 3.0 && stamp < 3.3; };
      const auto frames = stream.run(playback, 6.0);
      const Motion motion = motionOf(frames, 1.0);
      SCOPED_TRACE(testing::Message() << rate_hz << " Hz, " << speed_m_s << " m/s");
      EXPECT_LT(motion.speed_m_s, 1.5 * speed_m_s + 0.3);
      EXPECT_LT(motion.acceleration_m_s2, 20.0 + speed_m_s * speed_m_s / 0.3 * 60 / rate_hz);
      const auto& last = frames.back();
      EXPECT_LT((last.pose.position - path(last.stamp_s - last.delay_s).position).norm(), 0.02);
    }
  }
}

TEST(PosePlayback, GapsThatComeBackAreBridgedByTheDelay) {
  const Path path = steady({0, 0, 0}, {0.5, 0, 0});
  PosePlayback playback;
  Stream stream{path, 100.0};
  stream.lost = [](double stamp) { return stamp - std::floor(stamp) < 0.3; };
  expectOnPath(stream.run(playback, 8.0), path, 4.0, 1e-9, 1e-7);
  EXPECT_NEAR(playback.delay_s(), 0.31 + 0.002 + kFrame_s, 0.011);
}

TEST(PosePlayback, AStreamThatEndsComesToRestAtItsLastPose) {
  const Path path = steady({0, 0, 0}, {1, 0, 0}, {0, 0, 2});
  PosePlayback playback;
  Stream stream{path, 20.0};
  stream.lost = [](double stamp) { return stamp > 1.001; };
  const auto frames = stream.run(playback, 5.0);
  for (const auto& frame : frames) EXPECT_LT(frame.pose.position.x(), 1.0 + 0.1751);
  EXPECT_LT(motionOf(frames, 0.5).acceleration_m_s2, 11.0);
  EXPECT_LT((frames.back().pose.position - path(1.0).position).norm(), 1e-12);
  EXPECT_LT(angleBetween(frames.back().pose, path(1.0)), 1e-7);
}

TEST(PosePlayback, AClockThatJumpsBackStartsAgainWithoutAJump) {
  PosePlayback playback;
  Stream before{steady({-1000, 0, 0}, {1, 0, 0}), 50.0};
  before.start_s = 1000.0;
  const Posed last = before.run(playback, 2.0).back().pose;
  Stream after{steady({1.9 - 500, 0, 0}, {1, 0, 0}), 50.0};
  after.start_s = 500.0;
  const auto frames = after.run(playback, 3.0);
  EXPECT_LT((frames.front().pose.position - last.position).norm(), 0.1);
  EXPECT_LT(motionOf(frames, 0.0).acceleration_m_s2, 70.0);
  expectOnPath(frames, after.path, 502.5, 1e-9, 1e-7);
  for (const auto& frame : frames) EXPECT_FALSE(frame.placed);
}

}  // namespace
}  // namespace ice_ice_baby
