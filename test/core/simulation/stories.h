// Scenes with commands during the run; together they cover every part of the state.
#pragma once

#include <functional>
#include <ostream>

#include "base/archive.h"
#include "fixtures.h"
#include "ice_ice_baby/simulation.h"

namespace ice_ice_baby::test {

/// A scene and the commands given before each frame.
struct Story {
  std::string name;
  Scene scene;
  std::function<void(Simulation&, int frame)> act = [](Simulation&, int) {};
  int frames = 40;

  friend std::ostream& operator<<(std::ostream& out, const Story& story) {
    return out << story.name;
  }
};

inline Scene heated(double spacing_m) {
  Scene scene;
  scene.fluid.spacing_m = spacing_m;
  scene.thermal.enabled = true;
  return scene;
}

inline Scene freezingSplash(Preset preset) {
  Scene scene;
  applyPreset(scene, preset, 0.05);
  scene.fluid.spacing_m = 0.05;
  scene.blocks = splash().blocks;
  scene.containers = splash().containers;
  scene.schedule = {{0.15, -10, 0.2}, {0.5, 20, 0.1}};
  return scene;
}

inline Story sheetStory() {
  Scene scene = splash();
  scene.blocks[0] = blockOf({-0.3, -0.2, 0.4}, {0.3, 0.2, 0.45});
  scene.blocks[0].sheet = true;
  scene.blocks[0].rpy_deg.y() = 20;
  return {"sheet", scene};
}

/// The tank turns and rises in every frame, so each checkpoint holds a move still to be made.
inline Story movedStory() {
  const auto move = [](Simulation& simulation, int frame) {
    const double s = 0.01 * frame;
    simulation.moveCollider("tank", poseOf({s, 0, s / 2}, {5 * s, 30 * s, 0}));
    if (frame == 12) simulation.setGravity({1, 2, -8});
  };
  return {"moved_tank", splash(), move};
}

inline Story targetStory() {
  Scene scene = splash();
  scene.solver.target_error = 0.003;
  return {"target_error", scene};
}

inline Story plainFlightStory() {
  Scene scene = splash();
  scene.solver.iterations = 0;
  return {"no_iterations", scene};
}

/// Water that boils on a hot floor, under a torch, with a block of ice that falls into it; the
/// number of substeps varies.
inline Story kettleStory(double compliance_m_n) {
  Scene scene = heated(0.02);
  scene.thermal.speedup = 2000.0;
  scene.ice.compliance_m_n = compliance_m_n;
  scene.solver.target_error = 0.002;
  scene.blocks = {blockOf({-0.06, -0.06, 0.0}, {0.06, 0.06, 0.08}),
                  blockOf({-0.05, -0.05, 0.1}, {0.05, 0.05, 0.16})};
  scene.blocks[0].celsius = 99.0;
  scene.blocks[1].celsius = -10.0;
  scene.containers = {tankOf({0.12, 0.12, 0.4}, false, "pot")};
  scene.planes.emplace_back();
  scene.planes[0].name = "floor";
  const auto act = [](Simulation& simulation, int frame) {
    if (frame == 5) simulation.setTemperature(300.0, 0.5, "pot");
    if (frame == 8) simulation.setTemperature(-5.0, 0.4);
    if (frame != 3 && frame != 15) return;
    HeatedRegion torch;
    torch.size_m = Vec3d::Constant(0.1);
    torch.power_w = frame == 3 ? 2000.0 : -3000.0;
    torch.duration_s = 0.35;
    simulation.heatRegion(torch);
  };
  return {compliance_m_n > 0 ? "elastic_ice" : "kettle", scene, act, 60};
}

/// Balls of ice that fall on a plate and on each other; some are asleep when the plate melts them
/// from below and rises.
inline Story hailStory() {
  Scene scene = heated(0.02);
  scene.thermal.speedup = 4000.0;
  scene.thermal.air_heat_transfer_w_m2k = 0.0;
  scene.solver.target_error = 0.002;
  scene.planes.emplace_back();
  scene.planes[0].name = "plate";
  for (int k = 0; k < 6; ++k) {
    Block ball = blockOf({-0.05, -0.05, 0.001 + 0.11 * k}, {0.05, 0.05, 0.101 + 0.11 * k});
    ball.shape = BlockShape::kSphere;
    ball.celsius = -20.0;
    if (k > 0) ball.min_m.x() += 0.02, ball.max_m.x() += 0.02;
    scene.blocks.push_back(ball);
  }
  scene.blocks.push_back(blockOf({0.3, 0.3, 0.001}, {0.4, 0.4, 0.041}));
  scene.blocks.back().celsius = -20.0;
  const auto act = [](Simulation& simulation, int frame) {
    if (frame == 36) simulation.setTemperature(300.0, 0.1, "plate");
    if (frame >= 55)
      simulation.moveCollider("plate", poseOf({0, 0, 0.004 * (frame - 54)}, {0, 0, 0}));
  };
  return {"hail", scene, act, 70};
}

/// Water that freezes to the walls of a cold tank and is carried along by it.
inline Story coldTankStory() {
  Scene scene = heated(0.02);
  scene.thermal.speedup = 5000.0;
  scene.blocks = {blockOf({-0.08, -0.08, 0.0}, {0.08, 0.08, 0.08})};
  scene.blocks[0].celsius = 0.5;
  scene.containers = {tankOf({0.16, 0.16, 0.3}, true)};
  scene.containers[0].heat = ThermalBoundary::kTemperature;
  scene.containers[0].celsius = -150.0;
  const auto act = [](Simulation& simulation, int frame) {
    if (frame < 46) return;
    simulation.moveCollider("tank", poseOf({0.002 * (frame - 45), 0, 0}, {0, 0, 0}));
  };
  return {"cold_tank", scene, act, 60};
}

/// A tank with water and ice that jumps to another place and rotation; then a ball jumps into the
/// water.
inline Story jumpStory() {
  Scene scene = heated(0.04);
  scene.blocks = {blockOf({-0.3, -0.2, 0.0}, {0.3, 0.2, 0.16}),
                  blockOf({-0.2, -0.1, 0.24}, {0.0, 0.1, 0.4})};
  scene.blocks[1].celsius = -10.0;
  scene.containers = {tankOf({0.6, 0.4, 0.6}, false)};
  scene.spheres.emplace_back();
  scene.spheres[0].name = "ball";
  scene.spheres[0].position_m = {0, 0, 3};
  scene.spheres[0].radius_m = 0.08;
  const auto act = [](Simulation& simulation, int frame) {
    if (frame == 9) simulation.moveCollider("tank", poseOf({3, 1, -2}, {0, 10, 90}));
    if (frame == 20) simulation.moveCollider("ball", poseOf({3, 1.1, -1.9}, Vec3d::Zero()));
  };
  return {"jumps", scene, act, 32};
}

/// Three rows of bricks of ice in free space. The first brick of each hits the next, and so on,
/// fast enough to pass through each other within a substep.
inline Story fastIceStory() {
  Scene scene = heated(0.04);
  scene.gravity_m_s2.setZero();
  scene.solver.substeps = 1;
  for (int row = 0; row < 3; ++row) {
    double x = 0.0;
    for (int k = 0; k < 6; ++k) {
      Block brick = blockOf({x, 0.5 * row, 0.0}, {x + 0.08, 0.5 * row + 0.12, 0.12});
      brick.celsius = -20.0;
      if (k == 0) brick.velocity_m_s.x() = 28.0 - 3.0 * row;
      scene.blocks.push_back(brick);
      x += 0.5 + 0.1 * row;
    }
  }
  return {"fast_ice", scene, [](Simulation&, int) {}, 36};
}

inline std::vector<Story> stories() {
  return {{"water", splash()},
          {"freezing", freezingSplash(Preset::kDefault)},
          {"freezing_paper", freezingSplash(Preset::kPaper)},
          sheetStory(),
          movedStory(),
          targetStory(),
          plainFlightStory(),
          kettleStory(0.0),
          kettleStory(1e-6),
          hailStory(),
          coldTankStory(),
          jumpStory(),
          fastIceStory()};
}

/// Bytes that Simulation::write writes after the scene and the number of particles.
inline std::string stateOf(const Simulation& simulation) {
  StateWriter all, count;
  simulation.write(all);
  count(std::uint64_t(simulation.report().particles));
  return all.bytes().substr(all.bytes().find(count.bytes() + count.bytes()) + count.bytes().size());
}

}  // namespace ice_ice_baby::test
