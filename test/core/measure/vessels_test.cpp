// What vessels and gauges hold: known fills, at rest, tilted and far away, innermost vessels, ice.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "fixtures.h"
#include "ice_ice_baby/scene_loader.h"
#include "simulation/simulator.h"

namespace ice_ice_baby {
namespace vessels_test {

Scene sceneOf(const std::string& yaml) { return parseScene(yaml); }

std::vector<VesselReport> measured(const Scene& scene) {
  return makeSimulation(scene, Precision::kFloat, 1)->vessels();
}

/// A box of 0.2 x 0.2 x 0.3 m with water 0.2 m deep.
Scene boxAt(double spacing_m, const std::string& place) {
  return sceneOf("fluid: {spacing_m: " + numberText(spacing_m) + "}\n" +
                 "bounds: {min_m: [-90, -90, -90], max_m: [90, 90, 90]}\n" +
                 "containers: [{name: box, size_m: [0.2, 0.2, 0.3], " + place + "}]\n" +
                 "blocks: [{min_m: [-0.1, -0.1, 0], max_m: [0.1, 0.1, 0.2], frame: box}]\n");
}

TEST(VesselsTest, ABoxHoldsWhatItWasFilledWithAtEverySpacing) {
  for (const double spacing_m : {0.04, 0.02, 0.01}) {
    for (const std::string place : {"position_m: [0, 0, 0]", "position_m: [60, -70, 50]"}) {
      const Scene scene = boxAt(spacing_m, place);
      const VesselReport box = measured(scene).at(0);
      EXPECT_EQ(box.name, "box");
      EXPECT_EQ(double(box.particles), std::round(0.008 / std::pow(spacing_m, 3)));
      EXPECT_NEAR(box.water_m3, 0.008, 1e-9);
      EXPECT_EQ(box.ice_m3, 0.0);
      EXPECT_NEAR(box.level_m, 0.2, 1e-6) << spacing_m << ", " << place;
      EXPECT_TRUE(std::isnan(box.mean_celsius));
    }
  }
}

/// Tilted by 30 degrees about y: the volume 0.2 m x 0.2 m x depth lies below a surface that meets
/// both walls, as long as the depth is above 0.1 m x tan(30 degrees).
TEST(VesselsTest, TheLevelOfATiltedBoxIsThatOfTheTiltedSurface) {
  const double tilt = M_PI / 6;
  for (const std::string position : {"[0, 0, 0]", "[-60, 70, 80]"}) {
    const Scene scene = boxAt(0.02, "position_m: " + position + ", rpy_deg: [0, 30, 0]");
    const VesselReport box = measured(scene).at(0);
    EXPECT_EQ(box.particles, 1000U);
    EXPECT_NEAR(box.level_m, 0.2 * std::cos(tilt) + 0.1 * std::sin(tilt), 0.002) << position;
  }
}

TEST(VesselsTest, ACupHoldsWhatItWasFilledWith) {
  for (const double spacing_m : {0.01, 0.007}) {
    for (const std::string rpy : {"[0, 0, 0]", "[30, 0, 0]", "[180, 0, 0]"}) {
      const Scene scene =
          sceneOf("fluid: {spacing_m: " + numberText(spacing_m) + "}\n" +
                  "cups: [{name: cup, radius_m: 0.05, depth_m: 0.1, position_m: [1, 2, 3], "
                  "rpy_deg: " +
                  rpy + "}]\n" +
                  "blocks: [{shape: cylinder, min_m: [-0.05, -0.05, 0], max_m: [0.05, 0.05, 0.06], "
                  "frame: cup}]\n");
      const VesselReport cup = measured(scene).at(0);
      EXPECT_EQ(std::int64_t(cup.particles), particleCount(scene));
      const double depth_m = cup.water_m3 / (M_PI * 0.05 * 0.05);
      EXPECT_NEAR(depth_m, 0.06, 0.1 * 0.06);  // of a lattice in a circle
      const double tilt = rpy == "[30, 0, 0]" ? M_PI / 6 : 0.0;
      const double expected_m = depth_m * std::cos(tilt) + 0.05 * std::sin(tilt);
      EXPECT_NEAR(cup.level_m, expected_m, 0.01 * expected_m) << spacing_m << " " << rpy;
    }
  }
}

/// Height of the surface above `floor_m`, of the `count` highest particles, which are a layer.
double surface_m(const Simulation& simulation, double floor_m, std::size_t count) {
  std::vector<ParticleSample> particles;
  simulation.sample(particles);
  std::vector<double> heights;
  for (const ParticleSample& p : particles) heights.push_back(p.z - floor_m);
  std::sort(heights.begin(), heights.end(), std::greater<>());
  double sum = 0.0;
  for (std::size_t k = 0; k < count; ++k) sum += heights[k];
  return sum / double(count) + simulation.scene().fluid.spacing_m / 2;
}

TEST(VesselsTest, TheLevelOfWaterAtRestIsWhereItsUpperParticlesAre) {
  const auto simulation = makeSimulation(boxAt(0.02, "position_m: [0, 0, 1]"));
  for (int frame = 0; frame < 60; ++frame) simulation->advanceFrame();
  const VesselReport box = simulation->vessels().at(0);
  EXPECT_NEAR(box.water_m3, 0.008, 1e-9);
  EXPECT_NEAR(box.level_m, 0.2, 0.002);
  EXPECT_NEAR(box.level_m, surface_m(*simulation, 1.0, 100), 0.01);
}

/// The level is that above the vessel, so it does not change when the vessel moves.
TEST(VesselsTest, TheLevelOfATiltedBoxIsWhereItsUpperParticlesComeToRest) {
  const auto simulation = makeSimulation(boxAt(0.02, "rpy_deg: [0, 30, 0]"));
  for (int frame = 0; frame < 180; ++frame) simulation->advanceFrame();
  const VesselReport box = simulation->vessels().at(0);
  ASSERT_EQ(box.particles, 1000U) << "nothing spilled";
  const double floor_m = -0.1 * std::sin(M_PI / 6);  // its lowest corner
  EXPECT_NEAR(box.level_m, surface_m(*simulation, floor_m, 60), 0.01);
  simulation->moveCollider("box", poseOf({0.02, 0, 0.01}, {0, 30, 0}));
  simulation->advanceFrame();
  EXPECT_NEAR(simulation->vessels().at(0).level_m, box.level_m, 1e-6);
}

/// A cup of water in a bath whose surface is below its rim.
const std::string kCupInBath = R"(
fluid: {spacing_m: 0.01}
containers: [{name: bath, size_m: [0.4, 0.4, 0.3]}]
cups: [{name: cup, radius_m: 0.05, depth_m: 0.15, wall_m: 0.01, position_m: [0, 0, 0.01]}]
blocks:
  - {min_m: [-0.2, -0.2, 0], max_m: [0.2, -0.07, 0.1]}
  - {min_m: [-0.2, 0.07, 0], max_m: [0.2, 0.2, 0.1]}
  - {min_m: [-0.03, -0.03, 0.01], max_m: [0.03, 0.03, 0.06]}
)";

TEST(VesselsTest, WaterInACupInABathCountsForTheCupOnly) {
  const std::vector<VesselReport> vessels = measured(sceneOf(kCupInBath));
  ASSERT_EQ(vessels.size(), 2U);
  EXPECT_EQ(vessels[0].name, "bath");
  EXPECT_EQ(vessels[1].name, "cup");
  EXPECT_EQ(vessels[0].particles, 2U * 40 * 13 * 10);
  EXPECT_EQ(vessels[1].particles, 6U * 6 * 5);
  const double displaced_m2 = M_PI * 0.06 * 0.06;
  EXPECT_NEAR(vessels[0].level_m, vessels[0].water_m3 / (0.16 - displaced_m2), 0.0007);
  EXPECT_NEAR(vessels[1].level_m, vessels[1].water_m3 / (M_PI * 0.05 * 0.05), 1e-6);
}

TEST(VesselsTest, AGaugeCountsWhatItsBoxHoldsWhateverElseDoes) {
  Scene scene = sceneOf(kCupInBath + R"(
gauges:
  - {name: all, size_m: [1, 1, 1]}
  - {name: corner, position_m: [-0.15, -0.15, 0.05], size_m: [0.1, 0.1, 0.1]}
  - {name: inside, position_m: [0, 0, 0.025], size_m: [0.1, 0.1, 0.05], frame: cup}
  - {name: turned, position_m: [-0.15, -0.15, 0.05], size_m: [0.02, 0.1, 0.1], rpy_deg: [0, 0, 90]}
)");
  const std::vector<VesselReport> vessels = measured(scene);
  ASSERT_EQ(vessels.size(), 6U);
  EXPECT_EQ(vessels[2].particles, vessels[0].particles + vessels[1].particles);
  EXPECT_EQ(vessels[3].particles, 1000U);
  EXPECT_NEAR(vessels[3].level_m, 0.1, 1e-6);
  EXPECT_EQ(vessels[4].particles, vessels[1].particles);
  EXPECT_EQ(vessels[5].particles, 200U);
}

TEST(VesselsTest, AGaugeMovesWithItsCollider) {
  Scene scene = sceneOf(kCupInBath +
                        "gauges: [{name: g, position_m: [0, 0, 0.05], size_m: "
                        "[0.09, 0.09, 0.1], frame: cup}]");
  const auto simulation = makeSimulation(scene, Precision::kFloat, 1);
  const std::size_t before = simulation->vessels()[2].particles;
  EXPECT_GT(before, 0U);
  simulation->placeColliders({{"cup", poseOf({0, 0, 5}, {0, 0, 45})}});
  const std::vector<VesselReport> moved = simulation->vessels();
  EXPECT_EQ(moved[1].particles, before);
  EXPECT_EQ(moved[2].particles, before);
}

TEST(VesselsTest, IceHasTheVolumeOfIceAndTheLevelOfItsWater) {
  const Scene scene = sceneOf(R"(
fluid: {spacing_m: 0.02}
thermal: {enabled: true}
containers: [{name: tank, size_m: [0.4, 0.4, 0.4]}]
blocks:
  - {min_m: [-0.2, -0.2, 0], max_m: [0.2, 0.2, 0.1], celsius: 10}
  - {min_m: [-0.1, -0.1, 0.12], max_m: [0.1, 0.1, 0.3], celsius: -10}
)");
  const auto simulation = makeSimulation(scene, Precision::kFloat, 1);
  const VesselReport tank = simulation->vessels().at(0);
  const double particle_m3 = 8e-6;
  const double ice = double(simulation->report().ice_particles);
  ASSERT_GT(ice, 100);
  EXPECT_NEAR(tank.water_m3, 20 * 20 * 5 * particle_m3, 1e-9);
  EXPECT_NEAR(tank.ice_m3, ice * particle_m3 / 0.917, 1e-6);
  EXPECT_NEAR(tank.level_m, (2000 + ice) * particle_m3 / 0.16, 1e-6);
  const double mean_c = (2000 * 10.0 - ice * 10.0) / (2000 + ice);
  EXPECT_NEAR(tank.mean_celsius, mean_c, 0.01);
}

TEST(VesselsTest, WithoutGravityOrWaterThereIsNoLevelAndNoTemperature) {
  Scene scene = boxAt(0.04, "position_m: [0, 0, 0]");
  scene.gravity_m_s2.setZero();
  EXPECT_TRUE(std::isnan(measured(scene).at(0).level_m));
  scene = sceneOf("thermal: {enabled: true}\ncups: [{}]");
  const VesselReport cup = measured(scene).at(0);
  EXPECT_EQ(cup.name, "cup_0");
  EXPECT_EQ(cup.level_m, 0.0);
  EXPECT_TRUE(std::isnan(cup.mean_celsius));
  EXPECT_TRUE(measured(test::floatingCube(3)).empty());
}

TEST(VesselsTest, GaugesThatCannotBeAreRefused) {
  const auto refusal = [](const std::string& gauges) {
    return test::refusalOf([&] { sceneOf("cups: [{name: cup}]\ngauges: " + gauges); });
  };
  EXPECT_NE(refusal("[{name: a, frame: cap}]")
                .find("gauges.0.frame = cap is no collider of the "
                      "scene; did you mean cup?"),
            std::string::npos);
  EXPECT_NE(refusal("[{name: cup}]").find("gauges.0.name = cup is the name of another"),
            std::string::npos);
  EXPECT_NE(refusal("[{name: a}, {name: a}]").find("gauges.1.name = a"), std::string::npos);
  EXPECT_NE(refusal("[{name: a b}]").find("gauges.0.name = \"a b\""), std::string::npos);
  EXPECT_NE(refusal("[{size: 1}]").find("did you mean gauges.0.size_m"), std::string::npos);
  EXPECT_NE(refusal("[{size_m: [0, 1, 1]}]").find("gauges.0.size_m.0 = 0"), std::string::npos);
  std::string many = "[{}";
  for (std::size_t k = 0; k < kMaxGauges; ++k) many += ", {}";
  EXPECT_NE(refusal(many + "]").find("gauges has 51 entries; at most 50"), std::string::npos);
  EXPECT_EQ(sceneOf("gauges: [{}, {}]").gauges[1].name, "gauge_1");
}

}  // namespace vessels_test
}  // namespace ice_ice_baby
