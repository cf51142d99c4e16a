// The vectorised sums of the coarse level against the same sums one by one.
#include "coarse/cell_passes.h"

#include <gtest/gtest.h>

#include <random>

namespace ice_ice_baby {
namespace cell_passes_test {

template <class Real>
CellParticles<Real> someParticles(std::size_t n) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(0.0, 1.0);
  CellParticles<Real> particles;
  particles.resize(n);
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      particles.place[axis][k] = static_cast<Real>(any(random));
      particles.step[axis][k] = static_cast<Real>(any(random) - 0.5);
      particles.free[axis][k] = any(random) < 0.2 ? Real(0) : Real(1.1);
    }
    particles.volume[k] = static_cast<Real>(0.9 + 0.2 * any(random));
    particles.weight[k] = particles.volume[k] * particles.volume[k];
    particles.drift2[k] = static_cast<Real>(any(random));
    particles.density[k] = static_cast<Real>(any(random));
  }
  return particles;
}

/// Spline of node a of the cell at particle k, and its gradient.
template <class Real>
std::pair<double, Vec3d> spline(const CellParticles<Real>& in, std::size_t k, std::size_t a) {
  const SplineAlong<double> x(double(in.place[0][k])), y(double(in.place[1][k])),
      z(double(in.place[2][k]));
  const std::size_t i = a / 9, j = a / 3 % 3, l = a % 3;
  return {x.value[i] * y.value[j] * z.value[l],
          Vec3d(x.slope[i] * y.value[j] * z.value[l], x.value[i] * y.slope[j] * z.value[l],
                x.value[i] * y.value[j] * z.slope[l])};
}

template <class Real>
class CellPassesTest : public testing::Test {};
using Precisions = testing::Types<float, double>;
TYPED_TEST_SUITE(CellPassesTest, Precisions);

TYPED_TEST(CellPassesTest, DepositIsTheSumOverTheParticlesOfTheCellAlone) {
  const auto in = someParticles<TypeParam>(60);
  for (const std::size_t count : {1u, 7u, 16u, 33u}) {
    std::array<TypeParam, kCellNodes * kDeposits> out;
    cellPasses<TypeParam>().deposit(in, {5, count}, out.data());
    for (std::size_t a = 0; a < kCellNodes; ++a) {
      std::array<double, kDeposits> sum{};
      for (std::size_t k = 5; k < 5 + count; ++k) {
        const auto [value, slope] = spline(in, k, a);
        const Vec3d step(double(in.step[0][k]), double(in.step[1][k]), double(in.step[2][k]));
        const double volume = double(in.volume[k]);
        sum[0] += volume * slope.dot(step);
        sum[1] += volume * value;
        sum[2] += volume * value * double(in.drift2[k]);
        sum[3] += volume * value * double(in.density[k]);
      }
      for (std::size_t q = 0; q < kDeposits; ++q) {
        EXPECT_NEAR(double(out[a * kDeposits + q]), sum[q], 1e-5) << count << " node " << a;
      }
    }
  }
}

TYPED_TEST(CellPassesTest, NormalMatrixHasTheProductsOfAllPairsOfNodes) {
  const auto in = someParticles<TypeParam>(40);
  std::array<TypeParam, kCellPairs> out;
  cellPasses<TypeParam>().normalMatrix(in, {3, 29}, out.data());
  for (std::size_t a = 0; a < kCellNodes; ++a) {
    for (std::size_t b = 0; b < kCellNodes; ++b) {
      double sum = 0.0;
      for (std::size_t k = 3; k < 32; ++k) {
        const Vec3d free(double(in.free[0][k]), double(in.free[1][k]), double(in.free[2][k]));
        sum += double(in.weight[k]) *
               spline(in, k, a).second.dot(free.cwiseProduct(spline(in, k, b).second));
      }
      const int pair = (kPairAlong[a / 9][b / 9] * 6 + kPairAlong[a / 3 % 3][b / 3 % 3]) * 6 +
                       kPairAlong[a % 3][b % 3];
      EXPECT_NEAR(double(out[std::size_t(pair)]), sum, 1e-5) << a << " " << b;
    }
  }
}

TYPED_TEST(CellPassesTest, InterpolationIsTheAdjointOfTheDeposit) {
  const auto in = someParticles<TypeParam>(40);
  std::array<TypeParam, kCellNodes> mu;
  for (std::size_t a = 0; a < kCellNodes; ++a) mu[a] = static_cast<TypeParam>(0.1 * double(a) - 1);
  std::array<std::vector<TypeParam>, 3> slope;
  for (auto& axis : slope) axis.resize(40 + kCellPadding);
  std::vector<TypeParam> value(40 + kCellPadding);
  const CellRange cell{4, 21};
  cellPasses<TypeParam>().interpolate(
      in, cell, mu.data(), {slope[0].data(), slope[1].data(), slope[2].data()}, value.data());
  std::array<TypeParam, kCellNodes * kDeposits> out;
  cellPasses<TypeParam>().deposit(in, cell, out.data());
  double by_nodes = 0.0, by_particles = 0.0;
  for (std::size_t a = 0; a < kCellNodes; ++a) by_nodes += double(mu[a] * out[a * kDeposits]);
  for (std::size_t k = 4; k < 25; ++k) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      by_particles += double(slope[axis][k] * in.step[axis][k]);
    }
  }
  EXPECT_NEAR(by_particles, by_nodes, 1e-5);
  EXPECT_EQ(value[3], 0) << "a particle of another cell";
  EXPECT_EQ(value[25], 0) << "a particle of another cell";
}

}  // namespace cell_passes_test
}  // namespace ice_ice_baby
