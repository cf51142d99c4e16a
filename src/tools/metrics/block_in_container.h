// Recognises scenes with a single block of water in a single container, for which the answer is
// known.
#pragma once

#include <optional>

#include "frame_view.h"

namespace ice_ice_baby {

/// Distances between the faces of the block and of the container, m; all 0 for a block that fills
/// it. The size of the block is that of its particles, a whole number of spacings.
struct BlockInContainer {
  Vec3d min_gap_m, max_gap_m;  ///< towards the lower and the upper walls
  Vec3d block_size_m, container_size_m;
  Vec3d floor_m;  ///< lower corner of the container
};

/// Empty unless the scene is one box of water at rest inside one upright container, with vertical
/// gravity and nothing else. `start` is the initial state.
std::optional<BlockInContainer> blockInContainer(const FrameView& start);

}  // namespace ice_ice_baby
