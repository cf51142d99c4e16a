// Which blocks of a regular lattice are in use: those near a surface.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "ice_ice_baby/types.h"

namespace ice_ice_baby {

/// A lattice of nodes `edge` apart over a box, in blocks of kBlock^3 nodes.
class BlockIndex {
 public:
  static constexpr int kBlock = 8;
  static constexpr Index kAbsent = kNone;
  using Node = Eigen::Vector3i;

  BlockIndex() = default;
  BlockIndex(const Eigen::AlignedBox3d& box, double edge_m);

  double edge_m() const { return edge_m_; }
  /// Blocks that a lattice over this box has, in use or not.
  static double blocksOver(const Eigen::AlignedBox3d& box, double edge_m);
  std::size_t inUse() const { return used_.size(); }
  Vec3d place(const Node& node) const { return first_m_ + edge_m_ * node.cast<double>(); }
  /// Lowest node of the k-th block in use.
  Node corner(std::size_t k) const { return kBlock * used_[k]; }

  /// Takes the blocks for which wanted(centre, half_diagonal_m) is true into use.
  template <class Wanted>
  void use(const Wanted& wanted) {
    const double half = kBlock * edge_m_ / 2, half_diagonal = std::sqrt(3.0) * half;
    std::size_t k = 0;
    for (int z = 0; z < blocks_.z(); ++z) {
      for (int y = 0; y < blocks_.y(); ++y) {
        for (int x = 0; x < blocks_.x(); ++x, ++k) {
          const Node block(x, y, z);
          if (!wanted(place(kBlock * block) + Vec3d::Constant(half - edge_m_ / 2), half_diagonal))
            continue;
          number_[k] = static_cast<Index>(used_.size());
          used_.push_back(block);
        }
      }
    }
  }

  /// Blocks along each axis, in use or not.
  const Node& blocks() const { return blocks_; }
  /// Place of a block among all of them, which are in the order of x, then y, then z.
  std::size_t placeAmongAll(const Node& block) const {
    return std::size_t(block.x()) +
           std::size_t(blocks_.x()) *
               (std::size_t(block.y()) + std::size_t(blocks_.y()) * std::size_t(block.z()));
  }
  /// Whether a block is in use.
  bool uses(const Node& block) const { return number_[placeAmongAll(block)] != kAbsent; }
  /// Whether the lattice has this node.
  bool has(const Node& node) const {
    return (node.array() >= 0).all() && (node.array() < kBlock * blocks_.array()).all();
  }
  /// Number of the block that holds a node, or kAbsent.
  Index blockOf(const Node& node) const {
    return has(node) ? number_[placeAmongAll(node / kBlock)] : kAbsent;
  }
  /// Place of a node within its block.
  static std::size_t within(const Node& node) {
    return std::size_t(node.x() % kBlock +
                       kBlock * (node.y() % kBlock + kBlock * (node.z() % kBlock)));
  }
  static constexpr std::size_t kNodes = std::size_t(kBlock) * kBlock * kBlock;

  /// The node nearest to a point.
  template <class Real>
  Node nearest(const Vec3<Real>& point) const {
    const auto per = static_cast<Real>(1 / edge_m_);
    return ((point - first_m_.cast<Real>()) * per + Vec3<Real>::Constant(Real(0.5)))
        .array()
        .floor()
        .max(Real(-1))
        .min(Real(1 << 24))
        .template cast<int>();
  }

  std::size_t bytes() const {
    return number_.capacity() * sizeof(Index) + used_.capacity() * sizeof(Node);
  }

 private:
  Vec3d first_m_ = Vec3d::Zero();  ///< of the lowest node
  double edge_m_ = 1.0;
  Node blocks_ = Node::Zero();  ///< along each axis
  std::vector<Index> number_;
  std::vector<Node> used_;
};

}  // namespace ice_ice_baby
