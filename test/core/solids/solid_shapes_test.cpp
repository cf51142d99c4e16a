// Mass properties and particles of the shapes of floating solids.
#include <gtest/gtest.h>

#include <cmath>

#include "fixtures.h"
#include "particles/kernels.h"
#include "solids/solid_mass.h"
#include "solids/solid_points.h"
#include "solids/solid_volumes.h"

namespace ice_ice_baby {
namespace solid_shapes_test {

Solid solidOf(SolidShape shape) {
  Solid solid;
  solid.shape = shape;
  solid.size_m = {0.3, 0.2, 0.12};
  solid.radius_m = 0.1;
  solid.height_m = 0.17;
  solid.wall_m = 0.03;
  solid.density_kg_m3 = 700.0;
  return solid;
}

constexpr SolidShape kShapes[] = {SolidShape::kBox, SolidShape::kSphere, SolidShape::kCylinder,
                                  SolidShape::kCup};

bool inCylinder(const Vec3d& point, double radius_m, double low_m, double high_m) {
  return point.head<2>().norm() <= radius_m && point.z() >= low_m && point.z() <= high_m;
}

bool inMaterial(const Solid& solid, const Vec3d& point) {
  const double r = solid.radius_m, h = solid.height_m, wall = solid.wall_m;
  switch (solid.shape) {
    case SolidShape::kBox:
      return ((2 * point).cwiseAbs() - solid.size_m).maxCoeff() <= 0;
    case SolidShape::kSphere:
      return point.norm() <= r;
    case SolidShape::kCylinder:
      return inCylinder(point, r, -h / 2, h / 2);
    case SolidShape::kCup:
      return inCylinder(point, r + wall, -wall, h) && !inCylinder(point, r, 0, 2 * h);
  }
  return false;
}

/// The same as massOf, summed over small cells.
SolidMass summed(const Solid& solid, double cell_m) {
  SolidMass sum;
  std::vector<Vec3d> cells;
  const int n = int(std::ceil(0.3 / cell_m));
  for (int x = -n; x < n; ++x) {
    for (int y = -n; y < n; ++y) {
      for (int z = -n; z < n; ++z) {
        const Vec3d point = cell_m * Vec3d(x + 0.5, y + 0.5, z + 0.5);
        if (inMaterial(solid, point)) cells.push_back(point);
      }
    }
  }
  for (const Vec3d& point : cells) sum.centre_m += point / double(cells.size());
  sum.volume_m3 = double(cells.size()) * std::pow(cell_m, 3);
  sum.mass_kg = solid.density_kg_m3 * sum.volume_m3;
  for (const Vec3d& point : cells) {
    const Vec3d arm = point - sum.centre_m;
    sum.inertia += sum.mass_kg / double(cells.size()) *
                   (arm.squaredNorm() * Mat3<double>::Identity() - arm * arm.transpose());
  }
  return sum;
}

TEST(SolidShapes, MassCentreAndInertiaAreThoseOfTheShape) {
  for (const SolidShape shape : kShapes) {
    const Solid solid = solidOf(shape);
    const SolidMass mass = massOf(solid), expected = summed(solid, 0.005);
    const std::string name = choices(shape)[std::size_t(shape)];
    EXPECT_NEAR(mass.volume_m3 / expected.volume_m3, 1.0, 0.01) << name;
    EXPECT_NEAR(mass.mass_kg / expected.mass_kg, 1.0, 0.01) << name;
    EXPECT_NEAR((mass.centre_m - expected.centre_m).norm(), 0.0, 5e-4) << name;
    EXPECT_NEAR((mass.inertia - expected.inertia).norm() / expected.inertia.norm(), 0.0, 0.01)
        << name;
  }
}

TEST(SolidShapes, AGivenMassReplacesTheDensity) {
  Solid solid = solidOf(SolidShape::kCup);
  const SolidMass by_density = massOf(solid);
  solid.mass_kg = 2.5;
  const SolidMass by_mass = massOf(solid);
  EXPECT_DOUBLE_EQ(by_mass.mass_kg, 2.5);
  EXPECT_NEAR(by_mass.inertia(0, 0) / by_density.inertia(0, 0), 2.5 / by_density.mass_kg, 1e-12);
}

/// Over half a decade of spacings. About half a spacing below the surface is where the centres of
/// water lie at a wall, on the other side.
TEST(SolidShapes, ParticlesFillTheShapeUpToHalfALayerBelowItsSurface) {
  for (const SolidShape shape : kShapes) {
    for (const double spacing_m : {0.03, 0.02, 0.01, 0.006}) {
      const Solid solid = solidOf(shape);
      const std::string what =
          choices(shape)[std::size_t(shape)] + " at " + std::to_string(spacing_m);
      std::size_t count = 0;
      Vec3d sum = Vec3d::Zero();
      Eigen::AlignedBox3d bounds, inner;
      forEachSolidPoint(solid, spacing_m, [&](const Vec3d& point) {
        ++count;
        sum += point;
        bounds.extend(point);
        EXPECT_TRUE(inMaterial(solid, point)) << what;
      });
      const SolidMass mass = massOf(solid);
      const double each = mass.volume_m3 / double(count) / std::pow(spacing_m, 3);
      EXPECT_NEAR(each, 1.0, spacing_m > 0.015 ? 0.3 : 0.15) << what;
      EXPECT_NEAR((sum / double(count) - mass.centre_m).norm(), 0.0, 0.15 * spacing_m) << what;
      EXPECT_EQ(solidCount(solid, spacing_m, 1e6), double(count)) << what;
      const double low_m = shape == SolidShape::kBox      ? -0.06
                           : shape == SolidShape::kSphere ? -0.1
                           : shape == SolidShape::kCup    ? -0.03
                                                          : -0.085;
      const bool thick = spacing_m < 0.025;
      EXPECT_NEAR(bounds.min().z(), low_m + spacing_m / 2, (thick ? 0.15 : 0.25) * spacing_m)
          << what;
    }
  }
}

TEST(SolidShapes, AThinWallOfACupCountsAsOneSpacingInwards) {
  Solid solid = solidOf(SolidShape::kCup);
  solid.wall_m = 0.004;
  const double spacing_m = 0.01;
  Eigen::AlignedBox3d bounds;
  double innermost_m = 1.0;
  forEachSolidPoint(solid, spacing_m, [&](const Vec3d& point) {
    bounds.extend(point);
    if (point.z() > 0.02) innermost_m = std::min(innermost_m, point.head<2>().norm());
  });
  EXPECT_NEAR(bounds.min().z(), -0.004 + 0.005, 1e-12);
  EXPECT_NEAR(bounds.max().z(), 0.17 - 0.005, 2e-4) << "16.4 spacings are 16 layers";
  EXPECT_NEAR(innermost_m, 0.104 - 0.005, 1e-12);
  const double thick_m3 = M_PI * (0.104 * 0.104 * 0.174 - 0.094 * 0.094 * 0.164);
  EXPECT_NEAR(filledVolume_m3(solid, spacing_m), thick_m3, 1e-12);
}

/// Otherwise the solid would press on the water beside it for ever.
TEST(SolidShapes, NoSolidIsDenserThanWaterAtRestByItself) {
  Scene scene;
  scene.fluid.spacing_m = 0.02;
  const CubicSpline<double> kernel(scene.supportRadius_m());
  const double rest = latticeSum(kernel, 0.02, true);
  for (const SolidShape shape : kShapes) {
    const Solid solid = solidOf(shape);
    const std::vector<double> volumes = solidVolumes(scene, solid);
    std::vector<Vec3d> points;
    forEachSolidPoint(solid, 0.02, [&](const Vec3d& point) { points.push_back(point); });
    double sum = 0.0, densest = 0.0;
    for (std::size_t a = 0; a < points.size(); ++a) {
      double density = 0.0;
      for (std::size_t b = 0; b < points.size(); ++b) {
        density += volumes[b] * kernel.w((points[a] - points[b]).norm()) / rest;
      }
      sum += volumes[a];
      densest = std::max(densest, density);
    }
    const std::string name = choices(shape)[std::size_t(shape)];
    EXPECT_LT(densest, 1.01) << name;
    EXPECT_NEAR(sum * 0.02 * 0.02 * 0.02 / massOf(solid).volume_m3, 1.0, 1e-9) << name;
  }
}

}  // namespace solid_shapes_test
}  // namespace ice_ice_baby
