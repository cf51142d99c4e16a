#include "frame_loop.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>
#include <vector>

#include "autosave.h"
#include "metrics/error_metrics.h"
#include "metrics/escape_meter.h"
#include "progress_bar.h"
#include "sequences/frame_outputs.h"
#include "series_writer.h"
#include "stop_signal.h"
#include "trajectory_recorder.h"
#include "wrench_log.h"

namespace ice_ice_baby {

namespace {

/// Root mean square over the last half second, which includes jitter that a single frame may miss.
class ResidualSpeed {
 public:
  explicit ResidualSpeed(const Scene& scene)
      : window_(static_cast<std::size_t>(std::max(1.0, 0.5 * scene.solver.frame_rate_hz))) {}

  void add(double speed_m_s) {
    squares_.push_back(speed_m_s * speed_m_s);
    if (squares_.size() > window_) squares_.erase(squares_.begin());
  }
  double value() const {
    double sum = 0.0;
    for (const double square : squares_) sum += square;
    return squares_.empty() ? 0.0 : std::sqrt(sum / double(squares_.size()));
  }

 private:
  std::size_t window_;
  std::vector<double> squares_;
};

std::string note(const StepReport& report, const RunRecord& record) {
  char text[128];
  std::snprintf(text, sizeof text, "%.2f s, x%.2f real time, error %.3f %%, %.1f C", report.time_s,
                record.realTimeFactor(report.time_s), 100 * report.density_error_mean,
                report.temperature_c);
  return text;
}

/// Everything that observes each frame, including the initial state.
class Observers {
 public:
  /// @param wrenches null if they are in no sample
  Observers(const Simulation& simulation, const RunOutputs& outputs, int threads,
            WrenchLog* wrenches)
      : simulation_(simulation),
        wrenches_(wrenches),
        density_(simulation.scene(), threads),
        escapes_(simulation.scene()) {
    if (!outputs.series.empty()) series_.emplace(outputs.series);
    if (!outputs.record.empty()) record_.emplace(outputs.record, simulation.report().particles);
    const FrameView start = view(0.0);
    if (simulation.report().frame == 0) recorders_ = metricsFor(start);
    write(start);
  }

  void look(RunRecord& record) {
    const FrameView frame = view(record.wall_time_s);
    for (const auto& recorder : recorders_) recorder->add(frame);
    write(frame);
    record.addSample(frame.report(), frame.error);
    record.escaped = std::max(record.escaped, escapes_.count(simulation_, particles_));
  }

  std::vector<ErrorMetric> metrics() const {
    std::vector<ErrorMetric> metrics;
    for (const auto& recorder : recorders_) recorder->report(metrics);
    return metrics;
  }

 private:
  FrameView view(double wall_s) {
    const std::uint64_t frame = simulation_.report().frame;
    const double frames = double(std::max<std::uint64_t>(frame - seen_frame_, 1));
    const double frame_wall_s = (wall_s - seen_wall_s_) / frames;
    seen_frame_ = frame;
    seen_wall_s_ = wall_s;
    simulation_.sample(particles_);
    return {simulation_, particles_, density_.measure(simulation_, particles_), frame_wall_s,
            wrenches_ ? wrenches_->takeSample() : std::vector<ColliderWrench>()};
  }
  void write(const FrameView& frame) {
    if (series_) series_->add(frame);
    if (record_) record_->add(frame);
  }

  const Simulation& simulation_;
  WrenchLog* wrenches_;
  DensityMeter density_;
  EscapeMeter escapes_;
  std::vector<ParticleSample> particles_;
  std::uint64_t seen_frame_ = 0;
  double seen_wall_s_ = 0.0;
  std::optional<SeriesWriter> series_;
  std::optional<TrajectoryRecorder> record_;
  std::vector<std::unique_ptr<MetricRecorder>> recorders_;
};

/// Number of the first of `frames` that lies in the last half second.
std::size_t lastHalfSecond(std::size_t frames, const Scene& scene) {
  const auto half = static_cast<std::size_t>(std::ceil(0.5 * scene.solver.frame_rate_hz));
  return frames - std::min(frames, half);
}

}  // namespace

RunRecord runFrames(Simulation& simulation, const RunOutputs& outputs, double end_s, int threads) {
  const Scene& scene = simulation.scene();
  const auto first = static_cast<std::size_t>(simulation.report().frame);
  const auto end = static_cast<std::size_t>(std::ceil(end_s * scene.solver.frame_rate_hz - 1e-9));
  const std::size_t frames = std::max(first, end) - first;
  const double every = std::max(1.0, scene.solver.frame_rate_hz / outputs.frames_hz);
  std::optional<FrameOutputs> sequences;
  if (outputs.folders.any()) sequences.emplace(outputs.folders, scene);
  std::optional<WrenchLog> wrenches;
  if (outputs.wrenches && !outputs.series.empty()) wrenches.emplace(simulation);
  Observers observers(simulation, outputs, threads, wrenches ? &*wrenches : nullptr);
  RunRecord record;
  record.started_s = simulation.report().time_s;
  ResidualSpeed residual(scene);
  ProgressBar bar(scene.name, frames);
  std::optional<StopSignal> stop;
  if (!outputs.save.empty()) stop.emplace();
  Autosave autosave(outputs.save, outputs.autosave_s, simulation.report().time_s);
  const double sample_every =
      outputs.sample_hz > 0.0 ? std::max(1.0, scene.solver.frame_rate_hz / outputs.sample_hz) : 1.0;
  double next_output = 0.0, next_sample = sample_every;
  for (std::size_t frame = 0; frame < frames; ++frame) {
    if (sequences && double(frame) >= next_output) {
      sequences->write(simulation);
      next_output += every;
    }
    if (outputs.wrenches && !wrenches && frame == lastHalfSecond(frames, scene)) {
      wrenches.emplace(simulation);
    }
    const StepReport& report = simulation.advanceFrame();
    record.addFrame(report);
    if (wrenches) wrenches->add();
    if (double(frame + 1) >= next_sample - 1e-9 || frame + 1 == frames || report.non_finite > 0) {
      observers.look(record);
      next_sample += sample_every;
    }
    residual.add(report.rms_speed_m_s);
    bar.show(frame + 1, note(report, record));
    if (report.non_finite > 0) break;
    autosave.look(simulation);
    record.stopped = stop && stop->raised();
    if (record.stopped) break;
  }
  if (sequences) record.written = sequences->finish();
  record.metrics = observers.metrics();
  record.residual_speed_m_s = residual.value();
  if (wrenches) record.wrenches = wrenches->lastHalfSecond();
  return record;
}

}  // namespace ice_ice_baby
