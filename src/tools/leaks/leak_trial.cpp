// One trial of scripts/leaks: moves a vessel of water and prints a line of JSON for each motion
// with what went through its walls. Exit code 0: ran, 1: bad input.
#include <CLI/CLI.hpp>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <nlohmann/json.hpp>
#include <utility>

#include "ice_ice_baby/each_collider.h"
#include "ice_ice_baby/errors.h"
#include "ice_ice_baby/simulation.h"
#include "leaks/leak_watch.h"
#include "leaks/motions.h"

namespace ice_ice_baby::leaks {
namespace {

struct Options {
  std::string vessel = "cup", quality = "balanced";
  std::vector<std::string> motions;
  double spacing_m = 0.006, seconds = 1.0;
  unsigned seed = 1;
  bool in_box = false;
  bool list = false;
};

/// A motion ends when an open vessel has less than this share of its water.
constexpr double kEmpty = 0.2;
/// Time that a vessel takes to stand upright before a motion.
constexpr double kUpright_s = 0.1;
constexpr double kMaxParticles = 30000, kBound_m = 10.0;

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
  explicit Trial(const Options& options);

  /// Makes a motion with the water of the last one. @return its results
  nlohmann::ordered_json run(const std::string& motion);

 private:
  void standUpright();
  void frame(const Posed& pose);
  void moveTo(const Posed& pose);
  bool placed(const Posed& pose) const;

  Options options_;
  Vessel vessel_;
  LeakWatch watch_;
  std::unique_ptr<Simulation> simulation_;
  std::vector<ParticleSample> samples_;
  std::size_t particles_ = 0, filled_ = 0;
  std::uint64_t repaired_ = 0;
  double reach_m_ = 0.0, frame_s_ = 0.0;
  Posed pose_;
};

Trial::Trial(const Options& options)
    : options_(options),
      vessel_(makeVessel(options.vessel, options.spacing_m, options.in_box)),
      watch_(vessel_, options.spacing_m) {
  Scene& scene = vessel_.scene;
  setRates(scene, qualityOf(options.quality));
  scene.bounds.min_m = Vec3d::Constant(-kBound_m);
  scene.bounds.max_m = Vec3d::Constant(kBound_m);
  scene.limits.max_particles = kMaxParticles;
  for (const Vec3d& vertex : vessel_.walls.vertices) {
    reach_m_ = std::max(reach_m_, (vertex - vessel_.centre_m).norm());
  }
  simulation_ = makeSimulation(scene, Precision::kFloat, 1);
  simulation_->sample(samples_);
  particles_ = samples_.size();
  watch_.start(samples_, pose_);
  filled_ = watch_.inside();
  frame_s_ = 1.0 / scene.solver.frame_rate_hz;
}

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

/// Whether a pose may be so far away that colliders jump there instead of sweeping.
bool Trial::placed(const Posed& pose) const {
  const SolverParams& solver = vessel_.scene.solver;
  const Vec3d step = pose.toWorld(vessel_.centre_m) - pose_.toWorld(vessel_.centre_m);
  const double angle = Eigen::AngleAxisd(pose_.rotation.transpose() * pose.rotation).angle();
  return step.norm() + std::abs(angle) * reach_m_ >
         0.5 * solver.max_speed_m_s / solver.frame_rate_hz;
}

void Trial::frame(const Posed& pose) {
  moveTo(pose);
  simulation_->advanceFrame();
  simulation_->sample(samples_);
  watch_.frame(samples_, pose, frame_s_, placed(pose));
  pose_ = pose;
}

/// Turns about its centre, which stays where it is.
void Trial::standUpright() {
  const Vec3d centre = pose_.toWorld(vessel_.centre_m) - vessel_.centre_m;
  const Eigen::Quaterniond from(pose_.rotation);
  const int frames = int(std::ceil(kUpright_s / frame_s_));
  for (int k = 1; k <= frames; ++k) {
    const auto turned = from.slerp(double(k) / frames, Eigen::Quaterniond::Identity());
    frame(about(vessel_.centre_m, {centre, turned.toRotationMatrix()}));
  }
}

nlohmann::ordered_json vectorJson(const Vec3d& v) { return {v.x(), v.y(), v.z()}; }

nlohmann::ordered_json Trial::run(const std::string& name) {
  const auto start = std::chrono::steady_clock::now();
  const auto motion = makeMotion(name, options_.seed);
  if (!pose_.rotation.isIdentity()) standUpright();
  const Vec3d base = pose_.position;
  const bool may_end = vessel_.rim_m && !options_.in_box;
  double time_s = 0.0;
  while (time_s < options_.seconds - 1e-9) {
    if (may_end && double(watch_.inside()) < kEmpty * double(filled_)) break;
    time_s += frame_s_;
    Posed pose = motion->at(time_s);
    pose.position += base;
    frame(about(vessel_.centre_m, pose));
  }
  const LeakCounts counts = watch_.take();
  const std::uint64_t repaired = simulation_->report().non_finite;
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
  nlohmann::ordered_json json{
      {"vessel", options_.vessel},
      {"motion", name},
      {"spacing_m", options_.spacing_m},
      {"quality", options_.quality},
      {"in_box", options_.in_box},
      {"seconds", time_s},
      {"seed", options_.seed},
      {"particles", particles_},
      {"particle_seconds", counts.particle_seconds},
      {"through_wall", counts.through_wall},
      {"escaped_over_rim", counts.escaped_over_rim},
      {"nan", counts.not_finite + repaired - std::exchange(repaired_, repaired)},
      {"wall_s", wall.count()}};
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
  app.add_option("--motion", o.motions, "some of --list, one after the other (all of them)");
  app.add_option("--spacing", o.spacing_m, "distance between particles, m (0.006)");
  app.add_option("--quality", o.quality, "fast, balanced or accurate (balanced)");
  app.add_option("--seconds", o.seconds, "simulated seconds of each motion (1)")
      ->check(CLI::Range(1e-3, 1e6));
  app.add_option("--seed", o.seed, "of the random numbers (1)");
  app.add_flag("--in-box", o.in_box,
               "an open vessel stands in a closed box that moves along, so its water stays near");
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
  if (options.motions.empty()) options.motions = motionNames();
  for (const std::string& motion : options.motions) makeMotion(motion, options.seed);
  Trial trial(options);
  for (const std::string& motion : options.motions) {
    std::cout << trial.run(motion).dump() << std::endl;
  }
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
