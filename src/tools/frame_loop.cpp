#include "frame_loop.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>
#include <vector>

#include "autosave.h"
#include "error_faces.h"
#include "frame_writer.h"
#include "progress_bar.h"
#include "series_writer.h"
#include "stop_signal.h"
#include "trajectory_recorder.h"

namespace ice_ice_baby {

namespace {

/// Root mean square over the last half second, which also sees jitter that a single frame misses.
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

/// Everything that looks at each frame, and the start before them.
class Observers {
 public:
  Observers(Simulation& simulation, const RunOutputs& outputs) : simulation_(simulation) {
    if (!outputs.series.empty()) series_.emplace(outputs.series);
    if (!outputs.record.empty()) record_.emplace(outputs.record, simulation.report().particles);
    const FrameView start = view();
    if (simulation.report().frame == 0) watches_ = watchesFor(start);
    write(start);
  }

  /// @return the density error of the frame
  Simulation::DensityError look() {
    const FrameView frame = view();
    for (const auto& watch : watches_) watch->add(frame);
    write(frame);
    return frame.error;
  }

  std::vector<ErrorFace> faces() const {
    std::vector<ErrorFace> faces;
    for (const auto& watch : watches_) watch->tell(faces);
    return faces;
  }

 private:
  FrameView view() {
    simulation_.sample(particles_);
    return {simulation_, particles_, simulation_.measureDensityError()};
  }
  void write(const FrameView& frame) {
    if (series_) series_->add(frame);
    if (record_) record_->add(frame);
  }

  Simulation& simulation_;
  std::vector<ParticleSample> particles_;
  std::optional<SeriesWriter> series_;
  std::optional<TrajectoryRecorder> record_;
  std::vector<std::unique_ptr<ErrorWatch>> watches_;
};

}  // namespace

RunRecord runFrames(Simulation& simulation, const RunOutputs& outputs, double end_s) {
  const Scene& scene = simulation.scene();
  const auto first = static_cast<std::size_t>(simulation.report().frame);
  const auto end = static_cast<std::size_t>(std::ceil(end_s * scene.solver.frame_rate_hz - 1e-9));
  const std::size_t frames = std::max(first, end) - first;
  const double every = std::max(1.0, scene.solver.frame_rate_hz / outputs.frames_hz);
  std::unique_ptr<FrameWriter> pictures;
  if (!outputs.frames.empty()) pictures = std::make_unique<FrameWriter>(outputs.frames, scene);
  Observers observers(simulation, outputs);
  RunRecord record;
  record.started_s = simulation.report().time_s;
  ResidualSpeed residual(scene);
  ProgressBar bar(scene.name, frames);
  std::optional<StopSignal> stop;
  if (!outputs.save.empty()) stop.emplace();
  Autosave autosave(outputs.save, outputs.autosave_s, simulation.report().time_s);
  double next_picture = 0.0;
  for (std::size_t frame = 0; frame < frames; ++frame) {
    if (pictures && double(frame) >= next_picture) {
      pictures->write(simulation);
      next_picture += every;
    }
    const StepReport& report = simulation.advanceFrame();
    record.addFrame(report, observers.look());
    record.steps += std::uint64_t(report.substeps);
    residual.add(report.rms_speed_m_s);
    bar.show(frame + 1, note(report, record));
    if (report.non_finite > 0) break;
    autosave.look(simulation);
    record.stopped = stop && stop->raised();
    if (record.stopped) break;
  }
  record.faces = observers.faces();
  record.escaped = simulation.countEscaped();
  record.residual_speed_m_s = residual.value();
  return record;
}

}  // namespace ice_ice_baby
