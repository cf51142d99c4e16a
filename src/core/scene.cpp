#include "ice_ice_baby/scene.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <type_traits>

#include "ice_ice_baby/each_collider.h"
#include "ice_ice_baby/errors.h"
#include "ice_ice_baby/kernels.h"
#include "ice_ice_baby/scene_keys.h"
#include "ice_ice_baby/spawn_check.h"

namespace ice_ice_baby {

namespace {

/// Sweeps of the solver within a frame at most: between two frames alone can it be stopped.
constexpr int kMaxSweeps = 10000;

constexpr double kPaperSupportRadius_m = 0.03;
constexpr double kPaperSpacing_m = 0.0211;
constexpr double kPaperEpsilon_1_m2 = 0.1;

/// Visitor of describe(): holds every number and text to its range, for scenes that no file was
/// read for.
class RangeCheck {
 public:
  explicit RangeCheck(std::string path) : path_(std::move(path)) {}

  template <class Number>
  void operator()(const char* name, Number& value, Range range, const char*) const {
    if constexpr (std::is_base_of_v<Eigen::MatrixBase<Number>, Number>) {
      for (const double part : value.reshaped()) {
        requireInRange(path_ + name, part, range.min, range.max);
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

}  // namespace

Posed poseOf(const Vec3d& position_m, const Vec3d& rpy_deg) {
  const Vec3d rpy = rpy_deg * (M_PI / 180.0);
  Posed pose;
  pose.position = position_m;
  pose.rotation =
      (Eigen::AngleAxisd(rpy.z(), Vec3d::UnitZ()) * Eigen::AngleAxisd(rpy.y(), Vec3d::UnitY()) *
       Eigen::AngleAxisd(rpy.x(), Vec3d::UnitX()))
          .toRotationMatrix();
  return pose;
}

double Scene::supportRadius_m() const {
  return fluid.support_radius_m > 0.0 ? fluid.support_radius_m : 2.0 * fluid.spacing_m;
}

bool Scene::startsFrozen(const Block& block) const {
  return heat.enabled && !block.sheet && block.celsius < heat.freezing_c;
}

double Scene::spacing_m(const Block& block) const {
  return startsFrozen(block) ? fluid.spacing_m / std::cbrt(ice.density_ratio) : fluid.spacing_m;
}

int Scene::substeps() const {
  if (solver.substeps > 0) return solver.substeps;
  switch (solver.quality) {
    case Quality::kFast:
      return 4;
    case Quality::kBalanced:
      return 6;
    case Quality::kAccurate:
      return 12;
  }
  return 6;
}

double Scene::relaxation() const {
  if (solver.relaxation > 0.0) return solver.relaxation;
  // After n sweeps (1 - a)^n of a mode's error is left. With the warm start the velocity made of it
  // dies out above -1/5, which an even power never falls below.
  constexpr double kLargestEigenvalue = 2.86;
  const int n = solver.iterations;
  const double a = n % 2 == 0 ? 2.0 : 1.0 + std::pow(0.2, 1.0 / n);
  return a / kLargestEigenvalue;
}

Eigen::Array<std::int64_t, 3, 1> latticeSize(const Block& block, double spacing_m) {
  const Eigen::Array3d extent = (block.max_m - block.min_m).array() / spacing_m;
  Eigen::Array<std::int64_t, 3, 1> size = (extent + 1e-6).floor().max(0.0).cast<std::int64_t>();
  if (block.sheet) {
    Eigen::Index thinnest = 0;
    extent.minCoeff(&thinnest);
    size[thinnest] = 1;
  }
  return size;
}

LatticeRow latticeRow(const Block& block, double spacing_m,
                      const Eigen::Array<std::int64_t, 3, 1>& size, std::int64_t y,
                      std::int64_t z) {
  if (block.shape == BlockShape::kBox) return {0, size.x()};
  // From the centre, in half widths of the box: there the shape has radius 1.
  const Eigen::Array3d half = (block.max_m - block.min_m).array() / 2;
  const double across = (double(y) + 0.5) * spacing_m / half.y() - 1;
  const double up = (double(z) + 0.5) * spacing_m / half.z() - 1;
  const bool ball = block.shape == BlockShape::kBall;
  const double rest2 = 1 - across * across - (ball ? up * up : 0.0);
  constexpr double kRim = 1e-6;  // a point on the rim is inside, as latticeSize forgives rounding
  if (rest2 < -kRim) return {};
  const double middle = half.x() / spacing_m - 0.5;
  const double reach = std::sqrt(std::max(rest2, 0.0)) * half.x() / spacing_m + kRim;
  LatticeRow row;
  row.first = std::max(static_cast<std::int64_t>(std::ceil(middle - reach)), std::int64_t(0));
  row.last = std::min(static_cast<std::int64_t>(std::floor(middle + reach)) + 1, size.x());
  row.last = std::max(row.first, row.last);
  return row;
}

namespace {

/// As a floating point number, which no scene overflows. The box in place of a shape in it that
/// holds more than `most` anyway: a row of points costs time, and a shape fills half of its box.
double particleCount(const Block& block, double spacing_m, double most) {
  const auto size = latticeSize(block, spacing_m);
  const double whole = size.cast<double>().prod();
  if (block.shape == BlockShape::kBox || whole > 4 * most) return whole;
  double count = 0.0;
  for (std::int64_t z = 0; z < size.z(); ++z) {
    for (std::int64_t y = 0; y < size.y(); ++y) {
      const LatticeRow row = latticeRow(block, spacing_m, size, y, z);
      count += double(row.last - row.first);
    }
  }
  return count;
}

}  // namespace

std::int64_t particleCount(const Scene& scene) {
  const double most = scene.limits.max_particles;
  double count = 0.0;
  for (const Block& block : scene.blocks) {
    count += particleCount(block, scene.spacing_m(block), std::max(0.0, most - count));
  }
  return static_cast<std::int64_t>(std::min(count, 9e18));
}

namespace {

/// The paper's rest density, 45 times that of water, would make heat flow 45 times too slowly.
void requireHeat(const Scene& scene) {
  const HeatParams& heat = scene.heat;
  if (!(heat.freezing_c < heat.boiling_c)) {
    throw InvalidInput("heat.freezing_c = " + numberText(heat.freezing_c) +
                       " must be below heat.boiling_c = " + numberText(heat.boiling_c));
  }
  if (heat.enabled && scene.preset == Preset::kPaper) {
    throw InvalidInput(
        "preset = paper: the paper has one temperature for the whole scene; with heat.enabled set "
        "preset to default, or heat.enabled to false");
  }
}

}  // namespace

namespace {

void requireNames(const Scene& scene) {
  if (scene.name.find('\n') != std::string::npos) {
    throw InvalidInput("name = " + shortened(scene.name) + " must be one line");
  }
  std::set<std::string> taken;
  forEachCollider(scene, [&](const Collider& collider) {
    if (collider.name.empty()) return;  // of a scene made in code, which names what it moves
    requireFrameName("name of a collider", collider.name);
    if (!collider.follow_frame.empty()) {
      requireFrameName("follow_frame of collider " + collider.name, collider.follow_frame);
    }
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

void requireBlock(const Scene& scene, const Block& block, const std::string& name) {
  if (block.sheet && block.shape != BlockShape::kBox) {
    throw InvalidInput(name +
                       ": a sheet is a box one particle thick; set shape to box, or sheet "
                       "to false");
  }
  if (block.sheet && scene.heat.enabled) {
    throw InvalidInput(name +
                       ": a sheet cannot be in a scene with heat.enabled, as it neither "
                       "freezes nor melts; set one of them to false");
  }
  const double spacing = scene.spacing_m(block);
  if (particleCount(block, spacing, scene.limits.max_particles) > 0) return;
  throw InvalidInput(name + " holds no particle: max_m must exceed min_m by at least " +
                     numberText(spacing) +
                     " m along every axis, the spacing that follows from fluid.spacing_m");
}

/// The total first: it is found at little cost however many blocks there are.
void requireBlocks(const Scene& scene) {
  const std::int64_t count = particleCount(scene);
  if (static_cast<double>(count) > scene.limits.max_particles) {
    throw InvalidInput(
        "the blocks hold " + std::to_string(count) +
        " particles, more than limits.max_particles = " + numberText(scene.limits.max_particles) +
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
  requireHeat(scene);
  requireNames(scene);
  requireSweeps(scene);
  requireBlocks(scene);
  requireFluid(scene);
  requireFreeSpawn(scene);
}

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
  fluid.wall_density = false;
  SolverParams& solver = scene.solver;
  solver.target_error = 0.0;
  solver.substeps = 8;
  solver.iterations = 4;
  solver.relaxation = 1.0;
  solver.epsilon = kPaperEpsilon_1_m2 * kPaperSupportRadius_m * kPaperSupportRadius_m;
  solver.warm_start = 0.0;
  solver.resist_tension = false;
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
