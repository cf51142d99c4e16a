#include "loading/solids_check.h"

#include <cmath>
#include <set>

#include "base/item_names.h"
#include "ice_ice_baby/each_collider.h"
#include "ice_ice_baby/errors.h"
#include "solids/solid_mass.h"

namespace ice_ice_baby {

namespace {

/// Lightest and heaviest material, relative to water at rest. Lighter solids would be thrown by
/// small errors of the pressure.
constexpr Range kRelativeDensity{0.1, 20.0};

/// Smallest radius of a ball or a cylinder, inner radius and depth of a cup, and length of any
/// other side, in spacings.
constexpr double kSmallestRadius_d = 1.0, kSmallestCup_d = 2.0, kSmallestSide_d = 1.0;

void requireSolidNames(const Scene& scene) {
  std::set<std::string> taken;
  forEachCollider(scene, [&](const Collider& collider) { taken.insert(collider.name); });
  for (const Gauge& gauge : scene.gauges) taken.insert(gauge.name);
  for (std::size_t k = 0; k < scene.solids.size(); ++k) {
    const std::string& name = scene.solids[k].name;
    if (name.empty()) continue;  // allowed in scenes built in code
    requireFrameName("name of a solid", name);
    if (taken.insert(name).second) continue;
    throw InvalidInput(
        "solids." + std::to_string(k) + ".name = " + shortened(name) +
        " is the name of another solid, of a collider or of a gauge; choose another");
  }
}

void requireLength(const std::string& words, const char* key, double length_m, double spacings,
                   double spacing_m) {
  if (length_m >= spacings * spacing_m * (1 - 1e-9)) return;
  throw InvalidInput(words + ": " + key + " = " + numberText(length_m) +
                     " is too small for particles of fluid.spacing_m = " + numberText(spacing_m) +
                     "; it must be at least " + numberText(spacings * spacing_m) +
                     ", or make fluid.spacing_m smaller");
}

void requireSize(const Solid& solid, const std::string& words, double spacing_m) {
  const auto require = [&](const char* key, double length_m, double spacings) {
    requireLength(words, key, length_m, spacings, spacing_m);
  };
  switch (solid.shape) {
    case SolidShape::kBox:
      return require("the smallest of size_m", solid.size_m.minCoeff(), kSmallestSide_d);
    case SolidShape::kSphere:
      return require("radius_m", solid.radius_m, kSmallestRadius_d);
    case SolidShape::kCylinder:
      require("radius_m", solid.radius_m, kSmallestRadius_d);
      return require("height_m", solid.height_m, kSmallestSide_d);
    case SolidShape::kCup:
      require("radius_m", solid.radius_m, kSmallestCup_d);
      return require("height_m", solid.height_m, kSmallestCup_d);
  }
}

/// Six digits.
std::string roundedText(double value) {
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - 5);
  return numberText(std::round(value / unit) * unit);
}

void requireDensity(const Scene& scene, const Solid& solid, const std::string& words) {
  const double water_kg_m3 = scene.fluid.rest_density_kg_m3;
  const SolidMass mass = massOf(solid);
  const double low = kRelativeDensity.min * water_kg_m3, high = kRelativeDensity.max * water_kg_m3;
  const double density_kg_m3 = mass.mass_kg / mass.volume_m3;
  if (density_kg_m3 >= low && density_kg_m3 <= high) return;
  const std::string given = solid.mass_kg > 0.0
                                ? "mass_kg = " + numberText(solid.mass_kg) + " is a density of " +
                                      roundedText(density_kg_m3) + " kg/m3,"
                                : "density_kg_m3 = " + numberText(density_kg_m3);
  throw InvalidInput(words + ": " + given + " outside the allowed range [" + numberText(low) +
                     ", " + numberText(high) + "], 0.1 to 20 times that of the water");
}

void requireWithin(const BoundsParams& bounds, const Solid& solid, const std::string& words) {
  const Vec3d centre_m = solid.pose().toWorld(massOf(solid).centre_m);
  for (int axis = 0; axis < 3; ++axis) {
    requireInRange(words + ": position_m puts its centre of mass outside bounds: " + "xyz"[axis],
                   centre_m[axis], bounds.min_m[axis], bounds.max_m[axis]);
  }
}

}  // namespace

void requireSolids(const Scene& scene) {
  if (scene.solids.size() > kMaxSolids) {
    throw InvalidInput("solids has " + std::to_string(scene.solids.size()) + " entries; at most " +
                       std::to_string(kMaxSolids) + " are allowed");
  }
  requireSolidNames(scene);
  for (std::size_t k = 0; k < scene.solids.size(); ++k) {
    const Solid& solid = scene.solids[k];
    const std::string words = wordsFor("solids", k, solid);
    requireSize(solid, words, scene.fluid.spacing_m);
    requireDensity(scene, solid, words);
    requireWithin(scene.bounds, solid, words);
    requireInRange(words + ": speed of velocity_m_s, up to solver.max_speed_m_s,",
                   solid.velocity_m_s.norm(), 0.0, scene.solver.max_speed_m_s);
  }
}

}  // namespace ice_ice_baby
