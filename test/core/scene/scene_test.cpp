// Presets, poses, lattices, and checks that concern more than one key.
#include "ice_ice_baby/scene.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "fixtures.h"
#include "ice_ice_baby/simulation.h"
#include "particles/kernels.h"
#include "particles/particles.h"
#include "scene/lattice.h"
#include "spawn/spawn_particles.h"

namespace ice_ice_baby {
namespace scene_test {

std::string refusal(const Scene& scene) {
  return test::refusalOf([&] { makeSimulation(scene); });
}

TEST(PaperPresetTest, HasThePapersConstantsAtItsOwnSpacing) {
  Scene scene;
  applyPreset(scene, Preset::kPaper, 0.0211);
  const double h = scene.supportRadius_m();
  EXPECT_EQ(h, 0.03);
  EXPECT_EQ(scene.fluid.rest_density_kg_m3, 45000.0);
  EXPECT_EQ(scene.fluid.particle_mass_kg, 1.0);
  EXPECT_DOUBLE_EQ(scene.solver.epsilon / (h * h), 0.1);
  EXPECT_FALSE(scene.fluid.self_density);
  EXPECT_FALSE(scene.fluid.boundary_density);
  EXPECT_EQ(scene.fluid.kernel, KernelPair::kPoly6Spiky);
  EXPECT_EQ(scene.solver.relaxation, 1.0);
  EXPECT_EQ(scene.preset, Preset::kPaper);
}

TEST(PaperPresetTest, ScalesWithTheSpacing) {
  Scene own, other;
  applyPreset(own, Preset::kPaper, 0.0211);
  applyPreset(other, Preset::kPaper, 0.0422);
  EXPECT_DOUBLE_EQ(other.supportRadius_m(), 0.06);
  EXPECT_DOUBLE_EQ(other.fluid.particle_mass_kg, 8.0);
  EXPECT_EQ(other.solver.epsilon, own.solver.epsilon);
  const auto relative = [](const Scene& s, double d) {
    const Poly6<double> kernel(s.supportRadius_m());
    return s.fluid.particle_mass_kg * latticeSum(kernel, d, false) / s.fluid.rest_density_kg_m3;
  };
  EXPECT_NEAR(relative(own, 0.0211), relative(other, 0.0422), 1e-12);
  EXPECT_NEAR(relative(own, 0.0211), 1.0, 0.01) << "0.0211 m is where the paper's water rests";
}

TEST(PresetTest, DefaultChangesNothing) {
  Scene plain, preset;
  applyPreset(preset, Preset::kDefault, 0.1);
  EXPECT_EQ(preset.supportRadius_m(), plain.supportRadius_m());
  EXPECT_EQ(preset.solver.substeps, plain.solver.substeps);
}

TEST(ColliderPoseTest, TurnsAboutXThenYThenZ) {
  Collider collider;
  collider.position_m = {1, 2, 3};
  collider.rpy_deg = {90, 0, 90};
  const Vec3d turned = collider.pose().toWorld({0, 1, 0});
  EXPECT_LT((turned - Vec3d(1, 2, 4)).norm(), 1e-12);
  EXPECT_LT((collider.pose().toLocal(turned) - Vec3d(0, 1, 0)).norm(), 1e-12);
  collider.rpy_deg = {0, 90, 90};
  EXPECT_LT((collider.pose().toWorld({1, 0, 0}) - Vec3d(1, 2, 2)).norm(), 1e-12);
}

TEST(LatticeSizeTest, CountsWholeSpacingsAndToleratesRounding) {
  const auto count = [](const Vec3d& extent, double d, bool sheet = false) {
    Block block = test::blockOf({0.1, 0.1, 0.1}, Vec3d(0.1, 0.1, 0.1) + extent);
    block.sheet = sheet;
    return latticeSize(block, d).prod();
  };
  EXPECT_EQ(count({0.3, 0.3, 0.3}, 0.1), 27);
  EXPECT_EQ(count({0.39, 0.3, 0.3}, 0.1), 27);
  EXPECT_EQ(count({0.29, 0.3, 0.3}, 0.1), 18);
  EXPECT_EQ(count({0.3, 0.3, 0.09}, 0.1), 0);
  EXPECT_EQ(count({-0.3, 0.3, 0.3}, 0.1), 0);
  EXPECT_EQ(count({0.5, 0.4, 0.1}, 0.1, true), 20);
  EXPECT_EQ(count({0.05, 0.4, 0.5}, 0.1, true), 20);
}

Scene sceneOf(BlockShape shape, const Vec3d& low, const Vec3d& high) {
  Scene scene;
  scene.fluid.spacing_m = 0.1;
  scene.blocks.push_back(test::blockOf(low, high));
  scene.blocks[0].shape = shape;
  return scene;
}

TEST(BlockShapeTest, HoldsExactlyTheLatticePointsInside) {
  for (const BlockShape shape : {BlockShape::kBox, BlockShape::kSphere, BlockShape::kCylinder}) {
    for (const Vec3d& high : {Vec3d(1, 1, 1), Vec3d(0.7, 1.3, 0.4), Vec3d(0.55, 0.95, 1.04)}) {
      const Scene scene = sceneOf(shape, Vec3d::Zero(), high);
      std::int64_t inside = 0;
      for (const Vec3d& point : test::lattice(14, 0.1)) {
        const Eigen::Array3d q = (2 * point - high).array() / high.array();
        const double radius2 =
            shape == BlockShape::kSphere ? q.square().sum() : q.head(2).square().sum();
        const bool in_box = ((point + Vec3d::Constant(0.05) - high).array() < 1e-6).all();
        if (in_box && (shape == BlockShape::kBox || radius2 < 1 + 1e-9)) ++inside;
      }
      EXPECT_EQ(particleCount(scene), inside) << high.transpose();
      std::vector<Spawn> spawns;
      EXPECT_EQ(spawnParticles<double>(scene, spawns).size(), std::size_t(inside));
      EXPECT_EQ(spawns[0].count, inside);
    }
  }
}

TEST(BlockShapeTest, FillsTheVolumeOfABallAndOfACylinder) {
  Scene scene = sceneOf(BlockShape::kSphere, Vec3d::Constant(-2), Vec3d::Constant(2));
  EXPECT_NEAR(double(particleCount(scene)), 4.0 / 3.0 * M_PI * 8000, 300);
  scene.blocks[0].shape = BlockShape::kCylinder;
  EXPECT_NEAR(double(particleCount(scene)), M_PI * 400 * 40, 500);
}

TEST(BlockShapeTest, IsTheSameOnBothSidesOfItsCentre) {
  const Scene scene = sceneOf(BlockShape::kSphere, {-0.6, -0.6, 0.4}, {0.6, 0.6, 1.6});
  std::vector<Spawn> spawns;
  const auto particles = spawnParticles<double>(scene, spawns);
  const Vec3d mean = test::sumOf(particles.position) / double(particles.size());
  EXPECT_LT((mean - Vec3d(0, 0, 1)).norm(), 1e-12);
}

TEST(BlockPoseTest, TurnsTheBlockWithItsLatticeAboutItsCentre) {
  const Scene upright = sceneOf(BlockShape::kCylinder, {1, 1, 1}, {2, 3, 1.5});
  Scene lying = upright;
  lying.blocks[0].rpy_deg = {0, 90, 0};
  lying.blocks[0].angular_velocity_rad_s = {0, 0, 1};
  std::vector<Spawn> spawns;
  const auto before = spawnParticles<double>(upright, spawns);
  const auto after = spawnParticles<double>(lying, spawns);
  ASSERT_EQ(before.size(), after.size());
  const Vec3d centre(1.5, 2, 1.25);
  for (std::size_t i = 0; i < before.size(); ++i) {
    const Vec3d arm = before.position.at(i) - centre;
    EXPECT_LT((after.position.at(i) - centre - Vec3d(arm.z(), arm.y(), -arm.x())).norm(), 1e-12);
    EXPECT_LT((after.velocity.at(i) - Vec3d(-arm.y(), arm.z(), 0)).norm(), 1e-12)
        << "spin is about the axes of the scene";
  }
}

TEST(BlockVelocityTest, IsLinearAboutTheCentreAndSpins) {
  Scene scene = sceneOf(BlockShape::kBox, {1, 1, 1}, {2, 2, 2});
  Block& block = scene.blocks[0];
  block.velocity_m_s = {1, 2, 3};
  EXPECT_EQ(block.velocityAt({1.3, 7, 2}), Vec3d(1, 2, 3));
  block.velocity_gradient_1_s << 4, 5, 0, 0, -4, 0, 6, 0, 0;
  EXPECT_LT((block.velocityAt({2.5, 3.5, 0}) - Vec3d(1 + 4 + 10, 2 - 8, 3 + 6)).norm(), 1e-12);
  block.velocity_gradient_1_s.setZero();
  block.angular_velocity_rad_s = {0, 0, 2};
  EXPECT_LT((block.velocityAt({2.5, 1.5, 0}) - Vec3d(1, 4, 3)).norm(), 1e-12);
  std::vector<Spawn> spawns;
  const auto particles = spawnParticles<double>(scene, spawns);
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const Vec3d expected = block.velocityAt(particles.position.at(i));
    EXPECT_LT((particles.velocity.at(i) - expected).norm(), 1e-12);
  }
}

TEST(ValidateTest, RefusesASceneBuiltInCodeByTheKeyThatIsWrong) {
  struct Case {
    std::function<void(Scene&)> change;
    const char* words;
  };
  const Case cases[] = {
      {[](Scene& s) { s.solver.substeps = -1; }, "solver.substeps = -1"},
      {[](Scene& s) { s.gravity_m_s2.y() = std::nan(""); }, "gravity_m_s2"},
      {[](Scene& s) { s.blocks[0].velocity_m_s.x() = 1e9; }, "blocks.0.velocity_m_s"},
      {[](Scene& s) { s.blocks[0].max_m.x() = 1e5; }, "blocks.0.max_m"},
      {[](Scene& s) { s.fluid.support_radius_m = 0.05; }, "support_radius_m"},
      {[](Scene& s) { s.fluid.support_radius_m = 1; }, "support_radius_m"},
      {[](Scene& s) { s.temperature.freezing_c = 4; }, "freezing_c"},
      {[](Scene& s) { s.blocks[0].max_m = s.blocks[0].min_m; }, "blocks.0"},
      {[](Scene& s) {
         s.blocks[0].shape = BlockShape::kSphere;
         s.blocks[0].sheet = true;
       },
       "blocks.0: a sheet is a box"},
      {[](Scene& s) {
         s.blocks[0].shape = BlockShape::kSphere;
         s.blocks[0].max_m.z() = s.blocks[0].min_m.z() + 0.04;
       },
       "blocks.0 holds no particle"},
      {[](Scene& s) { s.blocks[0].velocity_gradient_1_s(1, 2) = 1e4; },
       "blocks.0.velocity_gradient_1_s"},
      {[](Scene& s) { s.limits.max_particles = 100; }, "limits.max_particles"},
      {[](Scene& s) {
         s.fluid.spacing_m = 1e-4;
         s.blocks[0].max_m = {100, 100, 100};
       },
       "limits.max_particles"},
      {[](Scene& s) { s.fluid.particle_mass_kg = 1; }, "lone particle"},
  };
  for (const Case& c : cases) {
    Scene scene = test::floatingCube(5);
    ASSERT_EQ(refusal(scene), "");
    c.change(scene);
    EXPECT_NE(refusal(scene).find(c.words), std::string::npos) << refusal(scene);
  }
}

TEST(ValidateTest, PaperConstantsWithTheSelfTermAreRefused) {
  Scene scene;
  applyPreset(scene, Preset::kPaper, 0.0211);
  EXPECT_EQ(refusal(scene), "");
  scene.fluid.self_density = true;
  EXPECT_NE(refusal(scene).find("lone particle"), std::string::npos);
}

}  // namespace scene_test
}  // namespace ice_ice_baby
