// Scene of water that boils and condenses, and of ice that falls into it.
#pragma once

#include "fixtures.h"

namespace ice_ice_baby::test {

/// A closed kettle a third full: hot floor, cold lid.
inline Scene kettle() {
  Scene scene;
  scene.fluid.spacing_m = 0.02;
  scene.thermal.enabled = true;
  scene.thermal.speedup = 2000.0;
  scene.thermal.air_heat_transfer_w_m2k = 0.0;
  scene.temperature.initial_c = 100.0;
  Block water;
  water.min_m = Vec3d(-0.06, -0.06, 0.0);
  water.max_m = Vec3d(0.06, 0.06, 0.1);
  water.celsius = 98.0;
  scene.blocks = {water};
  Container pot;
  pot.name = "pot";
  pot.size_m = Vec3d(0.12, 0.12, 0.4);
  pot.open_top = false;
  scene.containers = {pot};
  Plane floor;
  floor.name = "floor";
  floor.size_x_m = floor.size_y_m = 0.12;
  floor.heat = ThermalBoundary::kTemperature;
  floor.celsius = 160.0;
  Plane lid = floor;
  lid.name = "lid";
  lid.position_m.z() = 0.4;
  lid.rpy_deg.x() = 180.0;
  lid.celsius = 10.0;
  scene.planes = {floor, lid};
  return scene;
}

/// The kettle with a block of ice that falls into it.
inline Scene iceInKettle() {
  Scene scene = kettle();
  Block ice = scene.blocks[0];
  ice.min_m = Vec3d(-0.05, -0.05, 0.15);
  ice.max_m = Vec3d(0.05, 0.05, 0.25);
  ice.celsius = -10.0;
  scene.blocks.push_back(ice);
  return scene;
}

}  // namespace ice_ice_baby::test
