// Runs a scene without ROS. Exit code 0: ran, 1: bad input, 2: became unstable.
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <iostream>
#include <new>
#include <optional>
#include <thread>

#include "frame_loop.h"
#include "ice_ice_baby/checkpoint.h"
#include "ice_ice_baby/errors.h"
#include "ice_ice_baby/mesh_warnings.h"
#include "ice_ice_baby/quality_warning.h"
#include "ice_ice_baby/scene_loader.h"
#include "ice_ice_baby/source_warning.h"
#include "output_space.h"
#include "run_options.h"
#include "run_report.h"
#include "series_writer.h"

namespace ice_ice_baby {
namespace {

enum ExitCode { kRan = 0, kBadInput = 1, kUnstable = 2 };

Precision parsePrecision(const std::string& word) {
  if (word.empty() || word == "float") return Precision::kFloat;
  if (word == "double") return Precision::kDouble;
  throw InvalidInput("--precision " + word + " must be float or double");
}

Scene readScene(const Options& options) {
  if (options.scene.empty()) throw InvalidInput("name a scene; run_scene --list shows them");
  std::vector<Override> overrides;
  if (!options.preset.empty()) overrides.push_back({"preset", options.preset});
  if (!options.quality.empty()) overrides.push_back({"solver.quality", options.quality});
  for (const std::string& text : options.overrides) overrides.push_back(parseOverride(text));
  return loadScene(options.scene, overrides);
}

/// Warnings about limits of the solver that took effect.
void warnOfLimits(const Scene& scene, std::size_t particles, const RunRecord& record) {
  if (record.speed_limited > 0) {
    std::fprintf(stderr,
                 "run_scene: warning: solver.max_speed_m_s = %g slowed particles %llu times\n",
                 scene.solver.max_speed_m_s, static_cast<unsigned long long>(record.speed_limited));
  }
  constexpr double kManyCut = 0.01;  // fraction of the particles in a substep
  if (double(record.correction_limited) > kManyCut * double(particles) * double(record.steps)) {
    std::fprintf(stderr,
                 "run_scene: warning: solver.max_correction_h = %g cut %llu corrections: the water "
                 "is softer than it should be; raise solver.substeps\n",
                 scene.solver.max_correction_h,
                 static_cast<unsigned long long>(record.correction_limited));
  }
}

void warnOfQuality(const StepReport& report) {
  const std::string warning = qualityWarning(report);
  if (!warning.empty()) std::fprintf(stderr, "run_scene: warning: %s\n", warning.c_str());
}

void warnOfSources(const Simulation& simulation) {
  const std::string warning = sourceWarning(simulation.scene(), simulation.report());
  if (!warning.empty()) std::fprintf(stderr, "run_scene: warning: %s\n", warning.c_str());
}

/// Particles that came or left, if any.
void printPopulation(const StepReport& report) {
  const auto print = [](std::uint64_t count, const char* what) {
    if (count > 0) std::printf("%llu particles %s\n", static_cast<unsigned long long>(count), what);
  };
  print(report.spilled, "left the bounds of the scene");
  print(report.poured, "came out of sources");
  print(report.blocked, "could not come out of sources: water or a solid was in the way");
  print(report.drained, "were removed by drains");
}

void printSummary(const Simulation& simulation, const RunRecord& record) {
  const StepReport& report = simulation.report();
  std::printf(
      "%s: %zu particles, %.3f s in %.3f s (x%.2f real time, %.2f ms per frame), density error "
      "mean "
      "%.4f %% max %.2f %%, %zu springs, rms speed %.4f m/s%s\n",
      simulation.scene().name.c_str(), report.particles, report.time_s, record.wall_time_s,
      record.realTimeFactor(report.time_s),
      record.samples > 0 ? 1e3 * record.wall_time_s / double(record.samples) : 0.0,
      100 * record.density_error_mean, 100 * record.density_error_max, report.springs,
      report.rms_speed_m_s, report.asleep ? ", asleep" : "");
  for (const WrittenSequence& one : record.written) {
    std::printf("%zu %s in %s, %.1f ms each\n", one.frames, one.what.c_str(), one.folder.c_str(),
                1e3 * one.wall_s / double(std::max<std::size_t>(one.frames, 1)));
  }
  printPopulation(report);
  warnOfLimits(simulation.scene(), report.particles + report.spilled + report.drained, record);
  warnOfSources(simulation);
  warnOfQuality(simulation.report());
}

/// A checkpoint contains its scene, so options that change the scene are refused with --load.
void requireOnlyCheckpoint(const Options& options) {
  const std::vector<std::pair<std::string, bool>> given = {
      {"a scene", !options.scene.empty()},
      {"--preset", !options.preset.empty()},
      {"--quality", !options.quality.empty()},
      {"--precision", !options.precision.empty()},
      {"--set", !options.overrides.empty()}};
  for (const auto& [what, there] : given) {
    if (!there) continue;
    throw InvalidInput("--load " + options.load + " and " + what +
                       " contradict each other: a checkpoint goes on as it is; leave out one");
  }
}

std::unique_ptr<Simulation> makeOrLoad(const Options& options) {
  if (options.load.empty()) {
    const Precision precision = parsePrecision(options.precision);
    return makeSimulation(readScene(options), precision, options.threads);
  }
  requireOnlyCheckpoint(options);
  return loadCheckpoint(options.load, options.threads);
}

void requireOutputs(const Options& options, const Scene& scene, double end_s) {
  const RunOutputs& outputs = options.outputs;
  requireInRange("--duration", end_s, 0.0, 1e6);
  requireInRange("--frames-hz", outputs.frames_hz, 1e-3, 1e4);
  requireInRange("--sample-hz", outputs.sample_hz, 0.0, 1e4);
  requireInRange("--autosave", outputs.autosave_s, 0.0, 1e6);
  if (outputs.autosave_s > 0.0 && outputs.save.empty()) {
    throw InvalidInput("--autosave needs --save FILE, which says where to");
  }
  if (!outputs.record.empty() && !scene.sources.empty()) {
    throw InvalidInput("--record writes one column per particle of the start, and scene " +
                       scene.name +
                       " has sources, which add particles; use --particles or --series");
  }
  requireDiskSpace(outputs, scene, end_s);
  if (!outputs.save.empty()) requireSavable(outputs.save);
  if (!options.report.empty()) requireWritable(options.report, "report");
  if (!options.particles.empty()) requireWritable(options.particles, "particles");
}

void saveEnd(const Simulation& simulation, const RunRecord& record, const std::string& path) {
  if (path.empty()) return;
  saveCheckpoint(simulation, path);
  if (!record.stopped) return;
  std::fprintf(stderr, "run_scene: stopped at %.3f s; go on with run_scene --load %s\n",
               simulation.report().time_s, path.c_str());
}

int runScene(const Options& options) {
  const auto simulation = makeOrLoad(options);
  const double end_s = options.duration_s.value_or(simulation->scene().duration_s);
  requireOutputs(options, simulation->scene(), end_s);
  if (simulation->report().particles == 0 && simulation->scene().sources.empty()) {
    std::fprintf(stderr,
                 "run_scene: warning: scene \"%s\" holds no water: it has no blocks or sources\n",
                 simulation->scene().name.c_str());
  }
  for (const std::string& warning : meshWarnings(simulation->scene())) {
    std::fprintf(stderr, "run_scene: warning: %s\n", warning.c_str());
  }
  simulation->countFlows(!options.report.empty());
  RunRecord record = runFrames(*simulation, options.outputs, end_s, options.threads);
  record.precision = simulation->precision() == Precision::kDouble ? "double" : "float";
  record.threads = options.threads > 0 ? options.threads : int(std::thread::hardware_concurrency());
  printSummary(*simulation, record);
  if (options.profile) std::printf("%s", profileTable(*simulation).c_str());
  if (!options.report.empty()) writeReport(options.report, *simulation, record);
  if (!options.particles.empty()) writeParticles(options.particles, *simulation);
  const std::string why = instability(record, simulation->report());
  if (why.empty()) {  // otherwise keep the previous checkpoint
    saveEnd(*simulation, record, options.outputs.save);
    return kRan;
  }
  std::fprintf(stderr, "run_scene: became unstable: %s\n", why.c_str());
  return kUnstable;
}

/// Lists the other scenes even if one is invalid.
int listScenes() {
  ExitCode code = kRan;
  for (const std::string& name : sceneNames()) {
    try {
      std::printf("%-20s %s\n", name.c_str(), loadScene(name).description.c_str());
    } catch (const InvalidInput& e) {
      std::fprintf(stderr, "run_scene: %s\n", e.what());
      code = kBadInput;
    }
  }
  return code;
}

int run(const Options& options) {
  try {
    if (options.defaults) return std::printf("%s", defaultYaml().c_str()) < 0 ? kBadInput : kRan;
    if (options.list) return listScenes();
    return runScene(options);
  } catch (const InvalidInput& e) {
    std::fprintf(stderr, "run_scene: %s\n", e.what());
    return kBadInput;
  } catch (const std::bad_alloc&) {
    std::fprintf(stderr, "run_scene: not enough memory; enlarge fluid.spacing_m\n");
    return kBadInput;
  }
}

}  // namespace
}  // namespace ice_ice_baby

int main(int argc, char** argv) {
  ice_ice_baby::Options options;
  CLI::App app("Runs a scene of water that freezes and melts, without ROS.", "run_scene");
  ice_ice_baby::describeOptions(app, options);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() == 0) return app.exit(e);  // --help
    std::fprintf(stderr, "run_scene: %s; run_scene --help has every option\n", e.what());
    return ice_ice_baby::kBadInput;
  }
  return ice_ice_baby::run(options);
}
