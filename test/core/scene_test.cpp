// What a scene means: presets, poses, lattices and the checks that no single key can make.
#include "ice_ice_baby/scene.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "fixtures.h"
#include "ice_ice_baby/errors.h"
#include "ice_ice_baby/kernels.h"
#include "ice_ice_baby/simulation.h"

namespace ice_ice_baby {
namespace {

std::string refusal(const Scene& scene) {
  try {
    makeSimulation(scene);
  } catch (const InvalidInput& e) {
    return e.what();
  }
  return "";
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
  EXPECT_FALSE(scene.fluid.wall_density);
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

TEST(LatticeSizeTest, CountsWholeSpacingsAndForgivesRounding) {
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

TEST(ValidateTest, NamesWhatCannotBe) {
  struct Case {
    std::function<void(Scene&)> change;
    const char* words;
  };
  const Case cases[] = {
      {[](Scene& s) { s.fluid.support_radius_m = 0.05; }, "support_radius_m"},
      {[](Scene& s) { s.fluid.support_radius_m = 1; }, "support_radius_m"},
      {[](Scene& s) { s.temperature.freezing_c = 4; }, "freezing_c"},
      {[](Scene& s) { s.blocks[0].max_m = s.blocks[0].min_m; }, "blocks.0"},
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

TEST(ValidateTest, PaperConstantsWithTheSelfTermCannotBeAFluid) {
  Scene scene;
  applyPreset(scene, Preset::kPaper, 0.0211);
  EXPECT_EQ(refusal(scene), "");
  scene.fluid.self_density = true;
  EXPECT_NE(refusal(scene).find("lone particle"), std::string::npos);
}

}  // namespace
}  // namespace ice_ice_baby
