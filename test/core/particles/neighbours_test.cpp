#include "particles/neighbours.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "fixtures.h"
#include "ice_ice_baby/errors.h"

namespace ice_ice_baby {
namespace neighbours_test {

using test::Cloud;
using test::randomPoints;
using Pairs = std::set<std::pair<std::uint32_t, std::uint32_t>>;

constexpr double kSupport_m = 0.1;

template <class Real>
class NeighboursTest : public testing::Test {
 protected:
  /// Pairs of ids nearer than h, in both orders, found by checking every pair.
  static Pairs bruteForce(const Particles<Real>& particles) {
    Pairs pairs;
    const Real h = Real(kSupport_m);
    for (std::size_t i = 0; i < particles.size(); ++i) {
      for (std::size_t j = 0; j < particles.size(); ++j) {
        const Vec3<Real> r = particles.predicted.at(j) - particles.predicted.at(i);
        if (i != j && r.squaredNorm() < h * h) pairs.insert({particles.id[i], particles.id[j]});
      }
    }
    return pairs;
  }

  /// Pairs of ids within h in the lists; fails on a pair listed twice or further apart than
  /// reach_m.
  static Pairs listed(const Particles<Real>& particles, const Neighbours<Real>& neighbours,
                      double reach_m) {
    Pairs pairs, seen;
    const Real h = Real(kSupport_m);
    for (std::size_t i = 0; i < particles.size(); ++i) {
      for (const Index j : neighbours.of(i)) {
        EXPECT_TRUE(seen.insert({Index(i), j}).second) << "pair twice";
        EXPECT_NE(i, j);
        const Vec3<Real> r = particles.predicted.at(j) - particles.predicted.at(i);
        EXPECT_LT(double(r.norm()), reach_m * 1.0001);
        if (r.squaredNorm() < h * h) pairs.insert({particles.id[i], particles.id[j]});
      }
    }
    return pairs;
  }

  /// Moves the particles to these points and builds new lists.
  static void scatter(Cloud<Real>& cloud, const std::vector<Vec3d>& points) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      cloud.particles.predicted.set(i, points[i].cast<Real>());
    }
    ASSERT_TRUE(cloud.neighbours.stale(cloud.particles.predicted));
    cloud.particles.position = cloud.particles.predicted;
    cloud.particles.reorder(cloud.neighbours.sortOrder(cloud.particles.position));
    cloud.particles.predicted = cloud.particles.position;
    cloud.neighbours.build(cloud.particles.predicted);
  }

  static void expectEveryPair(const std::vector<Vec3d>& points, const char* what) {
    for (const double skin : {0.0, 0.015}) {
      const Cloud<Real> cloud(points, kSupport_m, skin);
      EXPECT_EQ(listed(cloud.particles, cloud.neighbours, kSupport_m + skin),
                bruteForce(cloud.particles))
          << what << ", skin " << skin;
    }
  }
};

using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(NeighboursTest, Reals);

TYPED_TEST(NeighboursTest, RandomClouds) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    this->expectEveryPair(randomPoints(700, {-0.4, -0.3, 5}, {0.4, 0.3, 5.5}, seed), "cloud");
  }
}

TYPED_TEST(NeighboursTest, AllCoincident) {
  this->expectEveryPair(std::vector<Vec3d>(60, Vec3d(0.3, -0.2, 0.1)), "coincident");
}

TYPED_TEST(NeighboursTest, Collinear) {
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<Vec3d> points;
    for (int k = 0; k < 200; ++k) points.push_back(0.0317 * k * Vec3d::Unit(axis));
    this->expectEveryPair(points, "line");
  }
}

TYPED_TEST(NeighboursTest, OutlierFarAway) {
  for (const Vec3d& far : {Vec3d(1e5, 0, 0), Vec3d(-1e5, -1e5, -1e5), Vec3d(0, 1e5, -1e5)}) {
    std::vector<Vec3d> points = randomPoints(200, Vec3d::Zero(), Vec3d::Constant(0.4), 5);
    points.push_back(far);
    points.push_back(far + Vec3d(0.04, 0, 0));
    this->expectEveryPair(points, "outlier");
  }
}

// Cells of a support radius end 105 km away; points further off are in the last cell.
TYPED_TEST(NeighboursTest, OutliersBeyondTheLastCell) {
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<Vec3d> points = randomPoints(200, Vec3d::Zero(), Vec3d::Constant(0.4), 8);
    for (const Vec3d& p : randomPoints(50, Vec3d::Zero(), Vec3d::Constant(0.4), 9)) {
      points.push_back(p + 2e5 * Vec3d::Unit(axis));
    }
    this->expectEveryPair(points, "beyond");
  }
}

TYPED_TEST(NeighboursTest, TinyClusterInAWideSpread) {
  std::vector<Vec3d> points = randomPoints(300, Vec3d::Constant(-20), Vec3d::Constant(20), 6);
  for (const Vec3d& p : randomPoints(100, Vec3d::Constant(1), Vec3d::Constant(1.001), 7)) {
    points.push_back(p);
  }
  this->expectEveryPair(points, "cluster");
}

TYPED_TEST(NeighboursTest, PointsOnCellFaces) {
  std::vector<Vec3d> points;
  for (int k = 0; k < 7 * 7 * 7; ++k) {
    points.push_back(kSupport_m * Vec3d(k % 7, k / 7 % 7, k / 49));
    points.push_back(points.back() + Vec3d::Constant(kSupport_m * 0.9999 / std::sqrt(3)));
  }
  this->expectEveryPair(points, "faces");
}

TYPED_TEST(NeighboursTest, ExactlyTheSupportRadiusIsNoNeighbour) {
  const Cloud<TypeParam> cloud({Vec3d::Zero(), Vec3d(kSupport_m, 0, 0)}, kSupport_m);
  EXPECT_EQ(cloud.neighbours.of(0).size(), 0u);
  EXPECT_EQ(cloud.neighbours.pairs(), 0u);
}

TYPED_TEST(NeighboursTest, NoParticleAndOneParticleHaveNoNeighbours) {
  const Cloud<TypeParam> none({}, kSupport_m);
  EXPECT_EQ(none.neighbours.pairs(), 0u);
  EXPECT_FALSE(none.neighbours.stale(none.particles.predicted));
  const Cloud<TypeParam> one({Vec3d(1, 2, 3)}, kSupport_m);
  EXPECT_EQ(one.neighbours.of(0).size(), 0u);
}

TYPED_TEST(NeighboursTest, OrderIsAPermutation) {
  auto particles =
      test::particlesAt<TypeParam>(randomPoints(1000, Vec3d::Constant(-1), Vec3d::Constant(1), 8));
  Neighbours<TypeParam> neighbours(TypeParam(kSupport_m), 0);
  std::vector<Index> order = neighbours.sortOrder(particles.predicted);
  std::sort(order.begin(), order.end());
  for (Index k = 0; k < order.size(); ++k) ASSERT_EQ(order[k], k);
}

TYPED_TEST(NeighboursTest, ListsHoldEveryPairUntilStale) {
  const double skin = 0.03;
  Cloud<TypeParam> cloud(randomPoints(400, Vec3d::Zero(), Vec3d::Constant(0.5), 9), kSupport_m,
                         skin);
  test::Random random(10);
  VectorField<TypeParam>& x = cloud.particles.predicted;
  int steps = 0;
  while (!cloud.neighbours.stale(x) && steps < 1000) {
    EXPECT_EQ(this->listed(cloud.particles, cloud.neighbours, kSupport_m + 2 * skin),
              this->bruteForce(cloud.particles));
    for (std::size_t i = 0; i < x.size(); ++i) {
      x.add(i, (0.002 * random.direction()).cast<TypeParam>());
    }
    ++steps;
  }
  EXPECT_GT(steps, 3);
  EXPECT_LT(steps, 1000);
}

TYPED_TEST(NeighboursTest, StaleAsSoonAsTwoParticlesMovedByTheSkinAgainstEachOther) {
  Cloud<TypeParam> cloud({Vec3d::Zero(), Vec3d(1, 1, 1)}, kSupport_m, 0.02);
  VectorField<TypeParam>& x = cloud.particles.predicted;
  for (TypeParam& z : x.z) z -= 5;
  x.x[1] += TypeParam(0.0199);
  EXPECT_FALSE(cloud.neighbours.stale(x));
  x.x[1] += TypeParam(0.0002);
  EXPECT_TRUE(cloud.neighbours.stale(x));
  x.x[1] = std::numeric_limits<TypeParam>::quiet_NaN();
  EXPECT_TRUE(cloud.neighbours.stale(x));
}

TYPED_TEST(NeighboursTest, RebuildGivesTheSameSetsAsReuse) {
  Cloud<TypeParam> cloud(randomPoints(500, Vec3d::Zero(), Vec3d::Constant(0.6), 11), kSupport_m,
                         0.02);
  const Pairs reused = this->listed(cloud.particles, cloud.neighbours, kSupport_m + 0.02);
  cloud.particles.reorder(cloud.neighbours.sortOrder(cloud.particles.predicted));
  cloud.neighbours.build(cloud.particles.predicted);
  EXPECT_EQ(this->listed(cloud.particles, cloud.neighbours, kSupport_m + 0.02), reused);
  EXPECT_EQ(cloud.neighbours.builds(), 2u);
}

TYPED_TEST(NeighboursTest, ListsThatTakeTooMuchMemoryAreRefusedAndMayBeBuiltLater) {
  constexpr std::size_t kCrowd = 2000;
  const auto spread = randomPoints(kCrowd, Vec3d::Zero(), Vec3d::Ones(), 15);
  Cloud<TypeParam> cloud(spread, kSupport_m);
  const Pairs before = this->listed(cloud.particles, cloud.neighbours, kSupport_m);
  cloud.neighbours.limitLists(1e6);  // 2000^2 neighbours are 16 MB
  try {
    this->scatter(cloud, std::vector<Vec3d>(kCrowd, Vec3d(0.5, 0.5, 0.5)));
    FAIL() << "nothing was refused";
  } catch (const InvalidInput& e) {
    EXPECT_STREQ(e.what(),
                 "the lists of neighbours take more than 1 MB of memory: 2000 particles lie in one "
                 "cube of 0.1 m; give the water more room or enlarge fluid.spacing_m");
  }
  EXPECT_TRUE(cloud.neighbours.stale(cloud.particles.predicted));
  EXPECT_LT(cloud.neighbours.bytes(), 1'500'000u);
  cloud.particles = test::particlesAt<TypeParam>(spread);
  this->scatter(cloud, spread);
  EXPECT_EQ(this->listed(cloud.particles, cloud.neighbours, kSupport_m), before);
}

TYPED_TEST(NeighboursTest, ListsAreCompleteAfterTheNumberOfParticlesFalls) {
  Neighbours<TypeParam> neighbours(TypeParam(kSupport_m), 0);
  for (const std::size_t count : {600u, 20u, 0u}) {
    auto particles =
        test::particlesAt<TypeParam>(randomPoints(count, Vec3d::Zero(), Vec3d::Constant(0.3), 12));
    particles.reorder(neighbours.sortOrder(particles.predicted));
    neighbours.build(particles.predicted);
    EXPECT_EQ(this->listed(particles, neighbours, kSupport_m), this->bruteForce(particles));
  }
}

}  // namespace neighbours_test
}  // namespace ice_ice_baby
