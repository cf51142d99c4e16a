// Validates scenes, whether read from a file or built in code.
#include <cmath>
#include <set>
#include <type_traits>

#include "base/item_names.h"
#include "ice_ice_baby/each_collider.h"
#include "ice_ice_baby/errors.h"
#include "ice_ice_baby/scene_keys.h"
#include "loading/bounds_check.h"
#include "loading/cameras_check.h"
#include "loading/flow_check.h"
#include "loading/gauges_check.h"
#include "loading/heat_regions_check.h"
#include "loading/solids_check.h"
#include "particles/kernels.h"
#include "scene/lattice.h"
#include "spawn/spawn_check.h"

namespace ice_ice_baby {

namespace {

/// Limit on solver sweeps per frame, because a run can only be stopped between frames.
constexpr int kMaxSweeps = 10000;

/// Visitor of describe(): checks every number and text against its range, for scenes built in code.
class RangeCheck {
 public:
  explicit RangeCheck(std::string path) : path_(std::move(path)) {}

  template <class Number>
  void operator()(const char* name, Number& value, Range range, const char*) const {
    if constexpr (std::is_base_of_v<Eigen::MatrixBase<Number>, Number>) {
      for (Eigen::Index k = 0; k < value.size(); ++k) {
        requireInRange(path_ + name, value(k), range.min, range.max);
      }
    } else {
      requireInRange(path_ + name, value, range.min, range.max);
    }
  }
  void operator()(const char* name, std::string& value, const char*) const {
    requireText(path_ + name, value);
  }
  template <class Other>
  void operator()(const char*, Other&, const char*) const {}
  template <class Params>
  void section(const char* name, Params& params, const char*) const {
    describe(params, RangeCheck(path_ + name + "."));
  }
  template <class Item>
  void list(const char* name, std::vector<Item>& items, const char*) const {
    for (std::size_t k = 0; k < items.size(); ++k) {
      describe(items[k], RangeCheck(path_ + name + "." + std::to_string(k) + "."));
    }
  }

 private:
  std::string path_;
};

void requireFluid(const Scene& scene) {
  const double h = scene.supportRadius_m();
  const FluidParams& fluid = scene.fluid;
  if (fluid.particle_mass_kg == 0.0 || !fluid.self_density) return;
  const double lone_density = fluid.particle_mass_kg * densityAtZero(fluid.kernel, h);
  if (lone_density < fluid.rest_density_kg_m3) return;
  throw InvalidInput(
      "these constants cannot be a fluid: a lone particle already has density " +
      numberText(lone_density) + " kg/m3 (mass " + numberText(fluid.particle_mass_kg) +
      " kg x W(0) at h = " + numberText(h) +
      " m), at or above fluid.rest_density_kg_m3 = " + numberText(fluid.rest_density_kg_m3) +
      ", so every particle would be pushed for ever. Set fluid.particle_mass_kg to 0 (sampled from "
      "the "
      "lattice), raise fluid.rest_density_kg_m3, or set fluid.self_density to false as the paper "
      "does");
}

/// The paper's rest density is 45 times that of water, so heat would flow 45 times too slowly.
void requireThermal(const Scene& scene) {
  const ThermalParams& thermal = scene.thermal;
  if (!(thermal.freezing_c < thermal.boiling_c)) {
    throw InvalidInput("thermal.freezing_c = " + numberText(thermal.freezing_c) +
                       " must be below thermal.boiling_c = " + numberText(thermal.boiling_c));
  }
  if (thermal.enabled && scene.preset == Preset::kPaper) {
    throw InvalidInput(
        "preset = paper: the paper has one temperature for the whole scene; with thermal.enabled "
        "set "
        "preset to default, or thermal.enabled to false");
  }
}

void requireColliderNames(const Scene& scene) {
  if (scene.name.find('\n') != std::string::npos) {
    throw InvalidInput("name = " + shortened(scene.name) + " must be one line");
  }
  std::set<std::string> taken;
  forEachCollider(scene, [&](const Collider& collider) {
    if (collider.name.empty()) return;  // allowed in scenes built in code
    requireFrameName("name of a collider", collider.name);
    requireFollowFrame(collider, "collider");
    if (!taken.insert(collider.name).second) {
      throw InvalidInput("two colliders are called " + collider.name + "; give each its own name");
    }
  });
}

void requireSweeps(const Scene& scene) {
  const int sweeps = scene.substeps() * scene.solver.iterations;
  if (sweeps <= kMaxSweeps) return;
  throw InvalidInput("solver.substeps x solver.iterations = " + std::to_string(sweeps) +
                     " sweeps a frame is outside the allowed range [0, " +
                     std::to_string(kMaxSweeps) + "]; lower one of them");
}

void requireOneGoal(const Scene& scene) {
  if (scene.solver.budget == 0.0 || scene.solver.target_error == 0.0) return;
  throw InvalidInput("solver.budget = " + numberText(scene.solver.budget) +
                     " and solver.target_error = " + numberText(scene.solver.target_error) +
                     " ask for different numbers of substeps; set one of them to 0");
}

void requireBlock(const Scene& scene, const Block& block, const std::string& name) {
  if (!block.frame.empty()) {
    throw InvalidInput(name + ".frame = " + shortened(block.frame) +
                       " is not placed yet; call completeScene");
  }
  if (block.sheet && block.shape != BlockShape::kBox) {
    throw InvalidInput(name +
                       ": a sheet is a box one particle thick; set shape to box, or sheet "
                       "to false");
  }
  if (block.sheet && scene.thermal.enabled) {
    throw InvalidInput(name +
                       ": a sheet cannot be in a scene with thermal.enabled, as it neither "
                       "freezes nor melts; set one of them to false");
  }
  const double spacing = scene.spacing_m(block);
  if (latticeCount(block, spacing, scene.limits.max_particles) > 0) return;
  throw InvalidInput(name + " holds no particle: max_m must exceed min_m by at least " +
                     numberText(spacing) +
                     " m along every axis, the spacing that follows from fluid.spacing_m");
}

/// Checks the total first, because it is cheap to compute for any number of blocks.
void requireBlocks(const Scene& scene) {
  const std::int64_t count = particleCount(scene);
  if (static_cast<double>(count) > scene.limits.max_particles) {
    throw InvalidInput((scene.solids.empty() ? "the blocks hold " : "the blocks and solids hold ") +
                       std::to_string(count) + " particles, more than limits.max_particles = " +
                       numberText(scene.limits.max_particles) +
                       "; enlarge fluid.spacing_m or raise the limit");
  }
  for (std::size_t k = 0; k < scene.blocks.size(); ++k) {
    requireBlock(scene, scene.blocks[k], "blocks." + std::to_string(k));
  }
}

}  // namespace

void validate(const Scene& scene) {
  Scene described = scene;
  describe(described, RangeCheck(""));
  const double d = scene.fluid.spacing_m;
  requireInRange("fluid.support_radius_m / fluid.spacing_m", scene.supportRadius_m() / d, 1.05,
                 4.0);
  if (!(scene.temperature.freezing_c < scene.temperature.onset_c)) {
    throw InvalidInput(
        "temperature.freezing_c = " + numberText(scene.temperature.freezing_c) +
        " must be below temperature.onset_c = " + numberText(scene.temperature.onset_c));
  }
  requireThermal(scene);
  requireColliderNames(scene);
  requireGauges(scene);
  requireSweeps(scene);
  requireOneGoal(scene);
  requireSolids(scene);
  requireBlocks(scene);
  requireBounds(scene);
  requireFlow(scene);
  requireHeatRegions(scene);
  requireCameras(scene);
  requireFluid(scene);
  requireFreeSpawn(scene);
}

}  // namespace ice_ice_baby
