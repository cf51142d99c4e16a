#include "diagnostics.h"

#include <algorithm>
#include <cmath>

#include "heat_status.h"
#include "ice_ice_baby/errors.h"
#include "ice_ice_baby/quality_warning.h"

namespace ice_ice_baby {

namespace {

using Level = diagnostic_msgs::DiagnosticStatus;

/// Below this fraction of the requested real-time factor the machine is overloaded.
constexpr double kKeepsUp = 0.9;

/// A splash limits a few corrections; a larger fraction of them in a frame means too few substeps.
constexpr double kManyCut = 0.01;

constexpr const char* kClockMissed =
    "waiting for /clock: /use_sim_time is true, but no node publishes /clock. Start one that does, "
    "or restart this node with ~publish_clock true or /use_sim_time false";

}  // namespace

Diagnostics::Diagnostics(ros::NodeHandle& node, ros::NodeHandle& node_private,
                         const NodeParameters& parameters, const Diagnosed& diagnosed)
    : wanted_factor_(parameters.real_time_factor),
      of_(diagnosed),
      updater_(node, node_private, node_private.getNamespace()) {
  updater_.setHardwareID("none");
  updater_.add("solver", this, &Diagnostics::solver);
  updater_.add("real time", this, &Diagnostics::speed);
  updater_.add("topics", this, &Diagnostics::topics);
  updater_.add("followed frames", this, &Diagnostics::followers);
  updater_.add("frames", this, &Diagnostics::frames);
  updater_.add("checkpoints", this, &Diagnostics::checkpoints);
  if (of_.clock.wanted() || ros::Time::isSimTime())
    updater_.add("clock", this, &Diagnostics::clock);
  timer_ =
      node_private.createWallTimer(ros::WallDuration(parameters.diagnostic_period),
                                   [this](const ros::WallTimerEvent&) { updater_.force_update(); });
}

void Diagnostics::solver(Status& status) {
  const Snapshot now = of_.simulation.snapshot();
  const StepReport& report = now.report;
  const std::uint64_t limited = now.speed_limited - speed_limited_;
  speed_limited_ = now.speed_limited;
  const std::uint64_t cut = now.correction_limited - correction_limited_;
  correction_limited_ = now.correction_limited;
  const std::uint64_t refused = now.refused - refused_;
  refused_ = now.refused;
  status.summary(Level::OK, now.paused ? "paused" : "running");
  if (limited > 0) {
    status.summary(
        Level::WARN,
        "particles reach the speed limit; raise solver.max_speed_m_s or solver.substeps, or "
        "move colliders more slowly");
  }
  if (report.correction_limited > kManyCut * double(report.particles) * report.substeps) {
    status.mergeSummary(Level::WARN,
                        "corrections are limited, so the water is too compressible; raise "
                        "solver.substeps");
  }
  if (!report.quality_met) status.mergeSummary(Level::WARN, qualityWarning(report));
  if (report.non_finite > 0) {
    status.summary(Level::WARN, "non-finite values were repaired; raise solver.substeps");
  }
  if (refused > 0) {
    status.mergeSummary(Level::WARN, "an accepted command failed: " + now.refusal);
  }
  addHeat(status, now);
  addSources(status, now);
  if (!now.failure.empty()) {
    status.summary(Level::ERROR, "paused because a frame failed: " + now.failure);
  }
  status.add("scene", now.scene);
  describe(report,
           [&](const char* name, const auto& value, const char*) { status.add(name, value); });
  status.add("speed limited since the last message", limited);
  status.add("corrections cut since the last message", cut);
}

/// The log gets the warning once, diagnostics as long as it holds.
void Diagnostics::addSources(Status& status, const Snapshot& now) {
  const bool warned = sources_warned_;
  sources_warned_ = !now.source_warning.empty();
  if (!sources_warned_) return;
  status.mergeSummary(Level::WARN, now.source_warning);
  if (!warned) ROS_WARN("%s", now.source_warning.c_str());
}

void Diagnostics::speed(Status& status) {
  const Snapshot now = of_.simulation.snapshot();
  const bool watched = !now.paused && wanted_factor_ > 0.0 && now.report.frame > 1;
  if (watched && now.real_time_factor < kKeepsUp * wanted_factor_) {
    status.summary(Level::WARN, "slower than requested: real-time factor " +
                                    numberText(now.real_time_factor) + " of " +
                                    numberText(wanted_factor_) +
                                    "; use fewer particles, substeps or iterations");
  } else {
    status.summary(Level::OK, now.paused ? "paused" : "on time");
  }
  addRobot(status, now);
  status.add("real-time factor", now.real_time_factor);
  status.add("real-time factor requested", wanted_factor_);
  status.add("frame [ms]", 1e3 * now.report.frame_wall_s);
  for (const StageStats& stage : now.stages) {
    const double frames = now.report.frame > 0 ? double(now.report.frame) : 1.0;
    status.add(stage.name + " [ms per frame]", 1e3 * stage.time_s / frames);
  }
}

/// A robot in real time does not wait for slow water.
void Diagnostics::addRobot(Status& status, const Snapshot& now) {
  const bool fast = now.real_time_factor > 0.0 && now.real_time_factor < kKeepsUp && !now.paused &&
                    now.report.frame > 60;
  const auto frames = of_.frames.followers().report().frames;
  const bool robot =
      !ros::Time::isSimTime() && std::any_of(frames.begin(), frames.end(),
                                             [](const auto& frame) { return frame.rate_hz > 0.0; });
  if (!fast || !robot) {
    robot_warned_ = false;
    return;
  }
  const std::string warning =
      "a robot on tf is " + numberText(std::round(10.0 / now.real_time_factor) / 10.0) +
      " times as fast for the water, which spills; use fewer particles or more threads, move the "
      "robot more slowly, or run it in simulated time with ~publish_clock";
  status.mergeSummary(Level::WARN, warning);
  if (!robot_warned_) ROS_WARN("Slower than real time: %s", warning.c_str());
  robot_warned_ = true;
}

void Diagnostics::topics(Status& status) {
  status.summary(Level::OK, "messages are built only for topics with subscribers");
  for (const TopicLoad& load : of_.topics.loads()) {
    status.add(load.name + " subscribers", load.subscribers);
    status.add(load.name + " messages", load.messages);
    status.add(load.name + " bytes", load.bytes);
  }
}

void Diagnostics::followers(Status& status) {
  const std::vector<std::string> lost = of_.frames.followers().lost();
  const Followers::Report now = of_.frames.followers().report();
  status.summary(Level::OK, "none missing");
  const auto tell = [&](const Followers::Count& what, std::uint64_t& told) {
    if (what.count > told) status.mergeSummary(Level::WARN, what.latest);
    told = what.count;
  };
  tell(now.jumps, jumps_);
  tell(now.bounded, bounded_);
  tell(now.waits, waits_);
  if (!lost.empty()) status.mergeSummary(Level::WARN, joined(lost));
  status.add("jumps since the start", now.jumps.count);
  status.add("frames bounded since the start", now.bounded.count);
  status.add("frames that waited in vain since the start", now.waits.count);
  for (const Followers::Report::Frame& frame : now.frames) {
    status.add(frame.follower + " age [s]", frame.age_s);
    status.add(frame.follower + " rate [Hz]", frame.rate_hz);
    status.add(frame.follower + " delay [s]", frame.delay_s);
  }
}

void Diagnostics::frames(Status& status) {
  const std::string clash = of_.frames.clash();
  status.summary(clash.empty() ? Level::OK : Level::WARN,
                 clash.empty() ? "no other node sends a frame of this one" : clash);
}

void Diagnostics::clock(Status& status) {
  const std::string other = of_.clock.conflict();
  const bool missed = ros::Time::isSimTime() && !ros::Time::isValid();
  status.summary(Level::OK, of_.clock.wanted() ? "this node publishes /clock" : "follows /clock");
  if (!other.empty()) {
    status.summary(Level::ERROR, other + " publishes /clock already, so this node does not");
  } else if (missed) {
    status.summary(Level::WARN, kClockMissed);
    if (!clock_missed_) ROS_WARN("%s", kClockMissed);
  }
  clock_missed_ = missed;
}

void Diagnostics::checkpoints(Status& status) {
  const Checkpoints::Status now = of_.checkpoints.status();
  status.summary(Level::OK, now.latest.empty() ? "none yet" : "latest: " + now.latest);
  if (!now.broken.empty()) {
    const std::string start = now.resumed.empty() ? "started the scene instead"
                                                  : "resumed from " + now.resumed + " instead";
    status.summary(Level::WARN, start + ": " + joined(now.broken));
  }
  if (!now.problem.empty()) status.summary(Level::ERROR, "the latest save failed: " + now.problem);
  status.add("folder", now.folder);
  status.add("saved since the start", now.saved);
}

}  // namespace ice_ice_baby
