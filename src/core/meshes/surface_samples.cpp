#include "meshes/surface_samples.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/parallel.h"

namespace ice_ice_baby {

namespace {

/// Longest side of the pieces of triangles that a sample stands for, in spacings. Opacity is
/// measured for the coarse ones.
constexpr double kCoarse_d = 0.5, kFine_d = 0.25;

/// A wall with a thickness between these, in spacings, is partly thin. Particles on both sides of a
/// thicker one are out of reach of each other.
constexpr double kThin_d = 0.75, kThick_d = 1.0;

/// A wall is fully opaque this far from its rim, in spacings.
constexpr double kRim_d = 0.5;
constexpr int kRimSteps = 4, kRimWays = 8;

double smoothStep(double x) {
  const double t = std::clamp(x, 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

/// Halves a triangle across its longest side until it is small, and calls visit for every piece.
template <class Visit>
void divide(const Triangle& t, double side_m, const Visit& visit) {
  const std::array<Vec3d, 3> corners{t.a, t.b, t.c};
  std::size_t longest = 0;
  double longest2 = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double length2 = (corners[(k + 1) % 3] - corners[k]).squaredNorm();
    if (length2 <= longest2) continue;
    longest = k;
    longest2 = length2;
  }
  if (longest2 <= side_m * side_m) {
    visit(t);
    return;
  }
  const Vec3d &a = corners[longest], &b = corners[(longest + 1) % 3],
              &c = corners[(longest + 2) % 3];
  const Vec3d middle = (a + b) / 2;
  divide({a, middle, c}, side_m, visit);
  divide({middle, b, c}, side_m, visit);
}

/// Whether a wall goes on in every direction, so far from a sample: where a ray from above meets
/// it, or where it turns upwards.
bool goesOn(const SurfaceTree& tree, const SurfaceSample& sample, double away_m, double lift_m) {
  const Vec3d& n = sample.normal;
  const Vec3d u = n.unitOrthogonal(), v = n.cross(u);
  const Vec3d above = sample.point + lift_m * n;
  for (int k = 0; k < kRimWays; ++k) {
    const double angle = 2 * M_PI * k / kRimWays;
    const Vec3d way = std::cos(angle) * u + std::sin(angle) * v;
    if (tree.firstHit(above, way, 0.0, away_m) <= away_m) continue;
    if (tree.firstHit(above + away_m * way, -n, 0.0, 3 * lift_m) > 3 * lift_m) return false;
  }
  return true;
}

/// Distance along the surface from a sample to the nearest place where the wall ends, as a share of
/// kRim_d.
double distanceToRim(const SurfaceTree& tree, const SurfaceSample& sample, double spacing_m) {
  const double far = kRim_d * spacing_m, lift = spacing_m / 4;
  if (goesOn(tree, sample, far, lift)) return 1.0;
  for (int step = 1; step < kRimSteps; ++step) {
    if (!goesOn(tree, sample, far * step / kRimSteps, lift)) return double(step - 1) / kRimSteps;
  }
  return double(kRimSteps - 1) / kRimSteps;
}

void measure(const Surface& surface, double spacing_m, SurfaceSample& sample) {
  const SurfaceTree& tree = surface.tree();
  const double skip = 1e-6 * spacing_m, reach = kThick_d * spacing_m;
  const double behind = tree.firstHit(sample.point, -sample.normal, skip, reach);
  if (surface.topology().closed()) {
    const double thickness = behind / spacing_m;
    const double thin = 1 - smoothStep((thickness - kThin_d) / (kThick_d - kThin_d));
    if (thin > 0) sample.opacity = thin * smoothStep(distanceToRim(tree, sample, spacing_m));
    return;
  }
  sample.covered_behind = behind <= reach;
  sample.covered_ahead = tree.firstHit(sample.point, sample.normal, skip, reach) <= reach;
  sample.opacity = smoothStep(distanceToRim(tree, sample, spacing_m));
}

}  // namespace

SurfaceSamples samplesOf(const Surface& surface, double spacing_m) {
  const SurfaceTree& tree = surface.tree();
  const double facing = surface.topology().volume_m3 < 0 ? -1.0 : 1.0;
  std::vector<Triangle> pieces;
  SurfaceSamples samples;
  for (Index k = 0; k < tree.count(); ++k) {
    divide(tree.triangle(k), kCoarse_d * spacing_m, [&](const Triangle& piece) {
      pieces.push_back(piece);
      samples.coarse.push_back(
          {piece.centre(), facing * piece.normal().normalized(), piece.area(), 0.0, false, false});
    });
  }
  parallelFor(pieces.size(),
              [&](std::size_t k) { measure(surface, spacing_m, samples.coarse[k]); });
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    divide(pieces[k], kFine_d * spacing_m, [&](const Triangle& piece) {
      SurfaceSample& sample = samples.fine.emplace_back(samples.coarse[k]);
      sample.point = piece.centre();
      sample.area_m2 = piece.area();
    });
  }
  return samples;
}

}  // namespace ice_ice_baby
