// Heat regions of a scene: how much heat they give, to which particles, and when.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "fixtures.h"
#include "ice_ice_baby/checkpoint.h"
#include "ice_ice_baby/errors.h"
#include "ice_ice_baby/scene_loader.h"
#include "simulation/simulator.h"

namespace ice_ice_baby {
namespace heat_regions_test {

/// Particles of 5 cm at 20 degrees in free space that exchange heat with nothing but the region.
Scene torched(int nx, int n, double power_w) {
  Scene scene;
  scene.name = "torched";
  scene.fluid.spacing_m = 0.05;
  scene.gravity_m_s2.setZero();
  scene.thermal.enabled = true;
  scene.thermal.speedup = 1.0;
  scene.thermal.water_conductivity_w_mk = 0.0;
  scene.thermal.air_heat_transfer_w_m2k = 0.0;
  scene.blocks = {test::blockOf(Vec3d::Zero(), Vec3d(0.05 * nx, 0.05 * n, 0.05 * n))};
  HeatRegionParams torch;
  torch.name = "torch";
  torch.shape = BlockShape::kBox;
  torch.position_m = scene.blocks[0].centre_m();
  torch.size_m = Vec3d::Constant(4.0);
  torch.power_w = power_w;
  scene.heat_regions = {torch};
  return scene;
}

void run(Simulation& simulation, int frames) {
  for (int k = 0; k < frames; ++k) simulation.advanceFrame();
}

TEST(HeatRegions, GiveTheirPowerWhileTheyAreActive) {
  for (const double power_w : {2.0, -2000.0, 3e5}) {
    for (const double frame_rate_hz : {24.0, 60.0, 500.0}) {
      Scene scene = torched(4, 4, power_w);
      scene.solver.frame_rate_hz = frame_rate_hz;
      scene.thermal.speedup = 3.0;
      Simulator<double> simulator(scene, 1);
      const double before_j = simulator.report().enthalpy_j;
      run(simulator, 7);
      simulator.setHeatRegion("torch", false, 0.0);
      run(simulator, 2);
      simulator.setHeatRegion("torch", true, power_w / 4);
      run(simulator, 5);
      simulator.setHeatRegion("torch", false, 0.0);
      run(simulator, static_cast<int>(0.2 * frame_rate_hz));  // past the next thermal pass
      const double due_j = 3.0 * (7 + 5 / 4.0) * power_w / frame_rate_hz;
      EXPECT_NEAR(simulator.report().enthalpy_j - before_j, due_j, 1e-5 * std::abs(due_j))
          << power_w << " " << frame_rate_hz;
      EXPECT_EQ(simulator.scene().heat_regions[0].power_w, power_w / 4);
    }
  }
}

/// A box turned by 45 degrees, and the ellipsoid in it, hold different particles.
TEST(HeatRegions, HeatWhatIsInThem) {
  for (const BlockShape shape : {BlockShape::kBox, BlockShape::kSphere}) {
    Scene scene = torched(8, 8, 5e3);
    HeatRegionParams& torch = scene.heat_regions[0];
    torch.shape = shape;
    torch.size_m = {0.5, 0.16, 0.3};
    torch.rpy_deg = {0, 0, 45};
    Simulator<float> simulator(scene, 1);
    run(simulator, 12);
    const auto* heat = simulator.phaseChange()->heat();
    std::size_t warmed = 0;
    for (std::size_t i = 0; i < simulator.particles().size(); ++i) {
      const Vec3d arm = simulator.particles().position.at(i).cast<double>() - torch.position_m;
      const double c = std::sqrt(0.5);
      const Vec3d local(c * (arm.x() + arm.y()), c * (arm.y() - arm.x()), arm.z());
      const Vec3d part = local.cwiseQuotient(torch.size_m / 2);
      const bool inside =
          shape == BlockShape::kBox ? part.cwiseAbs().maxCoeff() <= 1.0 : part.squaredNorm() <= 1.0;
      EXPECT_EQ(heat->temperature(i) > 20.001, inside) << part.transpose();
      warmed += inside;
    }
    EXPECT_GT(warmed, 20U);
  }
}

/// A torch that holds one particle of a row at a time gives each what it gives in the time that it
/// takes to pass, whatever its speed and whenever heat passes would be due.
TEST(HeatRegions, OneThatMovesHeatsWhatItPasses) {
  for (const double speed_m_s : {0.05, 0.3, 1.0}) {
    Scene scene = torched(12, 1, 40.0);
    HeatRegionParams& torch = scene.heat_regions[0];
    torch.size_m = {0.05, 0.1, 0.1};
    torch.follow_frame = "tool";
    Simulator<double> simulator(scene, 1);
    run(simulator, 3);
    EXPECT_EQ(simulator.report().mean_celsius, 20.0) << "it heats nothing before it has a place";
    const double before_j = simulator.report().enthalpy_j;
    Posed pose = torch.pose();
    const int frames = static_cast<int>(0.7 / speed_m_s * 60);
    for (int k = 0; k < frames; ++k) {
      pose.position.x() = -0.05 + speed_m_s * (k + 1) / 60;
      simulator.moveHeatRegion("torch", pose);
      simulator.advanceFrame();
    }
    EXPECT_EQ(simulator.heatRegionPose("torch").position, pose.position);
    const double each_j = 40.0 * 0.05 / speed_m_s, frame_j = 40.0 / 60;
    EXPECT_NEAR(simulator.report().enthalpy_j - before_j, 12 * each_j, frame_j * 1.01);
    const auto* heat = simulator.phaseChange()->heat();
    const double kelvin = each_j / (0.05 * 0.05 * 0.05 * 1000 * 4186);
    for (std::size_t i = 0; i < 12; ++i) {
      EXPECT_NEAR(heat->temperature(i) - 20.0, kelvin, 1.01 * kelvin * frame_j / each_j);
    }
  }
}

TEST(HeatRegions, ASprayFreezesAndATorchMelts) {
  const double power_w = 2.5e6;  // for 3.4 kg
  Scene scene = torched(3, 3, -power_w);
  Simulator<float> simulator(scene, 1);
  run(simulator, 60);
  EXPECT_EQ(simulator.report().ice_particles, 27U);
  simulator.setHeatRegion("torch", true, power_w);
  run(simulator, 60);
  EXPECT_EQ(simulator.report().ice_particles, 0U);
}

TEST(HeatRegions, ACheckpointAndAnyNumberOfThreadsGoOnWithTheSameBits) {
  Scene scene = torched(6, 6, 2e4);
  scene.gravity_m_s2.z() = -9.81;
  scene.containers = {test::tankOf({0.6, 0.6, 1.0}, true)};
  scene.heat_regions[0].size_m.setConstant(0.2);
  scene.heat_regions[0].follow_frame = "tool";
  scene.blocks[0].carve = true;
  const auto act = [](Simulation& simulation) {
    const double s = double(simulation.report().frame);
    if (s > 3) simulation.moveHeatRegion("torch", poseOf({0.01 * s, 0, 0.2}, {s, 0, 5 * s}));
    if (s == 11) simulation.setHeatRegion("torch", false, 0.0);
    if (s == 13) simulation.setHeatRegion("torch", true, -3e4);
    simulation.advanceFrame();
  };
  std::vector<std::unique_ptr<Simulation>> all;
  for (const int threads : {1, 2, 4}) {
    all.push_back(makeSimulation(scene, Precision::kFloat, threads));
  }
  for (int frame = 0; frame < 30; ++frame) {
    if (frame == 2 || frame == 12 || frame == 19) {
      all.push_back(decodeCheckpoint(encodeCheckpoint(*all[0]), "memory", 1));
    }
    for (const auto& one : all) act(*one);
  }
  for (const auto& one : all) EXPECT_EQ(one->stateHash(), all[0]->stateHash());
}

TEST(HeatRegions, ASceneWithoutThemHasNoMemoryForThem) {
  Scene scene = torched(3, 3, 1.0);
  const auto heatBytes = [](const Scene& one) {
    const auto simulation = makeSimulation(one, Precision::kFloat, 1);
    for (const StageStats& stage : simulation->stages()) {
      if (stage.name == "heat") return stage.bytes;
    }
    return std::size_t(0);
  };
  const std::size_t with = heatBytes(scene);
  scene.heat_regions.clear();
  const std::size_t without = heatBytes(scene);
  EXPECT_GT(without, 0U);
  EXPECT_GT(with, without);
  EXPECT_EQ(Simulator<float>(scene, 1).phaseChange()->heat()->sceneRegions(), nullptr);
}

std::string refusalOfScene(const std::string& region, const std::string& more) {
  return test::refusalOf(
      [&] { parseScene("heat_regions: [" + region + "]\n" + more, {}, "scene"); });
}

TEST(HeatRegions, AreRefusedWithTheKeyTheValueAndTheCure) {
  const std::string heat = "thermal: {enabled: true}";
  EXPECT_EQ(refusalOfScene("{power_w: 5}", heat), "");
  EXPECT_EQ(parseScene("heat_regions: [{power_w: 5}]\n" + heat).heat_regions[0].name,
            "heat_region_0");
  EXPECT_EQ(refusalOfScene("{name: gun, power_w: 5}", ""),
            "scene: heat_regions.0 (gun) needs a scene with heat; set thermal.enabled to true");
  EXPECT_EQ(refusalOfScene("{name: gun}", heat),
            "scene: heat_regions.0 (gun).power_w = 0 must be above 0 to heat, or below 0 to cool");
  EXPECT_EQ(refusalOfScene("{name: gun, power_w: 5, shape: cylinder}", heat),
            "scene: heat_regions.0 (gun).shape = cylinder must be one of: box, sphere");
  EXPECT_EQ(refusalOfScene("{name: gun, power_w: 5}, {name: gun, power_w: 5}", heat),
            "scene: two heat regions are called gun; give each its own name");
  EXPECT_NE(refusalOfScene("{name: gun, power_w: 2e9}", heat).find("[-1e+09, 1e+09]"),
            std::string::npos);
  EXPECT_NE(refusalOfScene("{name: gun, power_w: 5, follow_frame: a b}", heat)
                .find("follow_frame of heat region gun = \"a b\" must be fit for a tf frame"),
            std::string::npos);
  std::string many = "{power_w: 5}";
  for (std::size_t k = 0; k < kMaxHeatRegions; ++k) many += ", {power_w: 5}";
  EXPECT_NE(refusalOfScene(many, heat).find("number of heat_regions = 51"), std::string::npos);
}

TEST(HeatRegions, CommandsThatCannotBeChangeNothing) {
  Simulator<float> simulator(torched(2, 2, 5.0), 1);
  const std::uint64_t hash = simulator.stateHash();
  const auto refused = [&](const std::function<void()>& command) {
    const std::string why = test::refusalOf(command);
    EXPECT_EQ(simulator.stateHash(), hash);
    return why;
  };
  EXPECT_EQ(refused([&] { simulator.setHeatRegion("torc", true, 1.0); }),
            "no heat region \"torc\"; scene torched has: torch");
  EXPECT_EQ(refused([&] { simulator.setHeatRegion("torch", false, 2e9); }),
            "power of heat region torch in watts = 2e+09 is outside the allowed range [-1e+09, "
            "1e+09]");
  EXPECT_NE(refused([&] { simulator.setHeatRegion("torch", false, std::nan("")); }), "");
  EXPECT_EQ(refused([&] {
              simulator.moveHeatRegion("torch", poseOf({0, 0, 200}, Vec3d::Zero()));
            }),
            "position of heat region torch = 200 is outside the allowed range [-100, 100]");
  EXPECT_NE(refused([&] { simulator.moveHeatRegion("tap", Posed()); }), "");
  const auto cold = makeSimulation(test::splash(), Precision::kFloat, 1);
  EXPECT_NE(test::refusalOf([&] { cold->moveHeatRegion("torch", Posed()); }).find("has none"),
            std::string::npos);
  EXPECT_NE(test::refusalOf([&] { cold->heatRegionPose("torch"); }), "");
}

}  // namespace heat_regions_test
}  // namespace ice_ice_baby
