// Every number that a frame reports: member, name and meaning.
//
// `describe` is used by everything that shows these numbers: the JSON and CSV of run_scene,
// checkpoints, /diagnostics, and State.msg, whose comments a test compares with the meanings. A
// visitor is called as visit(name, value, meaning). The unit is at the end of the name; a name
// without one is a count, a ratio, or bool.
#pragma once

#include <cstddef>
#include <cstdint>

namespace ice_ice_baby {

/// Visits the members of several records with the same member names, such as the report and its
/// message: visit(name, value of the first, value of the second, ..., meaning). Omits the wall
/// clock, so the same scene always gives the same values.
template <class Visitor, class... Records>
void describeReproducible(Visitor&& visit, Records&... r) {
  visit("frame", r.frame..., "frames since the start of the scene");
  visit("time_s", r.time_s..., "simulated since the start of the scene");
  visit("particles", r.particles..., "in the scene");
  visit("spilled", r.spilled..., "particles that left the bounds of the scene, since the start");
  visit("poured", r.poured..., "particles that came out of sources, since the start");
  visit(
      "blocked", r.blocked...,
      "particles that could not come out because water or a solid was in the way, since the start");
  visit("sources_stopped", r.sources_stopped...,
        "sources that are on but stopped, because of limits.max_particles");
  visit("drained", r.drained..., "particles that drains removed, since the start");
  visit("springs", r.springs..., "between particles");
  visit("temperature_c", r.temperature_c...,
        "degrees Celsius, of the whole scene; with heat that of the air");
  visit("strictness", r.strictness..., "0 liquid ... 1 frozen; with heat the share of ice by mass");
  visit("asleep", r.asleep..., "frozen and at rest: frames cost nothing");
  visit("density_error_mean", r.density_error_mean...,
        "mean of max(rho / rho_0 - 1, 0), measured with the solver's own kernel");
  visit("density_error_max", r.density_error_max..., "maximum of the same");
  visit("density_error_run", r.density_error_run..., "mean of density_error_mean over all frames");
  visit("promised_error", r.promised_error...,
        "density_error_run that solver.quality or solver.target_error asks for; 0: none");
  visit("quality_met", r.quality_met...,
        "whether density_error_run is as small as promised, or frames fit in solver.budget");
  visit("kinetic_energy_j", r.kinetic_energy_j..., "of all particles");
  visit("potential_energy_j", r.potential_energy_j..., "against gravity, 0 at the origin");
  visit("elastic_energy_j", r.elastic_energy_j...,
        "stored in compressed water and stretched springs");
  visit("max_speed_m_s", r.max_speed_m_s..., "of the fastest particle");
  visit("rms_speed_m_s", r.rms_speed_m_s..., "root mean square over the particles");
  visit("speed_limited", r.speed_limited...,
        "particles and ice bodies slowed to solver.max_speed_m_s in this frame");
  visit("correction_limited", r.correction_limited...,
        "corrections cut to solver.max_correction_h in this frame");
  visit("non_finite", r.non_finite...,
        "values repaired since the start because they were not finite");
  visit("substeps", r.substeps..., "of this frame; 0 asleep");
  visit("coarse_nodes", r.coarse_nodes...,
        "nodes of the coarse level that carried water in the last substep");
  visit("mean_celsius", r.mean_celsius...,
        "degrees Celsius, mean over the particles; 0 without heat");
  visit("enthalpy_j", r.enthalpy_j...,
        "of all particles, 0 for ice at the freezing point; 0 without heat");
  visit("thermal_speedup", r.thermal_speedup...,
        "seconds of heat that passed in a simulated second; 0 without heat");
  visit("ice_bodies", r.ice_bodies..., "rigid bodies of ice");
  visit("ice_bodies_asleep", r.ice_bodies_asleep..., "those of them that are at rest and sleep");
  visit("ice_particles", r.ice_particles..., "of phase ice; 0 without heat");
  visit("steam_particles", r.steam_particles..., "of phase steam, which the density solver skips");
  visit("solids", r.solids..., "floating solids in the scene");
  visit("solids_asleep", r.solids_asleep..., "floating solids that are at rest and sleep");
}

/// The same, including the wall clock.
template <class Visitor, class... Records>
void describeAll(Visitor&& visit, Records&... r) {
  describeReproducible(visit, r...);
  visit("frame_wall_s", r.frame_wall_s..., "wall time that the frame took to compute");
}

/// State of the whole scene after a frame. Sums run in particle order, so they are bit-identical
/// for any number of threads.
struct StepReport {
  std::uint64_t frame = 0;
  double time_s = 0.0;
  std::size_t particles = 0;
  std::uint64_t spilled = 0;
  std::uint64_t poured = 0;
  std::uint64_t blocked = 0;
  std::size_t sources_stopped = 0;
  std::uint64_t drained = 0;
  std::size_t springs = 0;
  double temperature_c = 0.0;
  double strictness = 0.0;
  bool asleep = false;
  double density_error_mean = 0.0;
  double density_error_max = 0.0;
  double density_error_run = 0.0;
  double promised_error = 0.0;
  bool quality_met = true;
  double kinetic_energy_j = 0.0;
  double potential_energy_j = 0.0;
  double elastic_energy_j = 0.0;
  double max_speed_m_s = 0.0;
  double rms_speed_m_s = 0.0;
  std::uint64_t speed_limited = 0;
  std::uint64_t correction_limited = 0;
  std::uint64_t non_finite = 0;
  int substeps = 0;
  std::size_t coarse_nodes = 0;
  double mean_celsius = 0.0;
  double enthalpy_j = 0.0;
  double thermal_speedup = 0.0;
  std::size_t ice_bodies = 0;
  std::size_t ice_bodies_asleep = 0;
  std::size_t ice_particles = 0;
  std::size_t steam_particles = 0;
  std::size_t solids = 0;
  std::size_t solids_asleep = 0;
  double frame_wall_s = 0.0;

  /// For checkpoints, whose bytes do not depend on the machine.
  template <class Self, class Archive>
  static void exchange(Self& self, Archive& archive) {
    describeReproducible([&](const char*, auto& value, const char*) { archive(value); }, self);
  }
};

template <class Visitor>
void describe(StepReport& report, Visitor&& visit) {
  describeAll(visit, report);
}

template <class Visitor>
void describe(const StepReport& report, Visitor&& visit) {
  describeAll(visit, report);
}

}  // namespace ice_ice_baby
