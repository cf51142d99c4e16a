#include <openvdb/openvdb.h>
#include <openvdb/tools/VolumeToMesh.h>

#include "level_mesh.h"

namespace ice_ice_baby {

namespace {

using Leaf = openvdb::FloatTree::LeafNodeType;
static_assert(Leaf::SIZE == SmoothedVolume::kNodes, "a block is a leaf");

Vec3<float> vectorOf(const openvdb::Vec3s& v) { return {v.x(), v.y(), v.z()}; }

/// How far the particles are from filling each node enough, below 0 inside.
openvdb::FloatGrid::Ptr lackingIn(const SmoothedVolume& volume) {
  auto grid = openvdb::FloatGrid::create(volume.level());
  grid->setTransform(openvdb::math::Transform::createLinearTransform(volume.edge_m()));
  for (const SmoothedVolume::Block& block : volume.blocks()) {
    auto leaf = std::make_unique<Leaf>(openvdb::Coord(block.low.x(), block.low.y(), block.low.z()),
                                       volume.level(), true);
    for (std::size_t k = 0; k < block.values.size(); ++k) {
      leaf->setValueOnly(openvdb::Index(k), volume.level() - block.values[k]);
    }
    grid->tree().addLeaf(leaf.release());
  }
  return grid;
}

}  // namespace

bool makesSurfaces() { return true; }

FluidSurface levelMesh(const SmoothedVolume& volume) {
  static const bool ready = (openvdb::initialize(), true);
  static_cast<void>(ready);
  std::vector<openvdb::Vec3s> points;
  std::vector<openvdb::Vec3I> triangles;
  std::vector<openvdb::Vec4I> quads;
  openvdb::tools::volumeToMesh(*lackingIn(volume), points, triangles, quads, 0.0, 0.0);
  FluidSurface surface;
  surface.vertices.reserve(points.size());
  for (const openvdb::Vec3s& point : points) surface.vertices.push_back(vectorOf(point));
  surface.triangles.reserve(triangles.size() + 2 * quads.size());
  for (const openvdb::Vec3I& t : triangles) surface.triangles.push_back({t[0], t[1], t[2]});
  for (const openvdb::Vec4I& q : quads) {
    surface.triangles.push_back({q[0], q[1], q[2]});
    surface.triangles.push_back({q[0], q[2], q[3]});
  }
  return surface;
}

}  // namespace ice_ice_baby
