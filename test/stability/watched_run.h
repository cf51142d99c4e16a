// A simulation that is checked after every frame, with the figures for scripts/stability.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "ice_ice_baby/scene_loader.h"
#include "metrics/density_meter.h"
#include "metrics/error_metrics.h"
#include "metrics/escape_meter.h"
#include "run_report.h"

namespace ice_ice_baby::test {

/// A scene of config/scenes/stability.
inline Scene stabilityScene(const std::string& name, const std::vector<Override>& changes = {}) {
  return loadScene(std::string(IIB_STABILITY_SCENES) + "/" + name + ".yaml", changes);
}

/// The worst of all runs of a test, and how long they ran together.
struct Figures {
  std::size_t particles = 0, escaped = 0;
  std::uint64_t substeps = 0, non_finite = 0, speed_limited = 0;
  double simulated_s = 0, wall_s = 0, fastest_m_s = 0;
  double density_error_mean = 0, density_error_max = 0, energy_rise = 0;

  void add(const RunRecord& record, const StepReport& report, double rise) {
    particles = std::max(particles, report.particles);
    escaped = std::max(escaped, record.escaped);
    non_finite = std::max(non_finite, report.non_finite);
    speed_limited = std::max(speed_limited, record.speed_limited);
    fastest_m_s = std::max(fastest_m_s, record.fastest_m_s);
    density_error_mean = std::max(density_error_mean, record.density_error_mean);
    density_error_max = std::max(density_error_max, record.density_error_max);
    energy_rise = std::max(energy_rise, rise);
    substeps += record.steps;
    simulated_s += report.time_s;
    wall_s += record.wall_time_s;
  }
  /// Records them as properties of the running test, which --gtest_output=json writes.
  void report() const {
    const auto put = [](const char* name, double value) {
      testing::Test::RecordProperty(name, std::to_string(value));
    };
    put("particles", double(particles));
    put("simulated_s", simulated_s);
    put("substeps", double(substeps));
    put("non_finite", double(non_finite));
    put("escaped", double(escaped));
    put("fastest_m_s", fastest_m_s);
    put("density_error_mean", density_error_mean);
    put("density_error_max", density_error_max);
    put("energy_rise", energy_rise);
    put("speed_limited", double(speed_limited));
    put("wall_s", wall_s);
  }
};

/// A test that is a row of doc/stability.md: `line` names the row, TearDown reports its figures.
class SuiteCase : public testing::Test {
 protected:
  static void line(int number, const char* title, const char* expected) {
    RecordProperty("number", number);
    RecordProperty("title", title);
    RecordProperty("expected", expected);
  }
  void TearDown() override { figures_.report(); }

  Figures figures_;
};

/// Expects of every frame that it is finite and loses no particle, not even out of a closed tank.
class WatchedRun {
 public:
  /// @param figures takes those of this run when it ends
  WatchedRun(Figures& figures, std::unique_ptr<Simulation> simulation)
      : figures_(figures),
        simulation_(std::move(simulation)),
        density_(simulation_->scene()),
        escapes_(simulation_->scene()) {
    simulation_->sample(particles_);
    started_with_ = particles_.size();
    recorders_ = metricsFor(view());
  }
  WatchedRun(Figures& figures, const Scene& scene)
      : WatchedRun(figures, makeSimulation(scene, Precision::kFloat, 1)) {}
  ~WatchedRun() { figures_.add(record_, simulation_->report(), metric("energy_rise")); }
  WatchedRun(const WatchedRun&) = delete;
  WatchedRun& operator=(const WatchedRun&) = delete;

  Simulation& operator*() { return *simulation_; }
  Simulation* operator->() { return simulation_.get(); }
  const std::vector<ParticleSample>& particles() const { return particles_; }
  double fastest_m_s() const { return record_.fastest_m_s; }
  /// Mean over the particles, now.
  double densityError() { return density_.measure(*simulation_, particles_).mean; }

  void frames(int count) {
    for (int k = 0; k < count && !testing::Test::HasFailure(); ++k) frame();
  }
  void frame() {
    const StepReport& report = simulation_->advanceFrame();
    record_.addFrame(report);
    simulation_->sample(particles_);
    const FrameView frame = view();
    for (const auto& recorder : recorders_) recorder->add(frame);
    record_.addSample(report, frame.error);
    record_.escaped = std::max(record_.escaped, escapes_.count(*simulation_, particles_));
    EXPECT_EQ(report.non_finite, 0u) << "frame " << report.frame;
    EXPECT_EQ(particles_.size(), started_with_) << "frame " << report.frame;
    EXPECT_EQ(record_.escaped, 0u) << "frame " << report.frame;
    EXPECT_TRUE(std::isfinite(report.kinetic_energy_j)) << "frame " << report.frame;
  }
  /// Value of a metric of the error, by its name in run_scene --report; 0 if there is none.
  double metric(const std::string& name) const {
    std::vector<ErrorMetric> metrics;
    for (const auto& recorder : recorders_) recorder->report(metrics);
    for (const ErrorMetric& metric : metrics) {
      if (metric.name == name) return metric.value;
    }
    return 0.0;
  }

 private:
  FrameView view() {
    return {*simulation_, particles_, density_.measure(*simulation_, particles_), 0.0};
  }

  Figures& figures_;
  std::unique_ptr<Simulation> simulation_;
  DensityMeter density_;
  EscapeMeter escapes_;
  std::vector<ParticleSample> particles_;
  std::size_t started_with_ = 0;
  std::vector<std::unique_ptr<MetricRecorder>> recorders_;
  RunRecord record_;
};

}  // namespace ice_ice_baby::test
