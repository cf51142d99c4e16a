#include "fluid/density_constraint.h"

#include <gtest/gtest.h>

#include "fixtures.h"
#include "particles/kernels.h"

namespace ice_ice_baby {
namespace density_constraint_test {

using test::Cloud;

Scene sceneOf(KernelPair pair) {
  Scene scene;
  scene.fluid.spacing_m = 0.05;
  scene.fluid.kernel = pair;
  scene.solver.max_correction_h = 0.0;
  return scene;
}

/// Equations 2 to 6 summed over every pair, in double.
struct BruteForce {
  std::vector<double> density, lambda;
  std::vector<Vec3d> delta_p;

  template <class Kernels, class Real>
  static BruteForce solve(const Scene& scene, const VectorField<Real>& field) {
    const double h = scene.supportRadius_m();
    const Kernels kernels(h);
    const double volume = particleMass_kg(scene.fluid, h) / scene.fluid.rest_density_kg_m3;
    const std::size_t n = field.size();
    const auto x = [&](std::size_t i) { return field.at(i).template cast<double>().eval(); };
    const auto gradient = [&](const Vec3d& r) -> Vec3d {
      return r.norm() > 0 ? Vec3d(volume * kernels.gradient.slope(r.norm()) * r.normalized())
                          : Vec3d(Vec3d::Zero());
    };
    BruteForce result;
    for (std::size_t i = 0; i < n; ++i) {
      double density = scene.fluid.self_density ? volume * kernels.density.w(0) : 0.0;
      double squares = scene.solver.epsilon / (h * h);
      Vec3d own = Vec3d::Zero();
      for (std::size_t j = 0; j < n; ++j) {
        if (j == i) continue;
        density += volume * kernels.density.w((x(i) - x(j)).norm());
        own += gradient(x(i) - x(j));
        squares += gradient(x(i) - x(j)).squaredNorm();
      }
      const double wanted = density - 1;
      const double c = scene.solver.resist_tension ? wanted : std::max(wanted, 0.0);
      result.density.push_back(density);
      result.lambda.push_back(-scene.relaxation() * c / (squares + own.squaredNorm()));
    }
    for (std::size_t i = 0; i < n; ++i) {
      Vec3d sum = Vec3d::Zero();
      for (std::size_t j = 0; j < n; ++j) {
        if (j != i) sum += (result.lambda[i] + result.lambda[j]) * gradient(x(i) - x(j));
      }
      result.delta_p.push_back(sum);
    }
    return result;
  }
};

template <class Real>
std::unique_ptr<DensityConstraint<Real>> solved(const Scene& scene, const Cloud<Real>& cloud,
                                                const BoundaryDensity<Real>* walls = nullptr) {
  auto constraint = std::make_unique<DensityConstraint<Real>>(scene, walls);
  constraint->computeLambda(cloud.particles, cloud.neighbours);
  constraint->computeDeltaP(cloud.particles, cloud.neighbours);
  return constraint;
}

template <class Real>
class DensityConstraintTest : public testing::Test {
 protected:
  static constexpr double kTolerance = sizeof(Real) == 8 ? 1e-10 : 2e-4;

  static void expectBruteForce(const Scene& scene, const Cloud<Real>& cloud) {
    const VectorField<Real>& x = cloud.particles.predicted;
    const BruteForce truth = scene.fluid.kernel == KernelPair::kCubic
                                 ? BruteForce::solve<CubicPair<double>>(scene, x)
                                 : BruteForce::solve<Poly6SpikyPair<double>>(scene, x);
    const auto own = solved(scene, cloud);
    double lambda_scale = 0, delta_scale = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      lambda_scale = std::max(lambda_scale, std::abs(truth.lambda[i]));
      delta_scale = std::max(delta_scale, truth.delta_p[i].norm());
    }
    ASSERT_GT(delta_scale, 0.0);
    for (std::size_t i = 0; i < x.size(); ++i) {
      EXPECT_NEAR(own->density()[i], truth.density[i], kTolerance * truth.density[i]);
      EXPECT_NEAR(own->lambda()[i], truth.lambda[i], kTolerance * lambda_scale);
      const Vec3d delta = own->deltaP().at(i).template cast<double>();
      EXPECT_LT((delta - truth.delta_p[i]).norm(), kTolerance * delta_scale) << i;
    }
  }
};

using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(DensityConstraintTest, Reals);

TYPED_TEST(DensityConstraintTest, IsEquations2To6) {
  for (const KernelPair pair : {KernelPair::kCubic, KernelPair::kPoly6Spiky}) {
    for (const bool tension : {false, true}) {
      for (const bool self : {false, true}) {
        Scene scene = sceneOf(pair);
        scene.solver.resist_tension = tension;
        scene.fluid.self_density = self;
        const Cloud<TypeParam> cloud(
            test::randomPoints(301, Vec3d::Zero(), Vec3d::Constant(0.3), 21), 0.1, 0.01);
        this->expectBruteForce(scene, cloud);
      }
    }
  }
}

TYPED_TEST(DensityConstraintTest, OddNumbersOfNeighboursAgreeWithBruteForce) {
  for (const std::size_t count : {2u, 3u, 5u, 8u, 9u, 17u, 31u, 257u}) {
    const Cloud<TypeParam> cloud(
        test::randomPoints(count, Vec3d::Zero(), Vec3d::Constant(0.05), count), 0.1);
    Scene scene = sceneOf(KernelPair::kCubic);
    scene.solver.resist_tension = true;
    this->expectBruteForce(scene, cloud);
  }
}

TYPED_TEST(DensityConstraintTest, InteriorOfTheRestLatticeIsAtRest) {
  for (const KernelPair pair : {KernelPair::kCubic, KernelPair::kPoly6Spiky}) {
    const Cloud<TypeParam> cloud(test::lattice(9, 0.05), 0.1, 0.015);
    const auto constraint = solved(sceneOf(pair), cloud);
    int interior = 0;
    for (std::size_t i = 0; i < cloud.particles.size(); ++i) {
      EXPECT_LE(double(constraint->density()[i]), 1 + 1e-6);
      const Vec3<TypeParam> x = cloud.particles.predicted.at(i);
      if (x.minCoeff() < 0.1 || x.maxCoeff() > 0.35) continue;
      EXPECT_NEAR(constraint->density()[i], 1.0, 1e-6);
      ++interior;
    }
    EXPECT_EQ(interior, 125);
  }
}

TYPED_TEST(DensityConstraintTest, LatticeThatFillsAClosedBoxIsAtRestUpToTheCorners) {
  Scene scene = sceneOf(KernelPair::kCubic);
  scene.containers.push_back(test::tankOf(Vec3d::Constant(0.3), false));
  const Cloud<TypeParam> cloud(test::lattice(6, 0.05, {-0.15, -0.15, 0}), 0.1, 0.015);
  const Colliders<TypeParam> colliders(scene, 0.025);
  const BoundaryDensity<TypeParam> walls(
      scene, colliders, particleMass_kg(scene.fluid, 0.1) / scene.fluid.rest_density_kg_m3);
  const auto constraint = solved(scene, cloud, &walls);
  for (std::size_t i = 0; i < cloud.particles.size(); ++i) {
    EXPECT_NEAR(constraint->density()[i], 1.0, 1e-6) << cloud.particles.position.at(i).transpose();
    EXPECT_LT(constraint->deltaP().at(i).norm(), 1e-7);
  }
}

// Forces between pairs cancel, so the sum of all corrections is what the walls push.
TEST(DensityConstraintMomentum, ThreeWallsOfACornerPushEqually) {
  Scene scene = sceneOf(KernelPair::kCubic);
  scene.containers.push_back(test::tankOf(Vec3d::Constant(1.0), false));
  const Cloud<double> cloud(test::lattice(6, 0.045, {-0.5, -0.5, 0}), 0.1);
  const Colliders<double> colliders(scene, 0.0225);
  const BoundaryDensity<double> walls(
      scene, colliders, particleMass_kg(scene.fluid, 0.1) / scene.fluid.rest_density_kg_m3);
  const auto constraint = solved(scene, cloud, &walls);
  const double moved = test::sumOfNorms(constraint->deltaP());
  const Vec3d pushed = test::sumOf(constraint->deltaP());
  EXPECT_GT(pushed.minCoeff(), 0.01 * moved) << pushed.transpose() << " of " << moved;
  EXPECT_LT(pushed.maxCoeff() - pushed.minCoeff(), 1e-6 * moved) << pushed.transpose();
}

TEST(DensityConstraintMomentum, InternalCorrectionsSumToNothing) {
  for (const KernelPair pair : {KernelPair::kCubic, KernelPair::kPoly6Spiky}) {
    Scene scene = sceneOf(pair);
    scene.solver.resist_tension = true;
    const Cloud<double> cloud(test::randomPoints(2000, Vec3d::Zero(), Vec3d::Constant(0.6), 22),
                              0.1);
    const auto constraint = solved(scene, cloud);
    const double moved = test::sumOfNorms(constraint->deltaP());
    ASSERT_GT(moved, 0.0);
    EXPECT_LT(test::sumOf(constraint->deltaP()).norm(), 1e-12 * moved);
  }
}

TYPED_TEST(DensityConstraintTest, LambdaOpposesTheConstraint) {
  Scene scene = sceneOf(KernelPair::kCubic);
  scene.solver.resist_tension = true;
  const Cloud<TypeParam> cloud(test::randomPoints(500, Vec3d::Zero(), Vec3d::Constant(0.4), 23),
                               0.1);
  const auto constraint = solved(scene, cloud);
  for (std::size_t i = 0; i < cloud.particles.size(); ++i) {
    const TypeParam c = constraint->density()[i] - 1;
    EXPECT_LE(double(c) * double(constraint->lambda()[i]), 0.0);
  }
}

TYPED_TEST(DensityConstraintTest, ALoneParticleDoesNotMove) {
  for (const bool tension : {false, true}) {
    Scene scene = sceneOf(KernelPair::kCubic);
    scene.solver.resist_tension = tension;
    const Cloud<TypeParam> cloud({Vec3d(1, 2, 3)}, 0.1);
    const auto constraint = solved(scene, cloud);
    EXPECT_TRUE(tension || constraint->lambda()[0] == TypeParam(0));
    EXPECT_EQ(constraint->deltaP().at(0).norm(), TypeParam(0));
  }
}

TYPED_TEST(DensityConstraintTest, EightTooNearParticlesMoveOutAlikeAlongTheirDiagonals) {
  const Cloud<TypeParam> cloud(test::lattice(2, 0.02), 0.1);
  const auto constraint = solved(sceneOf(KernelPair::kCubic), cloud);
  const double moved = double(constraint->deltaP().at(0).norm());
  EXPECT_GT(moved, 1e-3);
  for (std::size_t i = 0; i < 8; ++i) {
    const Vec3<TypeParam> x = cloud.particles.predicted.at(i);
    const Vec3d out = (x.template cast<double>() - Vec3d::Constant(0.02)).normalized();
    const Vec3d by = constraint->deltaP().at(i).template cast<double>();
    EXPECT_LT((by - moved * out).norm(), TestFixture::kTolerance * moved);
  }
}

TYPED_TEST(DensityConstraintTest, TheLargestCorrectionIsTheLimit) {
  Scene scene = sceneOf(KernelPair::kCubic);
  scene.solver.max_correction_h = 0.02;
  const Cloud<TypeParam> cloud(test::randomPoints(800, Vec3d::Zero(), Vec3d::Constant(0.1), 24),
                               0.1);
  const auto constraint = solved(scene, cloud);
  double largest = 0;
  for (std::size_t i = 0; i < cloud.particles.size(); ++i) {
    largest = std::max(largest, double(constraint->deltaP().at(i).norm()));
  }
  EXPECT_NEAR(largest, 0.002, 1e-7);
}

// Constant pressure needs corrections proportional to the square of the substep.
TYPED_TEST(DensityConstraintTest, AWarmStartFollowsTheSquareOfTheSubstep) {
  Scene scene = sceneOf(KernelPair::kCubic);
  scene.solver.warm_start = 0.5;
  Cloud<TypeParam> cloud(test::randomPoints(200, Vec3d::Zero(), Vec3d::Constant(0.2), 25), 0.1);
  DensityConstraint<TypeParam> constraint(scene, nullptr);
  constraint.warmStart(cloud.particles);
  constraint.computeLambda(cloud.particles, cloud.neighbours);
  constraint.computeDeltaP(cloud.particles, cloud.neighbours);
  constraint.rescaleWarmStart(0.5);
  const VectorField<TypeParam> before = cloud.particles.predicted;
  constraint.warmStart(cloud.particles);
  double largest = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const Vec3<TypeParam> moved = cloud.particles.predicted.at(i) - before.at(i);
    const Vec3<TypeParam> wanted = TypeParam(0.5 * 0.25) * constraint.deltaP().at(i);
    EXPECT_LT(double((moved - wanted).norm()), 1e-7) << i;
    largest = std::max(largest, double(wanted.norm()));
  }
  EXPECT_GT(largest, 1e-5);
}

TYPED_TEST(DensityConstraintTest, CoincidentAndNearlyCoincidentParticlesStayFinite) {
  std::vector<Vec3d> points(40, Vec3d(0.1, 0.2, 0.3));
  for (int k = 0; k < 40; ++k) points.push_back(Vec3d(0.1 + 1e-12 * k, 0.2, 0.3 + 1e-9));
  points.push_back(Vec3d(0.15, 0.2, 0.3));
  Scene scene = sceneOf(KernelPair::kCubic);
  scene.solver.epsilon = 0.0;
  const Cloud<TypeParam> cloud(points, 0.1);
  const auto constraint = solved(scene, cloud);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_TRUE(std::isfinite(constraint->lambda()[i]));
    EXPECT_TRUE(constraint->deltaP().at(i).allFinite());
  }
}

TYPED_TEST(DensityConstraintTest, SolvesAgainForFewerParticles) {
  const Scene scene = sceneOf(KernelPair::kCubic);
  auto constraint = std::make_unique<DensityConstraint<TypeParam>>(scene, nullptr);
  for (const std::size_t count : {300u, 40u, 0u}) {
    const Cloud<TypeParam> cloud(test::randomPoints(count, Vec3d::Zero(), Vec3d::Constant(0.2), 25),
                                 0.1);
    constraint->computeLambda(cloud.particles, cloud.neighbours);
    constraint->computeDeltaP(cloud.particles, cloud.neighbours);
    EXPECT_EQ(constraint->density().size(), count);
    EXPECT_EQ(constraint->deltaP().size(), count);
  }
}

}  // namespace density_constraint_test
}  // namespace ice_ice_baby
