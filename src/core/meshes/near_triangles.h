// The few triangles among which the closest one to a point lies, looked up instead of searched for.
#pragma once

#include <vector>

#include "meshes/block_index.h"
#include "meshes/surface_tree.h"

namespace ice_ice_baby {

/// A list for each node of a lattice: the triangles one of which is the closest to any point of the
/// node's cell. Empty where there are more than a few, and far from the surface.
class NearTriangles {
 public:
  NearTriangles() = default;
  /// @param nodes number of nodes of the blocks in use
  explicit NearTriangles(std::size_t nodes) : first_(nodes + 1, 0) {}

  /// Lists of a block's nodes, one after the other.
  struct Block {
    std::vector<std::uint8_t> counts;
    std::vector<NearTriangle> triangles;

    /// Adds the list of the next node.
    /// @param distance_m of the node from the surface
    /// @param slack_m distance of the corners of its cell from the node
    void add(const SurfaceTree& tree, const Vec3d& node, double distance_m, double slack_m);
    void addEmpty() { counts.push_back(0); }
  };
  /// Takes over the lists of all blocks.
  void set(const std::vector<Block>& blocks);

  /// @param node its place among the nodes of all blocks in use
  NearTriangleList at(std::size_t node) const {
    return {triangles_.data() + first_[node], triangles_.data() + first_[node + 1]};
  }

  std::size_t bytes() const {
    return first_.capacity() * sizeof(Index) + triangles_.capacity() * sizeof(NearTriangle);
  }

 private:
  std::vector<Index> first_;  ///< of each node's list, and the end of the last
  std::vector<NearTriangle> triangles_;
};

}  // namespace ice_ice_baby
