#include "smoothed_volume.h"

#include <algorithm>
#include <cmath>

#include "base/cell_key.h"
#include "base/parallel.h"
#include "splat.h"

namespace ice_ice_baby {

namespace {

/// Distance of the nodes and reach of the kernel, in spacings.
constexpr double kEdge_d = 0.6, kReach_d = 2.2;

/// Integral of (1 - r^2)^3 over the unit ball.
constexpr double kKernelVolume = 64 * M_PI / 315;

/// Value on the surface: flat water is enclosed half a spacing above its top layer to within a
/// tenth, balls of 4 to 24 spacings within 2 % of their volume.
constexpr float kLevel = 0.645f;

std::uint64_t keyOf(const Eigen::Vector3i& block) {
  return cellKey(block.x(), block.y(), block.z());
}

/// Of a node, rounded down also below 0.
Eigen::Vector3i blockWith(const SmoothedVolume::Node& node) {
  static_assert(SmoothedVolume::kBlock == 8, "shifts by 3");
  return {node.x() >> 3, node.y() >> 3, node.z() >> 3};
}

}  // namespace

SmoothedVolume::SmoothedVolume(const std::vector<Vec3<float>>& positions, double spacing_m)
    : edge_m_(float(kEdge_d * spacing_m)),
      reach_m_(float(kReach_d * spacing_m)),
      alone_(float(1 / (kKernelVolume * kReach_d * kReach_d * kReach_d))) {
  findBlocks(positions);
  weights_.assign(positions.size(), alone_);
  const Splat particles{positions, weights_, edge_m_, reach_m_};
  parallelFor(
      blocks_.size(), [&](std::size_t b) { splat(particles, blocks_[b]); }, 4);
  weigh(positions);
  parallelFor(
      blocks_.size(),
      [&](std::size_t b) {
        // Weights only add, so a block that was full still is.
        const auto& values = blocks_[b].values;
        if (*std::min_element(values.begin(), values.end()) < kLevel) splat(particles, blocks_[b]);
      },
      4);
}

float SmoothedVolume::level() const { return kLevel; }

void SmoothedVolume::findBlocks(const std::vector<Vec3<float>>& positions) {
  const float per_m = 1 / edge_m_;
  for (Index i = 0; i < positions.size(); ++i) {
    const Eigen::Array3f at = positions[i].array() * per_m;
    const float reach = reach_m_ * per_m;
    const Node low = blockWith((at - reach).ceil().cast<int>().matrix());
    const Node high = blockWith((at + reach).floor().cast<int>().matrix());
    for (int x = low.x(); x <= high.x(); ++x) {
      for (int y = low.y(); y <= high.y(); ++y) {
        for (int z = low.z(); z <= high.z(); ++z) {
          const auto [entry, added] =
              number_.try_emplace(keyOf({x, y, z}), static_cast<Index>(blocks_.size()));
          if (added) blocks_.emplace_back().low = kBlock * Node(x, y, z);
          blocks_[entry->second].members.push_back(i);
        }
      }
    }
  }
}

void SmoothedVolume::weigh(const std::vector<Vec3<float>>& positions) {
  parallelFor(positions.size(), [&](std::size_t i) {
    weights_[i] = alone_ / std::clamp(at(positions[i]), alone_, 1.0f);
  });
}

const SmoothedVolume::Block* SmoothedVolume::blockOf(const Node& node) const {
  const auto found = number_.find(keyOf(blockWith(node)));
  return found == number_.end() ? nullptr : &blocks_[found->second];
}

const SmoothedVolume::Block* SmoothedVolume::blockAt(const Vec3<float>& place) const {
  return blockOf((place.array() / edge_m_).floor().cast<int>().matrix());
}

/// Trilinear between the nodes.
float SmoothedVolume::at(const Vec3<float>& place) const {
  const Eigen::Array3f at = place.array() / edge_m_;
  const Eigen::Array3f low = at.floor(), share = at - low;
  const Node first = low.cast<int>().matrix();
  float value = 0.0f;
  const Block* block = nullptr;
  for (int k = 0; k < 8; ++k) {
    const Node node = first + Node(k & 1, k >> 1 & 1, k >> 2);
    if (!block || blockWith(node) != blockWith(block->low)) block = blockOf(node);
    if (!block) continue;
    const Node within = node - block->low;
    const Eigen::Array3f of(k & 1 ? share.x() : 1 - share.x(),
                            k >> 1 & 1 ? share.y() : 1 - share.y(),
                            k >> 2 ? share.z() : 1 - share.z());
    value += of.prod() *
             block->values[std::size_t(kBlock * (kBlock * within.x() + within.y()) + within.z())];
  }
  return value;
}

}  // namespace ice_ice_baby
