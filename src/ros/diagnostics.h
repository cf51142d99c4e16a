// The state of the node on /diagnostics.
#pragma once

#include <diagnostic_updater/diagnostic_updater.h>

#include "checkpoints.h"
#include "clock_publisher.h"
#include "frames.h"
#include "parameters.h"
#include "simulation_thread.h"
#include "topics.h"

namespace ice_ice_baby {

/// What diagnostics read.
struct Diagnosed {
  const SimulationThread& simulation;
  const Frames& frames;
  const Topics& topics;
  const ClockPublisher& clock;
  const Checkpoints& checkpoints;
};

class Diagnostics {
 public:
  /// @param node, node_private their callback queue runs the timer
  Diagnostics(ros::NodeHandle& node, ros::NodeHandle& node_private,
              const NodeParameters& parameters, const Diagnosed& diagnosed);

 private:
  using Status = diagnostic_updater::DiagnosticStatusWrapper;

  void solver(Status& status);
  void speed(Status& status);
  void addSources(Status& status, const Snapshot& now);
  void addRobot(Status& status, const Snapshot& now);
  void topics(Status& status);
  void followers(Status& status);
  void frames(Status& status);
  void clock(Status& status);
  void checkpoints(Status& status);

  const double wanted_factor_;
  const Diagnosed of_;
  diagnostic_updater::Updater updater_;
  std::uint64_t speed_limited_ = 0;
  std::uint64_t correction_limited_ = 0;
  std::uint64_t refused_ = 0;
  std::uint64_t jumps_ = 0;
  std::uint64_t bounded_ = 0;
  std::uint64_t waits_ = 0;
  bool robot_warned_ = false;
  bool sources_warned_ = false;
  bool clock_missed_ = false;
  ros::WallTimer timer_;
};

}  // namespace ice_ice_baby
