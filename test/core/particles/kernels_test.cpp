#include "particles/kernels.h"

#include <gtest/gtest.h>

#include <limits>

namespace ice_ice_baby {
namespace kernels_test {

template <class Kernel>
class KernelTest : public testing::Test {
 protected:
  using Real = decltype(Kernel::h);
  static constexpr double kRounding = 100 * double(std::numeric_limits<Real>::epsilon());
  const Kernel kernel_{Real(0.03)};

  double w(double r) const { return double(kernel_.w(Real(r))); }
  double slope(double r) const { return double(kernel_.slope(Real(r))); }
};

using Kernels = testing::Types<CubicSpline<double>, CubicSpline<float>, Poly6<double>, Poly6<float>,
                               Spiky<double>, Spiky<float>>;
TYPED_TEST_SUITE(KernelTest, Kernels);

TYPED_TEST(KernelTest, IntegralOverTheBallIsOne) {
  const double h = 0.03;
  const int shells = 4000;
  double sum = 0.0;
  for (int k = 0; k < shells; ++k) {
    const double r = h * (k + 0.5) / shells;
    sum += 4 * M_PI * r * r * this->w(r) * h / shells;
  }
  EXPECT_NEAR(sum, 1.0, 1e-6 + this->kRounding);
}

TYPED_TEST(KernelTest, SlopeIsTheFiniteDifferenceOfTheValue) {
  const double h = 0.03, step = 1e-3 * h;
  const double scale = this->w(0) / h;
  for (double q = 0.01; q < 0.99; q += 0.0171) {
    const double difference = (this->w(q * h + step) - this->w(q * h - step)) / (2 * step);
    EXPECT_NEAR(this->slope(q * h), difference, scale * (2e-5 + 50 * this->kRounding)) << q;
  }
}

TYPED_TEST(KernelTest, FallsToNothingAtTheSupportRadiusAndStaysThere) {
  for (const double q : {1.0, 1.0001, 1.5, 100.0}) {
    EXPECT_NEAR(this->w(q * 0.03), 0.0, this->w(0) * this->kRounding) << q;
    EXPECT_NEAR(this->slope(q * 0.03), 0.0, this->w(0) / 0.03 * this->kRounding) << q;
  }
  double before = this->w(0);
  for (double q = 0.02; q < 1.0; q += 0.02) {
    EXPECT_LT(this->w(q * 0.03), before);
    EXPECT_LE(this->slope(q * 0.03), 0.0);
    before = this->w(q * 0.03);
  }
}

TEST(CubicSplineTest, KnownValues) {
  const CubicSpline<double> kernel(2.0);
  EXPECT_NEAR(kernel.w(0), 8 / (M_PI * 8), 1e-15);
  EXPECT_NEAR(kernel.w(1.0), 2 / (M_PI * 8), 1e-15);
  EXPECT_EQ(kernel.slope(0), 0.0);
}

TEST(Poly6Test, CentreIsTheMuellerConstantNotThePaperMisprint) {
  EXPECT_NEAR(Poly6<double>(0.1).w(0) * 1e-3, 315 / (64 * M_PI), 1e-12);
  EXPECT_DOUBLE_EQ(densityAtZero(KernelPair::kPoly6Spiky, 0.1), Poly6<double>(0.1).w(0));
  EXPECT_DOUBLE_EQ(densityAtZero(KernelPair::kCubic, 0.1), CubicSpline<double>(0.1).w(0));
}

TEST(SpikyTest, GradientIsFortyFiveOverPi) {
  EXPECT_NEAR(Spiky<double>(1.0).slope(0.5), -45 / M_PI * 0.25, 1e-12);
}

TEST(KernelPairTest, PaperMeasuresWithPoly6AndCorrectsWithSpiky) {
  const Poly6SpikyPair<double> paper(0.1);
  EXPECT_DOUBLE_EQ(paper.density.w(0.03), Poly6<double>(0.1).w(0.03));
  EXPECT_DOUBLE_EQ(paper.gradient.slope(0.03), Spiky<double>(0.1).slope(0.03));
  const CubicPair<double> cubic(0.1);
  EXPECT_DOUBLE_EQ(cubic.density.slope(0.03), cubic.gradient.slope(0.03));
}

TEST(LatticeSumTest, HalfSpacingHasTheKnownRestDensity) {
  const double h = 0.1;
  EXPECT_NEAR(latticeSum(Poly6<double>(h), h / 2, true) * h * h * h, 8.078, 5e-4);
  EXPECT_NEAR(
      latticeSum(Poly6<double>(h), h / 2, true) - latticeSum(Poly6<double>(h), h / 2, false),
      Poly6<double>(h).w(0), 1e-9);
}

TEST(LatticeSumTest, FineLatticeIntegratesToOne) {
  const double h = 1.0, d = h / 12;
  EXPECT_NEAR(latticeSum(CubicSpline<double>(h), d, true) * d * d * d, 1.0, 1e-3);
  EXPECT_NEAR(latticeSum(Poly6<double>(h), d, true) * d * d * d, 1.0, 1e-3);
}

TEST(ParticleMassTest, GivenOrSuchThatTheLatticeHasRestDensity) {
  FluidParams fluid;
  for (const KernelPair pair : {KernelPair::kCubic, KernelPair::kPoly6Spiky}) {
    fluid.kernel = pair;
    const double h = 2 * fluid.spacing_m;
    const double sum = pair == KernelPair::kCubic
                           ? latticeSum(CubicSpline<double>(h), fluid.spacing_m, true)
                           : latticeSum(Poly6<double>(h), fluid.spacing_m, true);
    EXPECT_NEAR(particleMass_kg(fluid, h) * sum, fluid.rest_density_kg_m3, 1e-9);
  }
  fluid.particle_mass_kg = 1.25;
  EXPECT_EQ(particleMass_kg(fluid, 0.05), 1.25);
}

}  // namespace kernels_test
}  // namespace ice_ice_baby
