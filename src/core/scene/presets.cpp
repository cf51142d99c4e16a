// The constants of the paper, as a preset.
#include "ice_ice_baby/scene.h"

namespace ice_ice_baby {

namespace {

constexpr double kPaperSupportRadius_m = 0.03;
constexpr double kPaperSpacing_m = 0.0211;
constexpr double kPaperEpsilon_1_m2 = 0.1;

}  // namespace

void applyPreset(Scene& scene, Preset preset, double spacing_m) {
  scene.preset = preset;
  if (preset == Preset::kDefault) return;
  const double scale = spacing_m / kPaperSpacing_m;
  FluidParams& fluid = scene.fluid;
  fluid.support_radius_m = kPaperSupportRadius_m * scale;
  fluid.rest_density_kg_m3 = 45000.0;
  fluid.particle_mass_kg = scale * scale * scale;
  fluid.kernel = KernelPair::kPoly6Spiky;
  fluid.self_density = false;
  fluid.boundary_density = false;
  SolverParams& solver = scene.solver;
  solver.target_error = 0.0;
  solver.budget = 0.0;
  solver.substeps = 8;
  solver.iterations = 4;
  solver.relaxation = 1.0;
  solver.epsilon = kPaperEpsilon_1_m2 * kPaperSupportRadius_m * kPaperSupportRadius_m;
  solver.warm_start = 0.0;
  solver.resist_tension = false;
  solver.coarse_level = false;
  solver.viscosity_1_s = 0.0;
  solver.max_correction_h = 0.0;
  SpringParams& springs = scene.springs;
  springs.reach_h = 1.0;
  springs.keep_frozen = false;
  springs.correct_updated = false;
  springs.stick_to_colliders = false;
  springs.sleep_speed_m_s = 0.0;
}

}  // namespace ice_ice_baby
