// Poses of a tf frame as they arrive, and the pose between them.
#pragma once

#include <cstddef>
#include <deque>

#include "ice_ice_baby/types.h"

namespace ice_ice_baby {

/// A pose of a frame. Both times are ROS time, s, from any common origin.
struct PoseSample {
  double stamp_s = 0.0;    ///< when the frame was there
  double arrival_s = 0.0;  ///< when the message arrived
  Posed pose;
};

/// Distance between two samples that is a teleport: nothing moves like that.
struct Teleport {
  double distance_m = 0.5;  ///< and further
  double speed_m_s = 30.0;  ///< and faster
};

/// The last 3 s of samples, at most 4096, in the order of their stamps.
class PoseSamples {
 public:
  explicit PoseSamples(const Teleport& teleport = {}) : teleport_(teleport) {}

  /// Adds a sample. A clock that jumps back (arrivals, or stamps by more than 2 s) drops all
  /// samples before it.
  /// @returns false for a sample that changes nothing: not finite or beyond 1e12 m, of a stamp that
  /// exists already, older than the oldest one, or late and a teleport away from its neighbours
  bool add(const PoseSample& sample);
  void clear();

  /// Grows by one whenever all samples are dropped.
  std::uint64_t epoch() const { return epoch_; }
  bool empty() const { return all_.empty(); }
  std::size_t count() const { return all_.size(); }
  const PoseSample& newest() const { return all_.back().sample; }

  /// Samples per second in the last 2 s, Hz; 0 for a single sample.
  double rate_hz() const;
  /// Second largest interval between two stamps in the last 2 s, s, so that a single gap does not
  /// count; of a single interval its length, of a single sample 0. A teleport is no interval.
  double interval_s() const;
  /// Smallest (arrival - stamp) in the last 2 s, s: the delay of the messages and the difference of
  /// the clocks.
  double latency_s() const;
  /// Largest (arrival - previous stamp) in the last 2 s, s; latency_s() for a single sample.
  double silence_s() const;

  /// How a pose was found.
  enum class Source { kRest, kLine, kFit, kEnd };
  struct Reading {
    Source source = Source::kRest;
    Posed pose;
    Vec3d velocity_m_s = Vec3d::Zero();
    Vec3d spin_rad_s = Vec3d::Zero();  ///< in the parent frame
    std::uint64_t segment = 0;         ///< grows by one at each teleport
  };

  /// Pose at a stamp, which is that of the oldest or newest sample outside of them: on the line
  /// between two samples, or on a line fitted to the samples within 60 ms.
  /// @param fit whether to fit where samples come faster than 30 Hz @throws nothing; not empty
  Reading at(double stamp_s, bool fit) const;
  /// Pose and velocity at the newest sample.
  Reading end(bool fit) const;

 private:
  struct Entry {
    PoseSample sample;
    double silence_s = 0.0;  ///< arrival - previous stamp
    std::uint64_t segment = 0;
  };

  bool teleports(const PoseSample& from, const PoseSample& to) const;
  bool addLate(const PoseSample& sample);
  std::size_t firstSince(double stamp_s) const;
  Reading line(std::size_t from, std::size_t to, double stamp_s) const;
  bool fitted(std::size_t centre, double stamp_s, Reading& reading) const;
  void drop();

  const Teleport teleport_;
  std::deque<Entry> all_;
  std::uint64_t segment_ = 0;
  std::uint64_t epoch_ = 0;
  double latest_arrival_s_ = 0.0;
};

}  // namespace ice_ice_baby
