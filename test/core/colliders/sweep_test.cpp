// Particles against colliders at up to 1000 m/s, through gaps and between colliders that move:
// never through, never inside.
#include <gtest/gtest.h>

#include "colliders/collider_faces.h"
#include "fixtures.h"

namespace ice_ice_baby {
namespace sweep_test {

using test::Random;

constexpr double kRadius_m = 0.0075;

/// Largest depth of a point in any one collider.
template <class Real>
double deepest(const Colliders<Real>& colliders, const Vec3<Real>& point) {
  ColliderFaces faces;
  faces.take(colliders);
  const Vec3d x = point.template cast<double>();
  double deep = 0.0;
  for (std::size_t k = 0; k < faces.count(); ++k) {
    const Vec3d now = faces.motion(k).to.toLocal(x);
    deep = std::max(deep, faces.push(k, faces.motion(k).from.toWorld(now), x).norm());
  }
  return deep;
}

Sphere ballAt(const Vec3d& centre, double radius, const std::string& name = "ball") {
  Sphere ball;
  ball.name = name;
  ball.position_m = centre;
  ball.radius_m = radius;
  return ball;
}

Plane plateAt(const Vec3d& centre, const Vec3d& rpy_deg, double size, double thickness,
              const std::string& name = "plate") {
  Plane plate;
  plate.name = name;
  plate.position_m = centre;
  plate.rpy_deg = rpy_deg;
  plate.size_x_m = plate.size_y_m = size;
  plate.thickness_m = thickness;
  return plate;
}

template <class Real>
class SweepTest : public testing::Test {};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(SweepTest, Reals);

/// Colliders that leave gaps of 0.1 to 3 particle diameters, in a closed tank.
Scene gaps(Random& random) {
  Scene scene;
  scene.containers.push_back(test::tankOf({0.6, 0.6, 0.6}, false));
  const double gap = 2 * kRadius_m * random.uniform(0.1, 3.0);
  scene.spheres.push_back(ballAt({0, 0, 0.1 + gap}, 0.1, "low"));
  scene.spheres.push_back(ballAt({0, 0, 0.25 + 2 * gap}, 0.05, "high"));
  scene.spheres.push_back(ballAt({0.15 + gap, 0, 0.1}, 0.05, "beside"));
  scene.spheres.push_back(ballAt({0.3 - 0.004 - gap, 0.3 - 0.004 - gap, 0.4}, 0.004, "bead"));
  scene.planes.push_back(
      plateAt({-0.1, 0, 0.3}, {0, 40, random.uniform(-180, 180)}, 0.3, 1e-3, "slope"));
  scene.planes.push_back(plateAt({-0.1, 0.1, 0.3 + gap}, {0, 0, 0}, 0.3, 1e-4, "shelf"));
  return scene;
}

TYPED_TEST(SweepTest, NothingEndsInsideWhereGapsAreNarrowerThanAParticle) {
  Random random(51);
  std::size_t inside = 0, moved = 0;
  for (int round = 0; round < 30; ++round) {
    const Colliders<TypeParam> colliders(gaps(random), kRadius_m);
    for (int walk = 0; walk < 30; ++walk) {
      Vec3<TypeParam> at;
      do {
        at = random.inBox({-0.29, -0.29, 0.01}, {0.29, 0.29, 0.59}).cast<TypeParam>();
      } while (deepest(colliders, at) > 0);
      for (int k = 0; k < 60; ++k) {
        const double step = std::pow(10.0, random.uniform(-3.0, 1.3));
        const auto to = (at + (step * random.direction()).cast<TypeParam>()).eval();
        const auto end = colliders.respond(at, to, false);
        moved += (end - at).norm() > TypeParam(1e-4);
        inside += deepest(colliders, end) > 0.02 * kRadius_m;
        at = end;
      }
    }
  }
  EXPECT_EQ(inside, 0u);
  EXPECT_GT(moved, 20000u) << "what touches two colliders is not to be stuck";
}

TYPED_TEST(SweepTest, NothingPassesBetweenBallsWithoutAGap) {
  Scene scene;
  for (int x = -3; x <= 3; ++x) {
    for (int y = -3; y <= 3; ++y) {
      // The gap between four balls is 2 mm wide: their centres are 0.0707 m from its middle.
      scene.spheres.push_back(ballAt({0.1 * x, 0.1 * y, 0}, 0.069));
    }
  }
  const Colliders<TypeParam> colliders(scene, kRadius_m);
  Random random(52);
  for (int k = 0; k < 400; ++k) {
    auto at =
        random.inBox({-0.25, -0.25, 0.2}, {0.25, 0.25, 0.4}).template cast<TypeParam>().eval();
    for (int step = 0; step < 20; ++step) {
      const double fall = std::pow(10.0, random.uniform(-3.0, 1.2));
      const Vec3d by(0, 0, -fall);
      at = colliders.respond(at, (at + by.cast<TypeParam>()).eval(), false);
      const bool beside = std::max(std::abs(at.x()), std::abs(at.y())) > TypeParam(0.35);
      if (beside) break;
      ASSERT_GT(double(at.z()), 0.0);
    }
  }
}

TYPED_TEST(SweepTest, ABallLoweredToTheGroundSqueezesOutWhatLiesUnderIt) {
  Scene scene;
  scene.planes.emplace_back();
  scene.spheres.push_back(ballAt({0, 0, 0.3}, 0.1));
  Colliders<TypeParam> colliders(scene, kRadius_m);
  Random random(53);
  std::vector<Vec3<TypeParam>> points;
  points.push_back(Vec3d(0, 0, kRadius_m).cast<TypeParam>());
  for (int k = 0; k < 300; ++k) {
    points.push_back(
        random.inBox({-0.1, -0.1, kRadius_m}, {0.1, 0.1, 0.15}).template cast<TypeParam>());
  }
  double fastest = 0.0;
  const int steps = 200;
  for (int frame = 0; frame < steps; ++frame) {
    Posed pose;
    pose.position = {0, 0, 0.3 - 0.2 * (frame + 1) / steps};
    colliders.moveTo("ball", pose);
    colliders.setSubstep(0, 1);
    for (auto& x : points) {
      const auto end = colliders.respond(x, x, false);
      fastest = std::max(fastest, double((end - x).norm()));
      x = end;
      ASSERT_LT(deepest(colliders, x), 0.02 * kRadius_m) << frame;
    }
    colliders.endFrame();
  }
  EXPECT_LT(fastest, 4 * kRadius_m);
}

TYPED_TEST(SweepTest, CollidersMovedAtAnySpeedPassOverNoParticle) {
  Random random(54);
  for (int round = 0; round < 300; ++round) {
    Scene scene;
    scene.spheres.push_back(ballAt({0, 0, 0}, random.uniform(0.002, 0.2)));
    scene.planes.push_back(plateAt({3, 0, 0}, {0, 0, 0}, 0.5, 1e-3));
    Colliders<TypeParam> colliders(scene, kRadius_m);
    const Vec3d start = 0.5 * random.direction() + Vec3d(1.5, 0, 0);
    auto at = start.cast<TypeParam>().eval();
    for (int frame = 0; frame < 20; ++frame) {
      for (const char* name : {"ball", "plate"}) {
        Posed pose;
        pose.position = start + std::pow(10.0, random.uniform(-2, 1)) * random.direction();
        pose.rotation = Eigen::AngleAxisd(random.uniform(-3, 3), random.direction()).matrix();
        colliders.moveTo(name, pose);
      }
      for (int k = 0; k < 3; ++k) {
        colliders.setSubstep(k / 3.0, (k + 1) / 3.0);
        at = colliders.respond(at, at, false);
        ASSERT_LT(deepest(colliders, at), 0.02 * kRadius_m);
      }
      colliders.endFrame();
    }
  }
}

}  // namespace sweep_test
}  // namespace ice_ice_baby
