// Vector loops on every instruction set of this processor, compared with plain sums in double.
#include <gtest/gtest.h>
#include <hwy/highway.h>

#include <algorithm>

#include "fixtures.h"
#include "fluid/pair_passes.h"
#include "particles/kernels.h"

namespace ice_ice_baby {
namespace instruction_sets_test {

using test::Cloud;

constexpr double kSupport_m = 0.1;
constexpr double kShear = 0.75;

template <class Real>
struct Sums {
  explicit Sums(std::size_t n) : density(n), squares(n) {
    gradients.resize(n);
    corrections.resize(n);
    differences.resize(n);
  }
  std::vector<Real> density, squares;
  VectorField<Real> gradients, corrections, differences;
};

/// Relative volume (0 for some) and grip of particle i in a mixture.
double shareOf(std::size_t i) { return i % 5 == 0 ? 0.0 : 1.0 + 0.01 * double(i % 7); }
double gripOf(std::size_t i) { return i % 3 == 0 ? double(kRigidGrip) : 0.5 * double(i % 4); }

/// Every sum by its definition, over all pairs. The y coordinate serves as lambda, the position as
/// velocity.
template <class Kernels, class Real>
Sums<double> plainSums(const VectorField<Real>& field, bool mixture) {
  const Kernels kernels(kSupport_m);
  const CubicSpline<double> cubic(kSupport_m);
  const double half = kSupport_m / 2;
  const double scale = kernels.gradient.slope(half) / half;
  Sums<double> sums(field.size());
  for (std::size_t i = 0; i < field.size(); ++i) {
    const Vec3d xi = field.at(i).template cast<double>();
    for (std::size_t j = 0; j < field.size(); ++j) {
      const Vec3d xj = field.at(j).template cast<double>();
      const double r = (xi - xj).norm();
      if (r == 0) continue;
      const double s = kernels.gradient.slope(r) / r / scale;
      const double own = mixture ? shareOf(i) : 1, other = mixture ? shareOf(j) : 1;
      const double lesser = std::min(gripOf(i), gripOf(j));
      const double grip = mixture ? (lesser == double(kRigidGrip) ? 0 : lesser) : 1;
      sums.density[i] += other * kernels.density.w(r) / kernels.density.w(0);
      sums.squares[i] += other * other * s * s * r * r / (kSupport_m * kSupport_m);
      sums.gradients.add(i, other * s * (xi - xj));
      sums.corrections.add(i, (xi.y() * other + xj.y() * own) * s * (xi - xj));
      const double whole = mixture ? std::min(grip, kShear) : 1;
      const Vec3d along = (xi - xj) / r;
      const Vec3d taken = whole * (xj - xi) + (grip - whole) * (xj - xi).dot(along) * along;
      sums.differences.add(i, cubic.w(r) / cubic.w(0) * taken);
    }
  }
  return sums;
}

template <class Real>
Sums<Real> vectorSums(const Cloud<Real>& cloud, KernelPair kernel, bool mixture) {
  const VectorField<Real>& x = cloud.particles.predicted;
  std::vector<Real> shares(x.size()), grips(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    shares[i] = static_cast<Real>(shareOf(i));
    grips[i] = static_cast<Real>(gripOf(i));
  }
  PackedXyzw<Real> by_share, by_lambda, by_grip;
  by_share.pack(x, shares);
  by_lambda.pack(x, x.y);
  by_grip.pack(x, grips);
  PairInput<Real> pairs{cloud.neighbours, by_share.data(), by_grip.data(),
                        Real(kSupport_m), shares.data(),   Real(kShear)};
  const PairPasses<Real> passes =
      mixture ? mixturePairPasses<Real>(kernel) : pairPasses<Real>(kernel);
  Sums<Real> sums(x.size());
  const ParticleRange all{0, x.size()};
  passes.sumConstraint(pairs, {sums.density, sums.squares, sums.gradients}, all);
  passes.addDifferences(pairs, Real(1), sums.differences, all);
  pairs.positions = by_lambda.data();
  passes.sumCorrections(pairs, sums.corrections, all);
  return sums;
}

template <class Real>
void expectNear(const std::vector<Real>& values, const std::vector<double>& truth) {
  double scale = 0;
  for (const double value : truth) scale = std::max(scale, std::abs(value));
  ASSERT_GT(scale, 0.0);
  const double tolerance = scale * (sizeof(Real) == 8 ? 1e-12 : 2e-6);
  for (std::size_t i = 0; i < truth.size(); ++i) ASSERT_NEAR(values[i], truth[i], tolerance) << i;
}

template <class Real>
void expectNear(const VectorField<Real>& values, const VectorField<double>& truth) {
  expectNear(values.x, truth.x);
  expectNear(values.y, truth.y);
  expectNear(values.z, truth.z);
}

template <class Real>
void expectPlainSums(KernelPair kernel, bool mixture) {
  const auto points = test::randomPoints(333, Vec3d::Zero(), Vec3d::Constant(0.3), 31);
  const Cloud<Real> cloud(points, kSupport_m, 0.02);
  const VectorField<Real>& x = cloud.particles.predicted;
  const Sums<double> truth = kernel == KernelPair::kCubic
                                 ? plainSums<CubicPair<double>>(x, mixture)
                                 : plainSums<Poly6SpikyPair<double>>(x, mixture);
  const Sums<Real> sums = vectorSums(cloud, kernel, mixture);
  expectNear(sums.density, truth.density);
  expectNear(sums.squares, truth.squares);
  expectNear(sums.gradients, truth.gradients);
  expectNear(sums.corrections, truth.corrections);
  expectNear(sums.differences, truth.differences);
}

/// Selects one instruction set during its lifetime.
class OnTarget {
 public:
  explicit OnTarget(std::int64_t target) { choose(target); }
  ~OnTarget() { choose(0); }  // 0: all that the processor has

 private:
  static void choose(std::int64_t target) {
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  }
};

TEST(InstructionSets, EachGivesThePlainSums) {
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    SCOPED_TRACE(hwy::TargetName(target));
    const OnTarget on(target);
    for (const KernelPair kernel : {KernelPair::kCubic, KernelPair::kPoly6Spiky}) {
      for (const bool mixture : {false, true}) {
        expectPlainSums<float>(kernel, mixture);
        expectPlainSums<double>(kernel, mixture);
      }
    }
  }
}

TEST(InstructionSets, EachFindsTheSameNeighbours) {
  const auto points = test::randomPoints(500, Vec3d::Zero(), Vec3d::Constant(0.5), 32);
  const Cloud<double> best(points, kSupport_m, 0.02);
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    SCOPED_TRACE(hwy::TargetName(target));
    const OnTarget on(target);
    const Cloud<double> cloud(points, kSupport_m, 0.02);
    ASSERT_EQ(cloud.neighbours.pairs(), best.neighbours.pairs());
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto list = cloud.neighbours.of(i), expected = best.neighbours.of(i);
      ASSERT_TRUE(std::equal(list.begin(), list.end(), expected.begin(), expected.end())) << i;
    }
    EXPECT_FALSE(cloud.neighbours.stale(cloud.particles.predicted));
  }
}

}  // namespace instruction_sets_test
}  // namespace ice_ice_baby
