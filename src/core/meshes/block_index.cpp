#include "meshes/block_index.h"

namespace ice_ice_baby {

BlockIndex::BlockIndex(const Eigen::AlignedBox3d& box, double edge_m)
    : first_m_(box.min()), edge_m_(edge_m) {
  blocks_ = ((box.sizes() / edge_m).array() / kBlock).floor().cast<int>() + 1;
  number_.assign(std::size_t(blocks_.x()) * std::size_t(blocks_.y()) * std::size_t(blocks_.z()),
                 kAbsent);
}

double BlockIndex::blocksOver(const Eigen::AlignedBox3d& box, double edge_m) {
  return ((box.sizes() / edge_m).array() / kBlock + 1).prod();
}

}  // namespace ice_ice_baby
