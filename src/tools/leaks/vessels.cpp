#include "leaks/vessels.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "ice_ice_baby/collider_mesh.h"
#include "ice_ice_baby/errors.h"
#include "meshes/solids_of_revolution.h"

namespace ice_ice_baby::leaks {

namespace {

using Outline = std::vector<OutlinePoint>;

constexpr double kRadius_m = 0.045, kDepth_m = 0.1, kWall_m = 0.004;
constexpr int kSegments = 96;
/// Segments of the mesh of 100,000 triangles, and lines of its outline.
constexpr int kManySegments = 256, kManyLines = 197;
/// Share of the depth that is filled.
constexpr double kOpenFill = 0.5, kClosedFill = 0.9;

void append(TriangleMesh& mesh, const std::vector<Vec3d>& vertices,
            const std::vector<std::array<Index, 3>>& triangles, const Posed& pose) {
  const auto first = static_cast<Index>(mesh.vertices.size());
  for (const Vec3d& vertex : vertices) mesh.vertices.push_back(pose.toWorld(vertex));
  for (const auto& t : triangles) {
    mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  }
}

TriangleMesh wallsOf(const Scene& scene) {
  TriangleMesh walls;
  forEachColliderMesh(scene, {}, [&](const Collider& collider, const ColliderMesh& mesh) {
    append(walls, mesh.vertices, mesh.triangles, collider.pose());
  });
  return walls;
}

TriangleMesh boxRoom(const Vec3d& size) {
  Scene scene;
  Box& box = scene.boxes.emplace_back();
  box.size_m = size;
  box.position_m = Vec3d(0, 0, size.z() / 2);
  return wallsOf(scene);
}

Block water(const Vec3d& low, const Vec3d& high, BlockShape shape) {
  Block block;
  block.min_m = low;
  block.max_m = high;
  block.shape = shape;
  block.carve = true;
  return block;
}

/// Water in the lower half of a round vessel.
Block halfFull(double radius_m) {
  return water({-radius_m, -radius_m, 0}, {radius_m, radius_m, kOpenFill * kDepth_m},
               BlockShape::kCylinder);
}

void addMesh(Vessel& vessel, TriangleMesh triangles) {
  Mesh& mesh = vessel.scene.meshes.emplace_back();
  mesh.name = "vessel";
  mesh.triangles = std::make_shared<const TriangleMesh>(std::move(triangles));
}

Vessel closedContainer() {
  Vessel vessel;
  const Vec3d size(2 * kRadius_m, 2 * kRadius_m, 2 * kRadius_m);
  Container& tank = vessel.scene.containers.emplace_back();
  tank.name = "vessel";
  tank.size_m = size;
  tank.wall_m = kWall_m;
  tank.open_top = false;
  vessel.room = boxRoom(size);
  vessel.scene.blocks.push_back(water({-kRadius_m, -kRadius_m, 0},
                                      {kRadius_m, kRadius_m, kClosedFill * size.z()},
                                      BlockShape::kBox));
  return vessel;
}

Vessel cup() {
  Vessel vessel;
  Cup& one = vessel.scene.cups.emplace_back();
  one.name = "vessel";
  one.radius_m = kRadius_m;
  one.depth_m = kDepth_m;
  one.wall_m = kWall_m;
  vessel.room = turned({{0, 0}, {kRadius_m, 0}, {kRadius_m, kDepth_m}, {0, kDepth_m}},
                       segmentsOf(kRadius_m + kWall_m));
  vessel.rim_m = kDepth_m;
  vessel.scene.blocks.push_back(halfFull(kRadius_m));
  return vessel;
}

/// A dent in the floor, a wide body, a narrow neck and a lid.
Vessel bottle() {
  const Outline within{{0, 0.012},     {0.02, 0},      {0.035, 0}, {0.038, 0.05},
                       {0.012, 0.068}, {0.012, 0.094}, {0, 0.094}};
  const Outline without{{0, 0.010},     {0.02, -0.002}, {0.037, -0.002}, {0.04, 0.051},
                        {0.014, 0.070}, {0.014, 0.096}, {0, 0.096}};
  Vessel vessel;
  vessel.room = turned(within, kSegments);
  TriangleMesh walls = turned(without, kSegments);
  const TriangleMesh inner = turned(Outline(within.rbegin(), within.rend()), kSegments);
  append(walls, inner.vertices, inner.triangles, {});
  addMesh(vessel, std::move(walls));
  vessel.scene.blocks.push_back(
      water({-0.034, -0.034, 0.012}, {0.034, 0.034, 0.05}, BlockShape::kCylinder));
  return vessel;
}

constexpr double kMugFloor_m = 0.035;

/// A mug that widens upwards, of a single layer of triangles or of walls of 1 mm.
Vessel mug(double wall_m) {
  const double floor = kMugFloor_m, top = kRadius_m;
  Vessel vessel;
  if (wall_m == 0.0) {
    addMesh(vessel, turned({{0, 0}, {floor, 0}, {top, kDepth_m}}, kSegments));
  } else {
    addMesh(vessel, turned({{0, -wall_m},
                            {floor + wall_m, -wall_m},
                            {top + wall_m, kDepth_m},
                            {top, kDepth_m},
                            {floor, 0},
                            {0, 0}},
                           kSegments));
  }
  vessel.room = turned({{0, 0}, {floor, 0}, {top, kDepth_m}, {0, kDepth_m}}, kSegments);
  vessel.rim_m = kDepth_m;
  vessel.scene.blocks.push_back(halfFull(floor));
  return vessel;
}

/// The outline with its lines divided into `lines` pieces, about equally long.
Outline divided(const Outline& outline, int lines) {
  const auto length = [&](std::size_t k) {
    const double r = outline[k + 1].radius_m - outline[k].radius_m;
    return std::hypot(r, outline[k + 1].z_m - outline[k].z_m);
  };
  double total = 0.0;
  for (std::size_t k = 0; k + 1 < outline.size(); ++k) total += length(k);
  Outline fine{outline.front()};
  for (std::size_t k = 0; k + 1 < outline.size(); ++k) {
    const OutlinePoint &a = outline[k], &b = outline[k + 1];
    const int pieces = std::max(1, int(std::lround(lines * length(k) / total)));
    for (int i = 1; i < pieces; ++i) {
      const double share = double(i) / pieces;
      fine.push_back(
          {a.radius_m + share * (b.radius_m - a.radius_m), a.z_m + share * (b.z_m - a.z_m)});
    }
    fine.push_back(b);
  }
  return fine;
}

Vessel denseCup() {
  const double outer = kRadius_m + kWall_m;
  Vessel vessel;
  addMesh(vessel, turned(divided({{0, -kWall_m},
                                  {outer, -kWall_m},
                                  {outer, kDepth_m},
                                  {kRadius_m, kDepth_m},
                                  {kRadius_m, 0},
                                  {0, 0}},
                                 kManyLines),
                         kManySegments));
  vessel.room =
      turned({{0, 0}, {kRadius_m, 0}, {kRadius_m, kDepth_m}, {0, kDepth_m}}, kManySegments);
  vessel.rim_m = kDepth_m;
  vessel.scene.blocks.push_back(halfFull(kRadius_m));
  return vessel;
}

/// A floor and four walls, each a collider of its own.
Vessel plates() {
  const double w = kWall_m, inner = 2 * kRadius_m, middle = kRadius_m + w / 2;
  Vessel vessel;
  const auto add = [&](const char* name, const Vec3d& size, const Vec3d& centre) {
    Box& box = vessel.scene.boxes.emplace_back();
    box.name = name;
    box.size_m = size;
    box.position_m = centre;
  };
  add("floor", {inner + 2 * w, inner + 2 * w, w}, {0, 0, -w / 2});
  add("left", {w, inner + 2 * w, kDepth_m}, {-middle, 0, kDepth_m / 2});
  add("right", {w, inner + 2 * w, kDepth_m}, {middle, 0, kDepth_m / 2});
  add("front", {inner, w, kDepth_m}, {0, -middle, kDepth_m / 2});
  add("back", {inner, w, kDepth_m}, {0, middle, kDepth_m / 2});
  vessel.room = boxRoom({inner, inner, kDepth_m});
  vessel.rim_m = kDepth_m;
  vessel.scene.blocks.push_back(water(
      {-kRadius_m, -kRadius_m, 0}, {kRadius_m, kRadius_m, kOpenFill * kDepth_m}, BlockShape::kBox));
  return vessel;
}

/// Leaves more than 2 cm around the vessel, the largest spacing.
void addBoxAround(Vessel& vessel) {
  Container& box = vessel.scene.containers.emplace_back();
  box.name = "box";
  box.size_m = Vec3d(0.15, 0.15, 0.17);
  box.position_m.z() = -0.03;
  box.open_top = false;
}

const std::vector<std::pair<const char*, std::function<Vessel()>>>& all() {
  static const std::vector<std::pair<const char*, std::function<Vessel()>>> kAll{
      {"container", closedContainer},
      {"cup", cup},
      {"bottle", bottle},
      {"shell", [] { return mug(0.0); }},
      {"thin_mug", [] { return mug(0.001); }},
      {"dense_cup", denseCup},
      {"plates", plates}};
  return kAll;
}

}  // namespace

std::vector<std::string> vesselNames() {
  std::vector<std::string> names;
  for (const auto& [name, make] : all()) names.emplace_back(name);
  return names;
}

Vessel makeVessel(const std::string& name, double spacing_m, bool in_box) {
  for (const auto& [known, make] : all()) {
    if (name != known) continue;
    Vessel vessel = make();
    vessel.scene.fluid.spacing_m = spacing_m;
    vessel.walls = wallsOf(vessel.scene);
    vessel.centre_m = Vec3d(0, 0, kDepth_m / 2);
    if (in_box && vessel.rim_m) addBoxAround(vessel);
    return vessel;
  }
  throw InvalidInput("no vessel " + shortened(name) + "; there are: " + joined(vesselNames()));
}

}  // namespace ice_ice_baby::leaks
