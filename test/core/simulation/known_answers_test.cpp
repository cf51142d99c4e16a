// Scenes of config/scenes/verification in double precision, which the reports of run_scene lack.
#include <gtest/gtest.h>

#include <algorithm>

#include "fixtures.h"
#include "ice_ice_baby/scene_loader.h"
#include "simulation/simulator.h"

namespace ice_ice_baby {
namespace known_answers_test {

Scene known(const std::string& name) {
  return loadScene(std::string(IIB_CONFIG) + "/scenes/verification/" + name + ".yaml");
}

TEST(KnownAnswersTest, ACollisionExchangesMomentumAndGainsNone) {
  Simulator<double> simulation(known("collision"), 1);
  const Vec3d before = test::sumOf(simulation.particles().velocity);
  const double exchanged = test::sumOfNorms(simulation.particles().velocity);
  double densest = 0.0;
  for (int frame = 0; frame < 30; ++frame) {
    densest = std::max(densest, simulation.advanceFrame().density_error_max);
    const Vec3d now = test::sumOf(simulation.particles().velocity);
    ASSERT_LT((now - before).norm(), 1e-12 * exchanged) << "frame " << frame;
  }
  EXPECT_GT(densest, 1e-3) << "they must meet";
}

TEST(KnownAnswersTest, NothingHoldsASpinningDiskTogether) {
  const Scene scene = known("spinning_disk");
  Simulator<double> simulation(scene, 1);
  std::vector<Vec3d> start(simulation.particles().size()), velocity(start.size());
  const auto& particles = simulation.particles();
  for (std::size_t i = 0; i < start.size(); ++i) {
    start[particles.id[i]] = particles.position.at(i);
    velocity[particles.id[i]] = particles.velocity.at(i);
  }
  for (int frame = 0; frame < 60; ++frame) simulation.advanceFrame();
  for (std::size_t i = 0; i < start.size(); ++i) {
    const std::uint32_t id = particles.id[i];
    EXPECT_LT((particles.position.at(i) - start[id] - velocity[id]).norm(), 1e-11);
  }
}

}  // namespace known_answers_test
}  // namespace ice_ice_baby
