// Freezes a cup of water, without ROS, and prints how much of it is ice.
#include <ice_ice_baby/scene_loader.h>
#include <ice_ice_baby/simulation.h>

#include <cstdio>

int main() {
  const ice_ice_baby::Scene scene = ice_ice_baby::parseScene(R"(
    fluid: {spacing_m: 0.01}
    thermal: {enabled: true, speedup: 500}
    blocks: [{min_m: [-0.04, -0.04, 0], max_m: [0.04, 0.04, 0.08], celsius: 5}]
    containers: [{name: cup, size_m: [0.08, 0.08, 0.1], heat: temperature, celsius: -30}]
  )");
  const auto simulation = ice_ice_baby::makeSimulation(scene);
  const ice_ice_baby::StepReport& report = simulation->report();
  while (report.strictness < 0.9 && report.time_s < 10.0) {
    simulation->advanceFrame();
    if (report.frame % 10 == 0) {
      std::printf("%.2f s: %.0f %% ice\n", report.time_s, 100 * report.strictness);
    }
  }
}
