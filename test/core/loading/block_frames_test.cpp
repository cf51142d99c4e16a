// Blocks given in the frame of a collider: the same water as beside an upright one, moved along.
#include <gtest/gtest.h>

#include "fixtures.h"
#include "ice_ice_baby/errors.h"
#include "ice_ice_baby/scene_loader.h"
#include "ice_ice_baby/simulation.h"
#include "scene/lattice.h"

namespace ice_ice_baby {
namespace block_frames_test {

std::string numbers(const Vec3d& v) {
  return "[" + std::to_string(v.x()) + ", " + std::to_string(v.y()) + ", " + std::to_string(v.z()) +
         "]";
}

Scene cupAt(const Vec3d& place, const Vec3d& rpy_deg, const std::string& frame) {
  return parseScene("fluid: {spacing_m: 0.01}\ncups: [{name: cup, position_m: " + numbers(place) +
                    ", rpy_deg: " + numbers(rpy_deg) +
                    "}]\nblocks: [{min_m: [-0.02, -0.03, 0.01], max_m: [0.02, 0.03, 0.05], "
                    "rpy_deg: [10, 20, 30], velocity_m_s: [1, 2, 3], angular_velocity_rad_s: "
                    "[0, 1, 0], velocity_gradient_1_s: [[1, 0, 0], [0, -1, 0], [0, 2, 0]], copies: "
                    "[1, 1, 2], copies_step_m: [0, 0, 0.2], frame: " +
                    frame + "}]");
}

std::vector<Vec3d> pointsOf(const Scene& scene) {
  std::vector<Vec3d> points;
  for (const Block& block : scene.blocks) {
    forEachLatticePoint(block, 0.01, [&](const Vec3d& x) { points.push_back(x); });
  }
  return points;
}

TEST(BlockFramesTest, WaterStartsWhereItsColliderBegins) {
  const Scene upright = cupAt({0, 0, 0}, {0, 0, 0}, "\"\"");
  const std::vector<Vec3d> expected = pointsOf(upright);
  ASSERT_EQ(expected.size(), 2u * 4 * 6 * 4);
  test::Random random(17);
  std::vector<Vec3d> turns = {{0, 0, 0}, {0, 90, 0}, {30, -90, 40}, {180, 0, 0}};
  for (int k = 0; k < 50; ++k)
    turns.push_back(random.inBox(Vec3d(-180, -180, -180), Vec3d(180, 180, 180)));
  for (const Vec3d& rpy_deg : turns) {
    SCOPED_TRACE(rpy_deg.transpose());
    const Vec3d place = random.inBox({-9, -9, -9}, {9, 9, 9});
    const Scene scene = cupAt(place, rpy_deg, "cup");
    const Posed cup = poseOf(scene.cups[0].position_m, scene.cups[0].rpy_deg);
    const std::vector<Vec3d> points = pointsOf(scene);
    ASSERT_EQ(points.size(), expected.size());
    for (std::size_t k = 0; k < points.size(); ++k) {
      ASSERT_LT((points[k] - cup.toWorld(expected[k])).norm(), 1e-9) << k;
      const Block &block = scene.blocks[k / 96], &before = upright.blocks[k / 96];
      const Vec3d velocity = cup.rotation * before.velocityAt(expected[k]);
      ASSERT_LT((block.velocityAt(points[k]) - velocity).norm(), 1e-9) << k;
    }
    EXPECT_EQ(scene.blocks[0].frame, "");
  }
}

TEST(BlockFramesTest, AFrameThatIsNoColliderIsRefusedWithThoseThatAre) {
  try {
    cupAt({0, 0, 0}, {0, 0, 0}, "mug");
    FAIL();
  } catch (const InvalidInput& e) {
    const std::string why = e.what();
    EXPECT_NE(why.find("blocks.0.frame = mug is no collider of the scene; there are: cup"),
              std::string::npos)
        << why;
  }
}

TEST(BlockFramesTest, ABlockFarOutIsRefused) {
  EXPECT_THROW(cupAt({99.99, 0, 0}, {0, 0, 0}, "cup"), InvalidInput);
}

TEST(BlockFramesTest, ASceneOfCodeIsPlacedByCompleteScene) {
  Scene scene = cupAt({1, 0, 0}, {0, 0, 0}, "\"\"");
  scene.blocks[0].frame = "cup";
  const Vec3d before = scene.blocks[0].min_m;
  EXPECT_THROW(makeSimulation(scene, Precision::kFloat, 1), InvalidInput);
  scene.blocks.pop_back();
  completeScene(scene);
  EXPECT_LT((scene.blocks[0].min_m - before - Vec3d(1, 0, 0)).norm(), 1e-12);
}

}  // namespace block_frames_test
}  // namespace ice_ice_baby
