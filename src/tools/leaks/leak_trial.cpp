// One trial of scripts/leaks: moves a vessel of water and prints a line of JSON with what went
// through its walls. Exit code 0: ran, 1: bad input.
#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <iostream>
#include <nlohmann/json.hpp>

#include "ice_ice_baby/each_collider.h"
#include "ice_ice_baby/errors.h"
#include "ice_ice_baby/simulation.h"
#include "leaks/leak_watch.h"
#include "leaks/motions.h"

namespace ice_ice_baby::leaks {
namespace {

struct Options {
  std::string vessel = "cup", motion = "shaken", quality = "balanced";
  double spacing_m = 0.006, seconds = 1.0;
  unsigned seed = 1;
  bool list = false;
};

/// With less than this share of its water in it, a vessel starts anew.
constexpr double kEmpty = 0.2;
/// A vessel starts anew no sooner than this.
constexpr double kShortestRun_s = 0.1;
constexpr double kMaxParticles = 30000;

Quality qualityOf(const std::string& word) {
  const std::vector<std::string> words = choices(Quality());
  for (std::size_t k = 0; k < words.size(); ++k) {
    if (word == words[k]) return static_cast<Quality>(k);
  }
  throw InvalidInput("no quality " + shortened(word) + "; there are: " + joined(words));
}

/// One substep per frame, as long as the longest substep of the quality at 60 frames per second.
void setRates(Scene& scene, Quality quality) {
  scene.solver.quality = quality;
  scene.solver.substeps = 0;
  scene.solver.frame_rate_hz = 60.0 * scene.fewestSubsteps();
  scene.solver.substeps = 1;
}

class Trial {
 public:
  explicit Trial(const Options& options)
      : vessel_(makeVessel(options.vessel, options.spacing_m)),
        watch_(vessel_, options.spacing_m),
        options_(options),
        seed_(options.seed) {
    setRates(vessel_.scene, qualityOf(options.quality));
    vessel_.scene.name = options.vessel;
    vessel_.scene.bounds.min_m = Vec3d::Constant(-2.0);
    vessel_.scene.bounds.max_m = Vec3d::Constant(2.0);
    vessel_.scene.limits.max_particles = kMaxParticles;
    for (const Vec3d& vertex : vessel_.walls.vertices) {
      reach_m_ = std::max(reach_m_, (vertex - vessel_.centre_m).norm());
    }
  }

  void run() {
    while (passed_s_ < options_.seconds - 1e-9) runOnce();
  }

  nlohmann::ordered_json result(double wall_s) const;

 private:
  void runOnce();
  void moveTo(const Posed& pose);

  Vessel vessel_;
  LeakWatch watch_;
  Options options_;
  unsigned seed_;
  double reach_m_ = 0.0, passed_s_ = 0.0;
  std::unique_ptr<Simulation> simulation_;
  std::size_t particles_ = 0, runs_ = 0;
  std::uint64_t repaired_ = 0;
};

/// Pose of the vessel that turns about its centre.
Posed about(const Vec3d& centre, const Posed& motion) {
  return {motion.position + centre - motion.rotation * centre, motion.rotation};
}

void Trial::moveTo(const Posed& pose) {
  forEachCollider(vessel_.scene, [&](const Collider& part) {
    const Posed at = part.pose();
    simulation_->moveCollider(part.name, {pose.toWorld(at.position), pose.rotation * at.rotation});
  });
}

/// Until the end of the trial, or until the vessel is nearly empty.
void Trial::runOnce() {
  const SolverParams& solver = vessel_.scene.solver;
  const double frame_s = 1.0 / solver.frame_rate_hz;
  const double limit_m = solver.max_speed_m_s * frame_s;
  simulation_ = makeSimulation(vessel_.scene, Precision::kFloat, 1);
  const auto motion = makeMotion(options_.motion, seed_++);
  std::vector<ParticleSample> samples;
  simulation_->sample(samples);
  watch_.start(samples, {});
  const std::size_t filled = watch_.inside();
  particles_ = samples.size();
  ++runs_;
  Posed last;
  for (double time_s = 0.0; passed_s_ < options_.seconds - 1e-9;) {
    time_s += frame_s;
    passed_s_ += frame_s;
    const Posed pose = about(vessel_.centre_m, motion->at(time_s));
    const Vec3d step = pose.toWorld(vessel_.centre_m) - last.toWorld(vessel_.centre_m);
    const double angle = Eigen::AngleAxisd(last.rotation.transpose() * pose.rotation).angle();
    moveTo(pose);
    simulation_->advanceFrame();
    simulation_->sample(samples);
    watch_.frame(samples, pose, frame_s, step.norm() + std::abs(angle) * reach_m_ > 0.5 * limit_m);
    last = pose;
    const bool empty = double(watch_.inside()) < kEmpty * double(filled);
    if (empty && time_s >= kShortestRun_s) break;
  }
  watch_.finish();
  repaired_ += simulation_->report().non_finite;
}

nlohmann::ordered_json vectorJson(const Vec3d& v) { return {v.x(), v.y(), v.z()}; }

nlohmann::ordered_json Trial::result(double wall_s) const {
  const LeakCounts& counts = watch_.counts();
  nlohmann::ordered_json json{{"vessel", options_.vessel},
                              {"motion", options_.motion},
                              {"spacing_m", options_.spacing_m},
                              {"quality", options_.quality},
                              {"seconds", options_.seconds},
                              {"seed", options_.seed},
                              {"particles", particles_},
                              {"runs", runs_},
                              {"particle_seconds", counts.particle_seconds},
                              {"through_wall", counts.through_wall},
                              {"escaped_over_rim", counts.escaped_over_rim},
                              {"nan", counts.not_finite + repaired_},
                              {"wall_s", wall_s}};
  if (counts.first) {
    json["first_leak"] = {{"time_s", counts.first->time_s},
                          {"id", counts.first->id},
                          {"from_m", vectorJson(counts.first->from)},
                          {"to_m", vectorJson(counts.first->to)}};
  }
  return json;
}

constexpr char kExamples[] = R"(Examples:
  leak_trial --vessel bottle --motion tumbled --spacing 0.006 --quality fast --seconds 2
  leak_trial --list
Exit code: 0 ran, 1 bad input.
)";

void describeOptions(CLI::App& app, Options& o) {
  app.add_option("--vessel", o.vessel, "one of --list (cup)");
  app.add_option("--motion", o.motion, "one of --list (shaken)");
  app.add_option("--spacing", o.spacing_m, "distance between particles, m (0.006)");
  app.add_option("--quality", o.quality, "fast, balanced or accurate (balanced)");
  app.add_option("--seconds", o.seconds, "simulated seconds (1)")->check(CLI::Range(1e-3, 1e6));
  app.add_option("--seed", o.seed, "of the random numbers (1)");
  app.add_flag("--list", o.list, "print the vessels and the motions as JSON");
  app.footer(kExamples);
}

int runTrial(int argc, char** argv) {
  Options options;
  CLI::App app("Moves a vessel of water and counts what passes its walls.", "leak_trial");
  describeOptions(app, options);
  CLI11_PARSE(app, argc, argv);
  if (options.list) {
    const nlohmann::ordered_json names{{"vessels", vesselNames()}, {"motions", motionNames()}};
    std::cout << names.dump() << "\n";
    return 0;
  }
  const auto start = std::chrono::steady_clock::now();
  Trial trial(options);
  trial.run();
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
  std::cout << trial.result(wall.count()).dump() << "\n";
  return 0;
}

}  // namespace
}  // namespace ice_ice_baby::leaks

int main(int argc, char** argv) {
  try {
    return ice_ice_baby::leaks::runTrial(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "leak_trial: %s\n", error.what());
    return 1;
  }
}
