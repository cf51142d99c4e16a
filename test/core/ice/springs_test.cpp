#include "ice/springs.h"

#include <gtest/gtest.h>

#include <limits>

#include "fixtures.h"

namespace ice_ice_baby {
namespace springs_test {

using test::Cloud;

/// A spring of 4 cm along x between two particles, at the origin and at its end.
template <class Real>
struct Dumbbell {
  explicit Dumbbell(const SpringParams& params)
      : cloud({Vec3d::Zero(), Vec3d(0.04, 0, 0)}, 0.1), springs(params) {
    springs.make(cloud.particles, cloud.neighbours, nullptr, Real(0.1));
  }
  /// Length after a correction from `length_m`.
  double corrected(double length_m, double strictness, double dt_s) {
    VectorField<Real>& x = cloud.particles.predicted;
    const std::size_t near = cloud.particles.id[0] == 0 ? 0 : 1;
    x.set(near, Vec3<Real>(0, 0, 0));
    x.set(1 - near, Vec3<Real>(Real(length_m), 0, 0));
    springs.correct(x, strictness, 1.0, dt_s, true);
    middle_m = double(x.x[0] + x.x[1]) / 2;
    return double(x.x[1 - near] - x.x[near]);
  }

  Cloud<Real> cloud;
  Springs<Real> springs;
  double middle_m = 0;
};

TEST(SpringRangeTest, SlackShrinksToNothingAtFreezingAndThereIsNoLongest) {
  SpringParams params;
  params.slack_1_s = 10;
  struct Case {
    double strictness, dt_s, shortest;
  };
  for (const Case& c : {Case{0, 0.01, 0.9}, Case{0.5, 0.01, 0.95}, Case{1, 0.01, 1},
                        Case{0, 0.001, 0.99}, Case{0, 1.0, 0}, Case{0.9, 0.01, 0.99}}) {
    const SpringRange range = allowedRange(params, c.strictness, c.dt_s);
    EXPECT_NEAR(range.shortest, c.shortest, 1e-12);
    EXPECT_EQ(range.longest, std::numeric_limits<double>::infinity());
  }
}

TEST(SpringCorrectionTest, HandComputed) {
  const SpringRange range{0.9, 1.2};
  EXPECT_DOUBLE_EQ(springCorrection(0.8, 1.0, range), -0.1);
  EXPECT_DOUBLE_EQ(springCorrection(1.5, 1.0, range), 0.3);
  EXPECT_EQ(springCorrection(0.9, 1.0, range), 0.0);
  EXPECT_EQ(springCorrection(1.0, 1.0, range), 0.0);
  EXPECT_EQ(springCorrection(1.2, 1.0, range), 0.0);
  EXPECT_DOUBLE_EQ(springCorrection(0.0, 2.0, range), -1.8);
}

TEST(SpringsTest, ARigidSpringCorrectsEitherWayHalfAtEachEnd) {
  Dumbbell<double> bell{SpringParams()};
  bell.springs.keep();
  ASSERT_EQ(bell.springs.size(), 1u);
  EXPECT_NEAR(bell.springs.all()[0].rest_m, 0.04, 1e-15);
  for (const double length : {0.01, 0.039, 0.05, 0.3}) {
    EXPECT_NEAR(bell.corrected(length, 1.0, 0.01), 0.04, 1e-15);
    EXPECT_NEAR(bell.middle_m, length / 2, 1e-15);
  }
}

TEST(SpringsTest, InsideItsRangeASpringDoesNothing) {
  SpringParams params;
  params.slack_1_s = 10;
  Dumbbell<double> bell(params);
  EXPECT_EQ(bell.corrected(0.0395, 0.5, 0.01), 0.0395);
  EXPECT_NEAR(bell.corrected(0.03, 0.5, 0.01), 0.04 * 0.95, 1e-15);
}

TEST(SpringsTest, FreezingSpringsNeverPullTogether) {
  Dumbbell<double> bell{SpringParams()};
  EXPECT_EQ(bell.corrected(0.09, 1.0, 0.01), 0.09);
  EXPECT_NEAR(bell.corrected(0.02, 1.0, 0.01), 0.04, 1e-15);
}

TEST(SpringsTest, MeltingEndsRigidity) {
  Dumbbell<double> bell{SpringParams()};
  bell.springs.keep();
  EXPECT_TRUE(bell.springs.kept());
  bell.springs.melt();
  EXPECT_FALSE(bell.springs.kept());
}

TEST(SpringsTest, EndsInOnePointStayFinite) {
  Dumbbell<float> bell{SpringParams()};
  EXPECT_TRUE(std::isfinite(bell.corrected(0.0, 1.0, 0.01)));
}

TEST(SpringsTest, JoinsEachPairWithinReachOnce) {
  const Cloud<double> cloud(test::randomPoints(300, Vec3d::Zero(), Vec3d::Constant(0.3), 51), 0.1);
  Springs<double> springs{SpringParams()};
  springs.make(cloud.particles, cloud.neighbours, nullptr, 0.06);
  std::size_t expected = 0;
  for (std::size_t i = 0; i < 300; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      expected += (cloud.particles.position.at(i) - cloud.particles.position.at(j)).norm() <= 0.06;
    }
  }
  EXPECT_EQ(springs.size(), expected);
  springs.make(cloud.particles, cloud.neighbours, nullptr, 0.06);
  EXPECT_EQ(springs.size(), expected) << "made anew, not added";
  springs.melt();
  EXPECT_TRUE(springs.empty());
}

TEST(SpringsTest, CorrectionsConserveMomentum) {
  const Cloud<double> cloud(test::randomPoints(500, Vec3d::Zero(), Vec3d::Constant(0.3), 52), 0.1);
  Springs<double> springs{SpringParams()};
  springs.make(cloud.particles, cloud.neighbours, nullptr, 0.08);
  VectorField<double> moved = cloud.particles.predicted;
  test::Random random(53);
  for (std::size_t i = 0; i < moved.size(); ++i) moved.add(i, 0.02 * random.direction());
  const Vec3d before = test::sumOf(moved);
  springs.correct(moved, 1.0, 1.0, 0.002, true);
  EXPECT_LT((test::sumOf(moved) - before).norm(), 1e-12 * test::sumOfNorms(moved));
}

TEST(SpringsTest, SheetSpringsSurviveMeltingAndKeepTheirLengthWhenWarm) {
  std::vector<Vec3d> points;
  for (int k = 0; k < 16; ++k) points.push_back(0.05 * Vec3d(k % 4, k / 4, 0));
  const Cloud<double> cloud(points, 0.1);
  Springs<double> springs{SpringParams()};
  springs.addSheet(cloud.particles, cloud.neighbours, {0, 16}, 0.075);
  const std::size_t sheet = 24 + 18;  // along x and y, and both diagonals of 9 squares
  EXPECT_EQ(springs.size(), sheet);
  springs.make(cloud.particles, cloud.neighbours, nullptr, 0.1);
  EXPECT_GT(springs.size(), sheet);
  springs.melt();
  EXPECT_EQ(springs.size(), sheet);
  VectorField<double> stretched = cloud.particles.predicted;
  for (double& x : stretched.x) x *= 1.3;
  for (int pass = 0; pass < 300; ++pass) springs.correct(stretched, 0.0, 1.0, 0.002, pass == 0);
  for (const Spring<double>& s : springs.all()) {
    EXPECT_NEAR((stretched.at(s.a) - stretched.at(s.b)).norm(), s.rest_m, 1e-3 * s.rest_m);
  }
}

TEST(SpringsTest, EnergyOfElasticIceIsHalfTheForceTimesTheStretch) {
  constexpr double kCompliance_m_n = 2e-4, kDt_s = 0.002;
  Cloud<double> cloud({Vec3d::Zero(), Vec3d(0.04, 0, 0)}, 0.1);
  Springs<double> springs{SpringParams()};
  springs.make(cloud.particles, cloud.neighbours, nullptr, 0.1);
  VectorField<double>& x = cloud.particles.predicted;
  x.x[1] *= 1.25;
  springs.correctElastic(x, kCompliance_m_n, 0.1, kDt_s, true);
  const double stretch_m = std::abs(x.x[1] - x.x[0]) - 0.04;
  EXPECT_GT(stretch_m, 1e-4);
  EXPECT_NEAR(springs.elasticEnergy_j(x, kDt_s), stretch_m * stretch_m / (2 * kCompliance_m_n),
              1e-9);
}

TEST(SpringsTest, EnergyOfRigidSpringsIsThatOfTheStretchLeftOver) {
  constexpr double kParticle_kg = 0.1, kDt_s = 0.002;
  Cloud<double> cloud({Vec3d::Zero(), Vec3d(0.04, 0, 0)}, 0.1);
  Springs<double> springs{SpringParams()};
  springs.make(cloud.particles, cloud.neighbours, nullptr, 0.1);
  springs.keep();
  VectorField<double>& x = cloud.particles.predicted;
  x.x[1] = 0.05;
  springs.correct(x, 1.0, kParticle_kg, kDt_s, true);
  EXPECT_NEAR(springs.elasticEnergy_j(x, kDt_s), 0.0, 1e-12) << "nothing is left";
  x.x[1] += 0.002;  // another constraint undoes some of it
  springs.correct(x, 1.0, kParticle_kg, kDt_s, false);
  x.x[1] += 0.002;
  const double pull_n = kParticle_kg * (0.01 + 0.002) / 2 / (kDt_s * kDt_s);
  EXPECT_NEAR(springs.elasticEnergy_j(x, kDt_s), pull_n * 0.002 / 2, 1e-9);
}

TEST(SpringsTest, SheetTakesItsOwnParticlesOnly) {
  const Cloud<double> cloud({Vec3d::Zero(), Vec3d(0.04, 0, 0), Vec3d(0.08, 0, 0)}, 0.1);
  Springs<double> springs{SpringParams()};
  springs.addSheet(cloud.particles, cloud.neighbours, {1, 2}, 0.1);
  ASSERT_EQ(springs.size(), 1u);
  const Spring<double>& only = springs.all()[0];
  EXPECT_EQ(cloud.particles.id[only.a] + cloud.particles.id[only.b], 3u);
}

TEST(SpringsTest, RenumberFollowsASort) {
  Cloud<double> cloud(test::randomPoints(200, Vec3d::Zero(), Vec3d::Constant(0.2), 54), 0.1);
  Springs<double> springs{SpringParams()};
  springs.make(cloud.particles, cloud.neighbours, nullptr, 0.07);
  std::vector<Index> order(200);
  for (Index k = 0; k < 200; ++k) order[k] = (k * 77 + 13) % 200;
  cloud.particles.reorder(order);
  springs.renumber(order);
  for (const Spring<double>& s : springs.all()) {
    const double length =
        (cloud.particles.position.at(s.a) - cloud.particles.position.at(s.b)).norm();
    EXPECT_NEAR(length, s.rest_m, 1e-15);
  }
}

/// Two particles of elastic ice a spacing apart, joined by one spring.
struct ElasticPair {
  static constexpr double kMass_kg = 0.008;
  static constexpr double kRest_m = 0.02;

  ElasticPair()
      : cloud({Vec3d::Zero(), Vec3d(kRest_m, 0, 0)}, 0.05, 0.01), springs(SpringParams()) {
    Scene scene;
    scene.thermal.enabled = true;
    Phases<double> phases(scene, 2);
    const EnthalpyCurve curve(scene.thermal);
    const std::vector<double> cold(2, curve.enthalpy(-5.0));
    phases.update(curve, cold);
    phases.swell(1.0);
    phases.update(curve, cold);
    springs.freeze(cloud.particles, cloud.neighbours, phases, 0.03);
  }
  double length() const {
    const auto& x = cloud.particles.predicted;
    return (x.at(1) - x.at(0)).norm();
  }

  /// Pulls with a force on each end until the length is constant.
  void pull(double newton, double compliance_m_n, double dt_s, int iterations) {
    VectorField<double>& x = cloud.particles.predicted;
    const double left = x.x[0] < x.x[1] ? -1.0 : 1.0;
    for (int substep = 0; substep < 20000; ++substep) {
      const double by = left * newton / kMass_kg * dt_s * dt_s;
      x.add(0, Vec3d(by, 0, 0));
      x.add(1, Vec3d(-by, 0, 0));
      for (int k = 0; k < iterations; ++k) {
        springs.correctElastic(x, compliance_m_n, kMass_kg, dt_s, k == 0);
      }
    }
  }

  Cloud<double> cloud;
  Springs<double> springs;
};

TEST(ElasticSpringTest, StretchesByComplianceTimesForceWhateverTheStep) {
  constexpr double kCompliance_m_n = 1e-3, kForce_n = 2.0;
  for (const double dt_s : {1.0 / 60, 1.0 / 600}) {
    for (const int iterations : {1, 4}) {
      ElasticPair pair;
      ASSERT_EQ(pair.springs.size(), 1u);
      pair.pull(kForce_n, kCompliance_m_n, dt_s, iterations);
      EXPECT_NEAR(pair.length() - ElasticPair::kRest_m, kCompliance_m_n * kForce_n, 1e-6)
          << dt_s << " s, " << iterations;
    }
  }
}

TEST(ElasticSpringTest, BreaksAboveItsStrainAndNotBelow) {
  ElasticPair pair;
  pair.pull(2.0, 1e-3, 1.0 / 60, 2);  // by a tenth of its length
  pair.springs.breakStretched(pair.cloud.particles.predicted, 0.11);
  EXPECT_EQ(pair.springs.size(), 1u);
  pair.springs.breakStretched(pair.cloud.particles.predicted, 0.09);
  EXPECT_TRUE(pair.springs.empty());
}

}  // namespace springs_test
}  // namespace ice_ice_baby
