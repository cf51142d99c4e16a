// Colliders that move through water, or jump: further in a frame than the speed limit allows. What
// they hold is carried along, what they land on is displaced, and nothing is thrown.
#include <gtest/gtest.h>

#include "fixtures.h"
#include "ice_ice_baby/errors.h"
#include "metrics/escape_meter.h"
#include "simulation/simulator.h"

namespace ice_ice_baby {
namespace jumps_test {

using test::ball;
using test::blockOf;
using test::Random;

constexpr double kSpacing_m = 0.05;
constexpr double kRadius_m = kSpacing_m / 2;

/// An empty scene in which tanks jump far.
Scene wide() {
  Scene scene;
  scene.bounds = {Vec3d::Constant(-100), Vec3d::Constant(100)};
  return scene;
}

/// Water 0.3 m deep, at rest, in a closed tank.
Scene pool() {
  Scene scene = wide();
  scene.fluid.spacing_m = kSpacing_m;
  scene.blocks.push_back(blockOf({-0.5, -0.4, 0}, {0.5, 0.4, 0.3}));
  scene.containers.push_back(test::tankOf({1, 0.8, 0.8}, false));
  return scene;
}

std::vector<ParticleSample> samplesOf(const Simulation& simulation) {
  std::vector<ParticleSample> samples;
  simulation.sample(samples);
  return samples;
}

Vec3d at(const ParticleSample& s) { return {s.x, s.y, s.z}; }

/// Distance of the nearest particle, m.
double nearestTo(const Simulation& simulation, const Vec3d& centre) {
  double nearest = 1e9;
  for (const ParticleSample& s : samplesOf(simulation)) {
    nearest = std::min(nearest, (at(s) - centre).norm());
  }
  return nearest;
}

void expectWhole(const Simulation& simulation, std::size_t particles) {
  EXPECT_EQ(simulation.report().particles, particles);
  EXPECT_EQ(simulation.report().non_finite, 0u);
  EXPECT_EQ(countEscaped(simulation), 0u);
}

Posed posed(const Vec3d& position, const Vec3d& rpy_deg = Vec3d::Zero()) {
  return poseOf(position, rpy_deg);
}

class JumpsTest : public testing::Test {
 protected:
  /// A pool that has come to rest.
  std::unique_ptr<Simulation> rested(const Scene& scene) {
    auto simulation = makeSimulation(scene, Precision::kFloat, 1);
    for (int frame = 0; frame < 20; ++frame) simulation->advanceFrame();
    particles_ = simulation->report().particles;
    return simulation;
  }
  /// Largest speed over the next frames.
  static double fastest(Simulation& simulation, int frames) {
    double max_m_s = 0.0;
    for (int k = 0; k < frames; ++k) {
      max_m_s = std::max(max_m_s, simulation.advanceFrame().max_speed_m_s);
    }
    return max_m_s;
  }
  /// Moves the tank far away; every particle must keep its place in it to `within_m`.
  static Posed expectCarried(Simulation& simulation, double within_m) {
    const std::vector<ParticleSample> was = samplesOf(simulation);
    const Posed there = posed({80, -60, 40}, {0, 0, 170});
    simulation.moveCollider("tank", there);
    simulation.advanceFrame();
    const std::vector<ParticleSample> is = samplesOf(simulation);
    for (std::size_t k = 0; k < was.size(); ++k) {
      EXPECT_LT((there.toLocal(at(is[k])) - at(was[k])).norm(), within_m);
    }
    return there;
  }

  std::size_t particles_ = 0;
};

TEST_F(JumpsTest, ATankThatJumpsTakesItsWaterAlongAsItIs) {
  const auto simulation = rested(pool());
  const double before = simulation->report().max_speed_m_s;
  expectCarried(*simulation, 0.3 * kSpacing_m);
  EXPECT_EQ(simulation->report().speed_limited, particles_) << "all are counted";
  EXPECT_LT(fastest(*simulation, 10), before + 0.3);
  expectWhole(*simulation, particles_);
  EXPECT_EQ(simulation->report().speed_limited, 0u);
}

/// A wide tank jumps at a smaller turn than the narrow one in it.
TEST_F(JumpsTest, CollidersThatMoveAsOneBodyJumpTogether) {
  Scene scene = pool();
  Box& wall = scene.boxes.emplace_back();
  wall.name = "wall";
  wall.size_m = Vec3d(0.1, 0.78, 0.2);
  wall.position_m = Vec3d(0, 0, 0.1);
  scene.blocks[0] = blockOf({-0.5, -0.4, 0}, {-0.05, 0.4, 0.3});
  scene.blocks[0].carve = true;
  const auto simulation = rested(scene);
  const Posed there = posed({0, 0, 0}, {0, 0, 38});
  const std::vector<ParticleSample> was = samplesOf(*simulation);
  simulation->moveCollider("tank", there);
  simulation->moveCollider("wall", {there.toWorld(wall.position_m), there.rotation});
  simulation->advanceFrame();
  const std::vector<ParticleSample> is = samplesOf(*simulation);
  for (std::size_t k = 0; k < was.size(); ++k) {
    EXPECT_LT((there.toLocal(at(is[k])) - at(was[k])).norm(), 0.3 * kSpacing_m);
  }
}

TEST_F(JumpsTest, ATankThatIsPlacedTakesItsWaterAlongHoweverNear) {
  for (const double distance_m : {0.004, 0.3, 5.0}) {
    const auto simulation = rested(pool());
    const double before = simulation->report().max_speed_m_s;
    const std::vector<ParticleSample> was = samplesOf(*simulation);
    const Posed there = posed({distance_m, 0, 0.1}, {0, 0, 30});
    simulation->placeColliders({{"tank", there}});
    EXPECT_EQ(simulation->colliderPose("tank").position, there.position) << "at once";
    const std::vector<ParticleSample> is = samplesOf(*simulation);
    for (std::size_t k = 0; k < was.size(); ++k) {
      ASSERT_LT((there.toLocal(at(is[k])) - at(was[k])).norm(), 1e-5);
    }
    EXPECT_LT(fastest(*simulation, 10), before + 0.1) << distance_m;
    expectWhole(*simulation, particles_);
    EXPECT_EQ(simulation->report().speed_limited, 0u);
  }
}

TEST_F(JumpsTest, APlacementThatIsRefusedPlacesNoneOfThem) {
  Scene scene = pool();
  scene.spheres.push_back(ball({0, 0, 5}, 0.12));
  const auto simulation = rested(scene);
  const std::uint64_t before = simulation->stateHash();
  EXPECT_THROW(simulation->placeColliders({{"tank", posed({1, 0, 0})}, {"bowl", Posed()}}),
               InvalidInput);
  EXPECT_THROW(
      simulation->placeColliders({{"tank", posed({1, 0, 0})}, {"ball", posed({1e9, 0, 0})}}),
      InvalidInput);
  const std::string twice = test::refusalOf([&] {
    simulation->placeColliders(
        {{"tank", posed({1, 0, 0})}, {"ball", posed({0, 0, 4})}, {"tank", posed({2, 0, 0})}});
  });
  EXPECT_EQ(twice, "collider tank is placed twice; give it one pose");
  EXPECT_EQ(simulation->stateHash(), before);
}

TEST_F(JumpsTest, TanksThatArePlacedTogetherChangeTheirWater) {
  Scene scene = pool();
  scene.containers.push_back(test::tankOf({1, 0.8, 0.8}, true, "other"));
  scene.containers[1].position_m = {3, 0, 0};
  const auto simulation = rested(scene);
  simulation->placeColliders({{"tank", posed({3, 0, 0})}, {"other", posed({0, 0, 0})}});
  simulation->advanceFrame();
  expectWhole(*simulation, particles_);
  for (const ParticleSample& s : samplesOf(*simulation)) EXPECT_NEAR(s.x, 3.0, 0.5) << s.id;
}

TEST_F(JumpsTest, TwoTanksThatChangePlacesChangeTheirWater) {
  Scene scene = pool();
  scene.containers.push_back(test::tankOf({1, 0.8, 0.8}, true, "other"));
  scene.containers[1].position_m = {3, 0, 0};
  scene.blocks.push_back(blockOf({2.5, -0.4, 0}, {3.5, 0.4, 0.1}));
  const auto simulation = rested(scene);
  simulation->moveCollider("tank", posed({3, 0, 0}));
  simulation->moveCollider("other", posed({0, 0, 0}));
  simulation->advanceFrame();
  expectWhole(*simulation, particles_);
  for (const ParticleSample& s : samplesOf(*simulation)) {
    EXPECT_NEAR(s.x, s.id < 20 * 16 * 6 ? 3.0 : 0.0, 0.5) << s.id;
  }
}

TEST_F(JumpsTest, ABallThatAppearsInThePoolShootsNothingAway) {
  Scene scene = pool();
  scene.spheres.push_back(ball({0, 0, 5}, 0.12));
  const auto simulation = rested(scene);
  const Vec3d centre(0.1, 0.05, 0.15);
  simulation->moveCollider("ball", posed(centre));
  // A ball of 3.6 litres displaces water: a wave is expected, not a jet.
  EXPECT_LT(fastest(*simulation, 20), 3.0);
  EXPECT_GT(nearestTo(*simulation, centre), 0.12 + 0.98 * kRadius_m);
  expectWhole(*simulation, particles_);
}

TEST_F(JumpsTest, AGroundThatJumpsUpLiftsWaterSlowly) {
  Scene scene = test::floatingCube(6);
  scene.planes.emplace_back().name = "ground";
  scene.blocks[0].min_m.z() += 0.01;
  scene.blocks[0].max_m.z() += 0.01;
  Simulator<float> simulator(scene, 1);
  simulator.moveCollider("ground", posed({0, 0, 2}));
  EXPECT_LT(fastest(simulator, 20), 3.0);
  const auto& z = simulator.particles().position.z;
  EXPECT_GT(*std::min_element(z.begin(), z.end()), 2 + 0.98 * kRadius_m);
}

TEST_F(JumpsTest, RandomJumpsOfCollidersLoseNothingAndThrowNothing) {
  Random random(81);
  Scene scene = pool();
  scene.spheres.push_back(ball({0, 0, 0.6}, 0.1));
  Plane plate;
  plate.name = "plate";
  plate.size_x_m = plate.size_y_m = 0.4;
  plate.thickness_m = 0.01;
  plate.position_m = {0, 0, 2};
  scene.planes.push_back(plate);
  const auto simulation = rested(scene);
  double max_m_s = 0.0;
  Posed tank = posed({0, 0, 0});
  for (int frame = 0; frame < test::repeats(150); ++frame) {
    if (frame % 5 == 0) {
      tank.position = random.uniform(0, 1) < 0.5 ? tank.position : Vec3d(50 * random.direction());
      tank.rotation =
          Eigen::AngleAxisd(random.uniform(-3.1, 3.1), random.direction()) * tank.rotation;
      simulation->moveCollider("tank", tank);
    }
    for (const char* name : {"ball", "plate"}) {
      Posed pose = posed(tank.toWorld(random.inBox({-0.6, -0.5, -0.1}, {0.6, 0.5, 0.9})));
      pose.rotation = Eigen::AngleAxisd(random.uniform(-3, 3), random.direction()).matrix();
      if (frame % 3 == 0) simulation->moveCollider(name, pose);
    }
    max_m_s = std::max(max_m_s, simulation->advanceFrame().max_speed_m_s);
    expectWhole(*simulation, particles_);
  }
  EXPECT_LE(max_m_s, 30.001);
}

TEST_F(JumpsTest, ABallDrawnThroughThePoolMakesNothingMuchFasterThanItself) {
  for (const double speed : {0.5, 2.0, 8.0, 25.0}) {
    Scene scene = pool();
    scene.spheres.push_back(ball({-0.3, 0, 0.15}, 0.06));
    scene.blocks = {blockOf({-0.2, -0.4, 0}, {0.5, 0.4, 0.3})};
    const auto simulation = rested(scene);
    const double frame_s = 1 / scene.solver.frame_rate_hz;
    double max_m_s = 0.0;
    Vec3d centre(-0.3, 0, 0.15);
    while (centre.x() < 0.3) {
      centre.x() += speed * frame_s;
      simulation->moveCollider("ball", posed(centre));
      max_m_s = std::max(max_m_s, simulation->advanceFrame().max_speed_m_s);
      EXPECT_GT(nearestTo(*simulation, centre), 0.06 + 0.98 * kRadius_m) << speed;
    }
    EXPECT_LT(max_m_s, 2.5 * speed + 2.5) << speed;
    expectWhole(*simulation, particles_);
  }
}

TEST_F(JumpsTest, IceIsCarriedAlongAndDisplacedToo) {
  Scene scene = wide();
  scene.fluid.spacing_m = kSpacing_m;
  scene.thermal.enabled = true;
  scene.thermal.speedup = 0;
  scene.containers.push_back(test::tankOf({1, 0.8, 0.8}, false));
  scene.blocks.push_back(blockOf({-0.3, -0.1, 0}, {-0.1, 0.1, 0.2}));
  scene.blocks[0].celsius = -5;
  scene.spheres.push_back(ball({5, 0, 0}, 0.1));
  const auto simulation = rested(scene);
  const Posed there = expectCarried(*simulation, 0.01);
  EXPECT_LT(simulation->report().max_speed_m_s, 0.3);
  const Vec3d centre = there.toWorld({-0.2, 0.02, 0.12});
  simulation->moveCollider("ball", posed(centre));
  EXPECT_LT(fastest(*simulation, 10), 3.0);
  EXPECT_GT(nearestTo(*simulation, centre), 0.1 + 0.5 * kRadius_m);
  expectWhole(*simulation, particles_);
}

}  // namespace jumps_test
}  // namespace ice_ice_baby
