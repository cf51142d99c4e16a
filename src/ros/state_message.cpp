#include "state_message.h"

#include "geometry.h"
#include "parameters.h"

namespace ice_ice_baby {

namespace {

template <class Choice>
std::string choiceName(Choice choice) {
  return choices(choice)[static_cast<std::size_t>(choice)];
}

}  // namespace

State stateMessage(const Snapshot& snapshot, const std_msgs::Header& header) {
  const StepReport& report = snapshot.report;
  State state;
  state.header = header;
  state.scene = snapshot.scene;
  state.preset = choiceName(snapshot.preset);
  state.precision = choiceName(snapshot.precision);
  state.frame = report.frame;
  state.time_s = report.time_s;
  state.paused = snapshot.paused;
  state.state_hash = snapshot.state_hash;
  state.asleep = report.asleep;
  state.substeps = static_cast<std::uint32_t>(report.substeps);
  state.particles = static_cast<std::uint32_t>(report.particles);
  state.springs = static_cast<std::uint32_t>(report.springs);
  state.temperature = report.temperature_c;
  state.strictness = report.strictness;
  state.heat = snapshot.heat;
  if (snapshot.heat) state.targets = snapshot.colliders;
  state.mean_temperature = report.mean_celsius;
  state.enthalpy_j = report.enthalpy_j;
  state.thermal_speedup = report.thermal_speedup;
  state.ice_bodies = static_cast<std::uint32_t>(report.ice_bodies);
  state.ice_bodies_asleep = static_cast<std::uint32_t>(report.ice_bodies_asleep);
  state.ice_particles = static_cast<std::uint32_t>(report.ice_particles);
  state.steam_particles = static_cast<std::uint32_t>(report.steam_particles);
  state.gravity = vectorMessage(snapshot.gravity_m_s2);
  state.density_error_mean = report.density_error_mean;
  state.density_error_max = report.density_error_max;
  state.kinetic_energy_j = report.kinetic_energy_j;
  state.potential_energy_j = report.potential_energy_j;
  state.elastic_energy_j = report.elastic_energy_j;
  state.max_speed_m_s = report.max_speed_m_s;
  state.rms_speed_m_s = report.rms_speed_m_s;
  state.speed_limited = report.speed_limited;
  state.correction_limited = report.correction_limited;
  state.non_finite = report.non_finite;
  state.frame_wall_s = report.frame_wall_s;
  state.real_time_factor = snapshot.real_time_factor;
  for (const StageStats& stage : snapshot.stages) {
    StageCost cost;
    cost.name = stage.name;
    cost.calls = stage.calls;
    cost.time_s = stage.time_s;
    cost.bytes = stage.bytes;
    state.stages.push_back(cost);
  }
  return state;
}

}  // namespace ice_ice_baby
