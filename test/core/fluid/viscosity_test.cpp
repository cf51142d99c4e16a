#include "fluid/viscosity.h"

#include <gtest/gtest.h>

#include "fixtures.h"

namespace ice_ice_baby {
namespace viscosity_test {

using test::Cloud;

template <class Real>
Cloud<Real> movingCloud(const std::vector<Vec3d>& points) {
  Cloud<Real> cloud(points, 0.1, 0.01);
  test::Random random(71);
  for (std::size_t i = 0; i < points.size(); ++i) {
    cloud.particles.velocity.set(i, random.direction().cast<Real>());
  }
  return cloud;
}

Scene viscousScene(double rate_1_s) {
  Scene scene;
  scene.fluid.spacing_m = 0.05;
  scene.solver.viscosity_1_s = rate_1_s;
  return scene;
}

double sumOfSquares(const Cloud<double>& cloud) {
  double sum = 0;
  for (std::size_t i = 0; i < cloud.particles.size(); ++i) {
    sum += cloud.particles.velocity.at(i).squaredNorm();
  }
  return sum;
}

double volumeOf(const Scene& scene) {
  return particleMass_kg(scene.fluid, 0.1) / scene.fluid.rest_density_kg_m3;
}

template <class Real>
class ViscosityTest : public testing::Test {};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(ViscosityTest, Reals);

TYPED_TEST(ViscosityTest, IsTheSumOverEveryPair) {
  const double rate = 20, dt = 0.004;
  auto cloud =
      movingCloud<TypeParam>(test::randomPoints(253, Vec3d::Zero(), Vec3d::Constant(0.3), 72));
  const Particles<TypeParam> before = cloud.particles;
  const Scene scene = viscousScene(rate);
  Viscosity<TypeParam> viscosity(scene, volumeOf(scene));
  PackedXyzw<TypeParam> rows;
  viscosity.apply(cloud.particles, cloud.neighbours, dt, rows);
  const CubicSpline<double> kernel(0.1);
  for (std::size_t i = 0; i < before.size(); ++i) {
    Vec3d v = before.velocity.at(i).template cast<double>();
    for (std::size_t j = 0; j < before.size(); ++j) {
      const double r = (before.predicted.at(i) - before.predicted.at(j)).norm();
      v += (1 - std::exp(-rate * dt)) * volumeOf(scene) * kernel.w(r) *
           (before.velocity.at(j) - before.velocity.at(i)).template cast<double>();
    }
    EXPECT_LT((cloud.particles.velocity.at(i).template cast<double>() - v).norm(),
              sizeof(TypeParam) == 8 ? 1e-12 : 1e-4);
  }
}

TEST(ViscosityConservation, KeepsMomentumAndTakesEnergy) {
  auto cloud =
      movingCloud<double>(test::randomPoints(800, Vec3d::Zero(), Vec3d::Constant(0.45), 73));
  const Scene scene = viscousScene(30);
  Viscosity<double> viscosity(scene, volumeOf(scene));
  PackedXyzw<double> rows;
  const Vec3d momentum = test::sumOf(cloud.particles.velocity);
  const double before = sumOfSquares(cloud);
  viscosity.apply(cloud.particles, cloud.neighbours, 0.002, rows);
  EXPECT_LT((test::sumOf(cloud.particles.velocity) - momentum).norm(), 1e-12 * 800);
  EXPECT_LT(sumOfSquares(cloud), before);
}

/// Water more than ten times as dense as at rest, at the largest viscosity of a scene.
class CrowdedViscosity : public testing::Test {
 protected:
  /// Relative density of the densest place.
  double densest() const {
    const CubicSpline<double> kernel(scene_.supportRadius_m());
    double largest = 0;
    for (const Vec3d& x : points_) {
      double density = 0;
      for (const Vec3d& y : points_) density += volumeOf(scene_) * kernel.w((x - y).norm());
      largest = std::max(largest, density);
    }
    return largest;
  }
  /// Smallest and largest velocity along each axis.
  std::pair<Vec3d, Vec3d> velocityRange() const {
    Vec3d low = cloud_.particles.velocity.at(0), high = low;
    for (std::size_t i = 1; i < points_.size(); ++i) {
      low = low.cwiseMin(cloud_.particles.velocity.at(i));
      high = high.cwiseMax(cloud_.particles.velocity.at(i));
    }
    return {low, high};
  }

  const Scene scene_ = viscousScene(1e4);
  const std::vector<Vec3d> points_ =
      test::randomPoints(800, Vec3d::Zero(), Vec3d::Constant(0.15), 73);
  Cloud<double> cloud_ = movingCloud<double>(points_);
  PackedXyzw<double> rows_;
};

TEST_F(CrowdedViscosity, KeepsMomentumAndTakesEnergyAndNoVelocityLeavesTheRangeOfAll) {
  const double density = densest();
  ASSERT_GT(density, 10.0);
  Viscosity<double> viscosity(scene_, volumeOf(scene_));
  const Vec3d momentum = test::sumOf(cloud_.particles.velocity);
  for (int k = 0; k < 20; ++k) {
    const double energy = sumOfSquares(cloud_);
    const auto [low, high] = velocityRange();
    viscosity.apply(cloud_.particles, cloud_.neighbours, 1.0, rows_, density);
    ASSERT_LT(sumOfSquares(cloud_), energy) << k;
    const auto [new_low, new_high] = velocityRange();
    ASSERT_GE((new_low - low).minCoeff(), -1e-14) << k;
    ASSERT_LE((new_high - high).maxCoeff(), 1e-14) << k;
  }
  EXPECT_LT((test::sumOf(cloud_.particles.velocity) - momentum).norm(), 1e-12 * 800);
}

/// Slush has a share of its own, which the density has to bound too.
TEST_F(CrowdedViscosity, OfSlushKeepsMomentumAndTakesEnergy) {
  Scene scene = viscousScene(0.0);
  scene.thermal.enabled = true;
  const EnthalpyCurve curve(scene.thermal);
  Phases<double> phases(scene, points_.size());
  phases.update(curve,
                std::vector<double>(points_.size(), 0.01 * scene.thermal.latent_heat_fusion_j_kg));
  ASSERT_GT(phases.slush()[0], 0.98);
  Viscosity<double> viscosity(scene, volumeOf(scene), &phases);
  const Vec3d momentum = test::sumOf(cloud_.particles.velocity);
  const double density = densest();
  for (int k = 0; k < 20; ++k) {
    const double energy = sumOfSquares(cloud_);
    viscosity.apply(cloud_.particles, cloud_.neighbours, 1.0, rows_, density);
    ASSERT_LT(sumOfSquares(cloud_), energy) << k;
  }
  EXPECT_LT((test::sumOf(cloud_.particles.velocity) - momentum).norm(), 1e-12 * 800);
}

TEST(ViscosityRate, DoesNotDependOnTheNumberOfSubsteps) {
  const auto after = [](int substeps) {
    auto cloud = movingCloud<double>({Vec3d::Zero(), Vec3d(0.03, 0, 0)});
    const Scene scene = viscousScene(5);
    Viscosity<double> viscosity(scene, volumeOf(scene));
    PackedXyzw<double> rows;
    for (int k = 0; k < substeps; ++k) {
      viscosity.apply(cloud.particles, cloud.neighbours, 0.02 / substeps, rows);
    }
    return (cloud.particles.velocity.at(0) - cloud.particles.velocity.at(1)).norm();
  };
  EXPECT_NEAR(after(1) / after(64), 1.0, 0.01);
}

TEST(ViscosityRate, AVelocityThatAllShareStays) {
  auto cloud = movingCloud<double>(test::lattice(5, 0.05));
  for (std::size_t i = 0; i < 125; ++i) cloud.particles.velocity.set(i, {1, -2, 3});
  const Scene scene = viscousScene(1e4);
  Viscosity<double> viscosity(scene, volumeOf(scene));
  PackedXyzw<double> rows;
  viscosity.apply(cloud.particles, cloud.neighbours, 1.0, rows);
  for (std::size_t i = 0; i < 125; ++i) {
    EXPECT_LT((cloud.particles.velocity.at(i) - Vec3d(1, -2, 3)).norm(), 1e-14);
  }
}

}  // namespace viscosity_test
}  // namespace ice_ice_baby
