#include "water_scenes.h"

#include <cmath>

#include "ice_ice_baby/scene_loader.h"

namespace ice_ice_baby::bench {

namespace {

constexpr double kSpacing_m = 0.02;

double edge_m(std::size_t count) { return kSpacing_m * std::round(std::cbrt(double(count))); }

}  // namespace

Scene floatingWater(std::size_t count) {
  Scene scene;
  scene.fluid.spacing_m = kSpacing_m;
  scene.gravity_m_s2.setZero();
  const double half = edge_m(count) / 2;
  Block block;
  block.min_m = {-half, -half, 0.0};
  block.max_m = {half, half, 2 * half};
  scene.blocks.push_back(block);
  return scene;
}

Scene stillPool(std::size_t count) {
  Scene scene = floatingWater(count);
  scene.gravity_m_s2 = {0.0, 0.0, -9.81};
  const double edge = edge_m(count);
  Container tank;
  tank.name = "tank";
  tank.size_m = {edge, edge, 1.5 * edge};
  tank.open_top = false;
  scene.containers.push_back(tank);
  return scene;
}

Scene damBreak(std::size_t count) {
  Scene scene = loadScene("dam_break");
  const Vec3d size = scene.blocks.at(0).max_m - scene.blocks.at(0).min_m;
  scene.fluid.spacing_m = std::cbrt(size.prod() / double(count));
  return scene;
}

}  // namespace ice_ice_baby::bench
