#include "run_report.h"

#include <algorithm>
#include <cinttypes>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string_view>
#include <type_traits>

#include "ice_ice_baby/errors.h"
#include "resident_memory.h"

namespace ice_ice_baby {

namespace {

std::string hexText(std::uint64_t value) {
  char text[17];
  std::snprintf(text, sizeof text, "%016" PRIx64, value);
  return text;
}

/// Collects what a `describe` function visits.
class SettingsReader {
 public:
  explicit SettingsReader(nlohmann::ordered_json& json) : json_(json) {}

  template <class Number>
  void operator()(const char* name, Number& value, Range, const char*) {
    json_[name] = value;
  }
  template <class Word>
  void operator()(const char* name, Word& value, const char*) {
    if constexpr (std::is_enum_v<Word>) {
      json_[name] = choices(value)[std::size_t(value)];
    } else {
      json_[name] = value;
    }
  }

 private:
  nlohmann::ordered_json& json_;
};

/// What was in force, whichever of preset, scene file and overrides said so.
nlohmann::ordered_json settingsOf(Scene scene) {
  nlohmann::ordered_json settings;
  describe(scene.fluid, SettingsReader(settings["fluid"]));
  describe(scene.solver, SettingsReader(settings["solver"]));
  return settings;
}

/// Keys of the two numbers of a frame that are called differently in the report of a whole run.
const char* keyOf(std::string_view name) {
  if (name == "frame") return "frames";
  if (name == "time_s") return "simulated_time_s";
  return name.data();
}

/// What the last frame reported, but where the run has a number of that name.
void putNumbers(const StepReport& report, const RunRecord& record, nlohmann::ordered_json& json) {
  describe(report,
           [&](const char* name, const auto& value, const char*) { json[keyOf(name)] = value; });
  describe(record, [&](const char* name, const auto& value, const char*) { json[name] = value; });
}

/// What each vessel and gauge holds at the end; null for what has no value.
void putVessels(const Simulation& simulation, nlohmann::ordered_json& json) {
  for (const VesselReport& vessel : simulation.vessels()) {
    nlohmann::ordered_json& numbers = json["vessels"][vessel.name];
    describeVessel([&](const char* name, const auto& value, const char*) { numbers[name] = value; },
                   vessel);
  }
}

/// What water and ice did to each collider, if it was measured.
void putWrenches(const RunRecord& record, nlohmann::ordered_json& json) {
  const auto list = [](const Vec3d& v) { return nlohmann::ordered_json{v.x(), v.y(), v.z()}; };
  for (const ColliderWrench& wrench : record.wrenches) {
    json["wrenches"][wrench.name] = {{"force_n", list(wrench.force_n)},
                                     {"torque_n_m", list(wrench.torque_n_m)}};
  }
}

/// Mean over the run of the largest density error beyond which water counts as flying apart.
constexpr double kCrushed = 0.5;

}  // namespace

void RunRecord::addFrame(const StepReport& report) {
  steps += std::uint64_t(report.substeps);
  wall_time_s += report.frame_wall_s;
  speed_limited += report.speed_limited;
  correction_limited += report.correction_limited;
  max_speed_limited = std::max(max_speed_limited, std::size_t(report.speed_limited));
  fastest_m_s = std::max(fastest_m_s, report.max_speed_m_s);
  max_ice = std::max(max_ice, report.strictness);
  max_ice_bodies = std::max(max_ice_bodies, report.ice_bodies);
  max_steam = std::max(max_steam, report.steam_particles);
}

void RunRecord::addSample(const StepReport& report, const DensityError& error) {
  ++samples;
  const double weight = 1.0 / double(samples);
  density_error_mean += weight * (error.mean - density_error_mean);
  density_error_max += weight * (error.max - density_error_max);
  density_error_own_kernel_mean +=
      weight * (report.density_error_mean - density_error_own_kernel_mean);
}

double RunRecord::realTimeFactor(double time_s) const {
  return wall_time_s > 0.0 ? (time_s - started_s) / wall_time_s : 0.0;
}

std::string instability(const RunRecord& record, const StepReport& report) {
  if (report.non_finite > 0) {
    return std::to_string(report.non_finite) + " values were not finite and had to be repaired";
  }
  if (record.escaped > 0) {
    return std::to_string(record.escaped) + " particles left a closed container";
  }
  const std::uint64_t all = report.particles + report.spilled + report.drained;
  if (2 * record.max_speed_limited > all && report.particles > 0) {
    return "the speed limit had to slow more than half of all particles within one frame";
  }
  if (record.density_error_max > kCrushed) {
    return "water was compressed by " + std::to_string(int(100 * record.density_error_max)) +
           " % somewhere in the mean over the run; raise solver.substeps, or set it to 0";
  }
  return "";
}

void requireWritable(const std::string& path, const std::string& what) {
  std::ofstream file(path);
  if (!file) throw InvalidInput("cannot write the " + what + " to " + path);
}

void writeReport(const std::string& path, const Simulation& simulation, const RunRecord& record) {
  const StepReport& report = simulation.report();
  nlohmann::ordered_json json;
  json["scene"] = simulation.scene().name;
  json["preset"] = choices(Preset())[std::size_t(simulation.scene().preset)];
  putNumbers(report, record, json);
  json["real_time_factor"] = record.realTimeFactor(report.time_s);
  json["unstable"] = instability(record, report);
  json["peak_resident_bytes"] = peakResidentBytes();
  json["state_hash"] = hexText(simulation.stateHash());
  json["error"] = nlohmann::ordered_json::object();
  for (const ErrorMetric& metric : record.metrics) {
    if (std::isfinite(metric.value)) json["error"][metric.name] = metric.value;
  }
  putVessels(simulation, json);
  putWrenches(record, json);
  json["settings"] = settingsOf(simulation.scene());
  json["stages"] = nlohmann::ordered_json::array();
  for (const StageStats& stage : simulation.stages()) {
    json["stages"].push_back({{"name", stage.name},
                              {"calls", stage.calls},
                              {"time_s", stage.time_s},
                              {"bytes", stage.bytes}});
  }
  std::ofstream file(path);
  file << json.dump(2) << "\n";
  file.close();
  if (!file) throw InvalidInput("cannot write the report to " + path);
}

std::string profileTable(const Simulation& simulation) {
  double total = 0.0;
  for (const StageStats& stage : simulation.stages()) total += stage.time_s;
  std::string table = "stage               calls     time s   share   us/call        bytes\n";
  for (const StageStats& stage : simulation.stages()) {
    char line[128];
    std::snprintf(line, sizeof line, "%-16s %8" PRIu64 " %10.4f  %5.1f%% %9.1f %12zu\n",
                  stage.name.c_str(), stage.calls, stage.time_s,
                  total > 0 ? 100 * stage.time_s / total : 0.0,
                  stage.calls > 0 ? 1e6 * stage.time_s / double(stage.calls) : 0.0, stage.bytes);
    table += line;
  }
  return table;
}

}  // namespace ice_ice_baby
