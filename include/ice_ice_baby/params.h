// Every scene parameter once: name, default, allowed range and meaning.
//
// Each struct lists its members in one `describe` function. The YAML reader, the writer of
// config/default.yaml and the overrides all use that list, so a parameter is added in one place.
// A visitor is called as
//   visit(name, value, Range{min, max}, meaning)  numbers; vectors, with the range of each part
//   visit(name, value, meaning)                   bool, text and choices
//   visit.section(name, params, meaning)          a struct of parameters
//   visit.list(name, vector, meaning)             a list of structs
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "ice_ice_baby/types.h"

namespace ice_ice_baby {

struct Range {
  double min;
  double max;
};

/// Largest coordinate at which single precision still resolves a hundredth of a millimetre.
constexpr double kMaxCoordinate_m = 100.0;

constexpr Range kCoordinateRange_m{-kMaxCoordinate_m, kMaxCoordinate_m};

enum class Preset { kDefault, kPaper };
enum class KernelPair { kCubic, kPoly6Spiky };
enum class Quality { kFast, kBalanced, kAccurate };
enum class ThermalBoundary { kInsulated, kTemperature, kFlux };

inline std::vector<std::string> choices(Preset) { return {"default", "paper"}; }
inline std::vector<std::string> choices(KernelPair) { return {"cubic", "poly6_spiky"}; }
inline std::vector<std::string> choices(Quality) { return {"fast", "balanced", "accurate"}; }
inline std::vector<std::string> choices(ThermalBoundary) {
  return {"insulated", "temperature", "flux"};
}

struct FluidParams {
  double spacing_m = 0.0211;
  double support_radius_m = 0.0;
  double rest_density_kg_m3 = 1000.0;
  double particle_mass_kg = 0.0;
  KernelPair kernel = KernelPair::kCubic;
  bool self_density = true;
  bool boundary_density = true;
};

template <class Visitor>
void describe(FluidParams& p, Visitor&& visit) {
  visit("spacing_m", p.spacing_m, Range{1e-4, 10.0},
        "distance d between particles at rest; sets the resolution of the scene");
  visit("support_radius_m", p.support_radius_m, Range{0.0, 40.0},
        "kernel support radius h; 0: 2 d (paper: 0.03 at its own spacing)");
  visit("rest_density_kg_m3", p.rest_density_kg_m3, Range{1e-3, 1e9},
        "rest density rho_0 (paper: 45000)");
  visit("particle_mass_kg", p.particle_mass_kg, Range{0.0, 1e9},
        "mass of a particle; 0: chosen so that a lattice of spacing d has exactly the rest density "
        "(paper: 1)");
  visit("kernel", p.kernel,
        "cubic: cubic spline and its gradient; poly6_spiky: the two kernels of the paper");
  visit("self_density", p.self_density, "whether a particle contributes to its own density");
  visit("boundary_density", p.boundary_density,
        "whether walls and colliders contribute to the density; prevents particles from stacking "
        "there");
}

struct SolverParams {
  double frame_rate_hz = 60.0;
  Quality quality = Quality::kBalanced;
  double target_error = 0.0;
  double budget = 0.0;
  int substeps = 0;
  int iterations = 2;
  double relaxation = 0.0;
  double epsilon = 0.01;
  double warm_start = 0.5;
  bool resist_tension = false;
  bool coarse_level = true;
  double viscosity_1_s = 30.0;
  double max_correction_h = 0.1;
  double max_speed_m_s = 30.0;
};

template <class Visitor>
void describe(SolverParams& p, Visitor&& visit) {
  visit("frame_rate_hz", p.frame_rate_hz, Range{1.0, 10000.0},
        "frames per simulated second; state is reported once a frame");
  visit("quality", p.quality,
        "mean density error that the solver keeps: 1 %, 0.2 % or 0.03 %, with 3, 5 or 10 substeps, "
        "or as many more as that takes; measured in doc/error_vs_runtime.md");
  visit("target_error", p.target_error, Range{0.0, 0.5},
        "mean density error to keep, as a fraction, with 2 to 64 substeps as it needs; 0: that of "
        "the quality");
  visit("budget", p.budget, Range{0.0, 100.0},
        "share of real time that frames may take: as many substeps as fit, down to an error of "
        "0.03 %, "
        "whatever the quality; such runs are not reproducible; 0: none");
  visit("substeps", p.substeps, Range{0, 1000},
        "passes of Algorithm 1 per frame, whatever the error; with a target_error or a budget, in "
        "the "
        "first frame alone; 0: set by quality");
  visit("iterations", p.iterations, Range{0, 1000},
        "solver iterations per substep; 0: particles move ballistically");
  visit("relaxation", p.relaxation, Range{0.0, 1.0},
        "factor on lambda; 0: the largest value that lets water come to rest, given the number of "
        "iterations; larger values overshoot (paper: 1)");
  visit("epsilon", p.epsilon, Range{0.0, 1e3},
        "epsilon of Eq. 5 times h^2, which makes it independent of scale (paper: 9e-5)");
  visit("warm_start", p.warm_start, Range{0.0, 0.5},
        "fraction of the last substep's corrections that the next substep starts with; above 1/2 "
        "slow waves grow (paper: 0)");
  visit("resist_tension", p.resist_tension,
        "whether density below rest is corrected too: Eq. 5 without a clamp; particles clump and "
        "may explode");
  visit(
      "coarse_level", p.coarse_level,
      "whether a coarse grid carries the weight of deep water, so that the error hardly depends on "
      "the depth (paper: false)");
  visit("viscosity_1_s", p.viscosity_1_s, Range{0.0, 1e4},
        "XSPH viscosity: rate at which a particle takes on the velocity of its neighbours; 0: off");
  visit("max_correction_h", p.max_correction_h, Range{0.0, 1.0},
        "maximum correction per iteration, in support radii; 0: unlimited (paper)");
  visit("max_speed_m_s", p.max_speed_m_s, Range{1e-3, 1e5},
        "speed limit; particles that reach it are counted and reported");
}

struct TemperatureParams {
  double initial_c = 20.0;
  double onset_c = 4.0;
  double freezing_c = 0.0;
};

constexpr Range kPowerRange_w{-1e9, 1e9};
constexpr Range kTemperatureRange_c{-273.15, 1000.0};

template <class Visitor>
void describe(TemperatureParams& p, Visitor&& visit) {
  visit("initial_c", p.initial_c, kTemperatureRange_c, "initial temperature of the scene");
  visit("onset_c", p.onset_c, kTemperatureRange_c, "springs exist below this temperature");
  visit("freezing_c", p.freezing_c, kTemperatureRange_c,
        "springs are rigid at and below this temperature; must be below onset_c");
}

struct SpringParams {
  double reach_h = 0.75;
  double slack_1_s = 50.0;
  bool keep_frozen = true;
  bool correct_updated = true;
  bool stick_to_colliders = true;
  double sleep_speed_m_s = 0.01;
};

template <class Visitor>
void describe(SpringParams& p, Visitor&& visit) {
  visit("reach_h", p.reach_h, Range{0.1, 1.0},
        "neighbours up to this distance, in support radii, are joined (paper: 1, all neighbours)");
  visit("slack_1_s", p.slack_1_s, Range{0.0, 1e4},
        "relative change of length per second that a spring allows at onset_c; falls linearly to 0 "
        "at freezing_c");
  visit("keep_frozen", p.keep_frozen,
        "whether frozen springs keep the rest length they froze with; false (paper): new springs "
        "in every substep");
  visit("correct_updated", p.correct_updated,
        "whether springs correct x* after delta p is applied; false (paper): before, so that both "
        "correct the same error and the ice jitters");
  visit("stick_to_colliders", p.stick_to_colliders,
        "whether frozen water sticks to the colliders it touches (paper: false)");
  visit("sleep_speed_m_s", p.sleep_speed_m_s, Range{0.0, 10.0},
        "frozen water slower than this for half a second sleeps until something changes; 0: never "
        "sleeps");
}

struct ThermalParams {
  bool enabled = false;
  double speedup = 1.0;
  double freezing_c = 0.0;
  double hysteresis_c = 0.2;
  double boiling_c = 100.0;
  double latent_heat_fusion_j_kg = 334e3;
  double latent_heat_vaporisation_j_kg = 2.26e6;
  double ice_specific_heat_j_kgk = 2050.0;
  double water_specific_heat_j_kgk = 4186.0;
  double steam_specific_heat_j_kgk = 2010.0;
  double ice_conductivity_w_mk = 2.22;
  double water_conductivity_w_mk = 0.58;
  double air_heat_transfer_w_m2k = 20.0;
};

template <class Visitor>
void describe(ThermalParams& p, Visitor&& visit) {
  visit("enabled", p.enabled,
        "whether each particle has its own temperature, freezes into rigid ice and melts; false: "
        "one temperature for the whole scene (paper)");
  visit("speedup", p.speedup, Range{0.0, 1e7},
        "seconds of heat transfer per simulated second; makes slow freezing visible");
  visit("freezing_c", p.freezing_c, Range{-100.0, 100.0},
        "temperature at which water freezes and ice melts");
  visit("hysteresis_c", p.hysteresis_c, Range{0.0, 10.0},
        "water becomes rigid this far below freezing_c, and ice breaks up this far above it");
  visit("boiling_c", p.boiling_c, Range{1.0, 900.0},
        "temperature at which water boils; must be above freezing_c");
  visit("latent_heat_fusion_j_kg", p.latent_heat_fusion_j_kg, Range{1.0, 1e8},
        "latent heat of freezing");
  visit("latent_heat_vaporisation_j_kg", p.latent_heat_vaporisation_j_kg, Range{1.0, 1e9},
        "latent heat of boiling");
  visit("ice_specific_heat_j_kgk", p.ice_specific_heat_j_kgk, Range{1.0, 1e6},
        "specific heat of ice");
  visit("water_specific_heat_j_kgk", p.water_specific_heat_j_kgk, Range{1.0, 1e6},
        "specific heat of water");
  visit("steam_specific_heat_j_kgk", p.steam_specific_heat_j_kgk, Range{1.0, 1e6},
        "specific heat of steam");
  visit("ice_conductivity_w_mk", p.ice_conductivity_w_mk, Range{0.0, 1e4},
        "thermal conductivity of ice");
  visit("water_conductivity_w_mk", p.water_conductivity_w_mk, Range{0.0, 1e4},
        "thermal conductivity of water");
  visit("air_heat_transfer_w_m2k", p.air_heat_transfer_w_m2k, Range{0.0, 1e6},
        "heat transfer coefficient between a free surface and the air; 0: insulated");
}

struct IceParams {
  double density_ratio = 0.917;
  double friction = 0.05;
  bool stick_to_cold = true;
  double sleep_speed_m_s = 1e-3;
  double compliance_m_n = 0.0;
  double break_strain = 0.0;
};

template <class Visitor>
void describe(IceParams& p, Visitor&& visit) {
  visit("density_ratio", p.density_ratio, Range{0.5, 2.0},
        "density of ice divided by that of water; below 1, freezing water expands and ice floats");
  visit("friction", p.friction, Range{0.0, 10.0}, "Coulomb friction coefficient of ice on ice");
  visit("stick_to_cold", p.stick_to_cold,
        "whether water that freezes on a wall sticks to it until it melts");
  visit(
      "sleep_speed_m_s", p.sleep_speed_m_s, Range{0.0, 1.0},
      "dry ice slower than this for half a second sleeps until something changes; 0: never sleeps");
  visit(
      "compliance_m_n", p.compliance_m_n, Range{0.0, 1.0},
      "stretch of a spring per newton; 0: rigid ice; above 0: elastic ice (real ice: below 1e-8)");
  visit("break_strain", p.break_strain, Range{0.0, 10.0},
        "relative stretch at which a spring of elastic ice breaks; 0: never breaks");
}

struct SteamParams {
  double rise_speed_m_s = 0.5;
  double drag_1_s = 10.0;
  double heat_transfer_w_m2k = 10.0;
  double condensation_heat_transfer_w_m2k = 5000.0;
};

template <class Visitor>
void describe(SteamParams& p, Visitor&& visit) {
  visit("rise_speed_m_s", p.rise_speed_m_s, Range{0.0, 100.0},
        "mean speed at which steam rises in still air");
  visit("drag_1_s", p.drag_1_s, Range{0.01, 1e4}, "rate at which steam approaches that speed");
  visit("heat_transfer_w_m2k", p.heat_transfer_w_m2k, Range{0.0, 1e6},
        "heat transfer coefficient between a steam particle and the air");
  visit("condensation_heat_transfer_w_m2k", p.condensation_heat_transfer_w_m2k, Range{0.0, 1e6},
        "heat transfer coefficient between steam and a wall it touches");
}

/// From 64 m on, single precision is too coarse for the friction of slow water. Water that falls
/// freely reaches the default solver.max_speed_m_s after 46 m.
struct BoundsParams {
  Vec3d min_m = Vec3d::Constant(-40.0);
  Vec3d max_m = Vec3d::Constant(40.0);
};

template <class Visitor>
void describe(BoundsParams& p, Visitor&& visit) {
  visit("min_m", p.min_m, kCoordinateRange_m, "lower corner");
  visit("max_m", p.max_m, kCoordinateRange_m, "upper corner; must be above min_m on every axis");
}

struct LimitParams {
  double max_particles = 2e6;
};

template <class Visitor>
void describe(LimitParams& p, Visitor&& visit) {
  visit("max_particles", p.max_particles, Range{0.0, 1e8},
        "a scene with more particles is refused before memory is allocated");
}

}  // namespace ice_ice_baby
