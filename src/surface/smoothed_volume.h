// How much of each place particles fill, smoothed, on a lattice.
#pragma once

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "ice_ice_baby/types.h"

namespace ice_ice_baby {

/// Values at the nodes of a lattice, in blocks that particles reach. Each particle counts by the
/// inverse of what the particles fill at its own place, so drops and thin sheets are kept.
class SmoothedVolume {
 public:
  static constexpr int kBlock = 8;  ///< nodes along the side of a block
  static constexpr std::size_t kNodes = std::size_t(kBlock) * kBlock * kBlock;
  using Node = Eigen::Vector3i;

  struct Block {
    Node low;                          ///< its lowest node
    std::vector<Index> members;        ///< particles that reach it
    std::array<float, kNodes> values;  ///< z changes first, x last
  };

  SmoothedVolume(const std::vector<Vec3<float>>& positions, double spacing_m);

  /// Value on the surface of the particles; it is larger inside.
  float level() const;
  float edge_m() const { return edge_m_; }
  float reach_m() const { return reach_m_; }
  const std::vector<Block>& blocks() const { return blocks_; }
  /// The block that holds a place, or null.
  const Block* blockAt(const Vec3<float>& place) const;

 private:
  void findBlocks(const std::vector<Vec3<float>>& positions);
  void weigh(const std::vector<Vec3<float>>& positions);
  float at(const Vec3<float>& place) const;
  const Block* blockOf(const Node& node) const;

  float edge_m_, reach_m_;
  float alone_;  ///< value at the place of a single particle
  std::vector<Block> blocks_;
  std::unordered_map<std::uint64_t, Index> number_;
  std::vector<float> weights_;  ///< of the particles
};

}  // namespace ice_ice_baby
