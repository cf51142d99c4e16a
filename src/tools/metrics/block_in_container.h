// Where the only block of a scene stands in its only container: what tells a scene with a known
// answer from any other, without a key that could claim too much.
#pragma once

#include <optional>

#include "frame_view.h"

namespace ice_ice_baby {

/// Lengths between faces of the block and of the container, m; all 0 for a block that fills it. The
/// block is as large as its particles make it, which is a whole number of spacings.
struct BlockInContainer {
  Vec3d min_gap_m, max_gap_m;  ///< towards the lower and the upper walls
  Vec3d block_size_m, container_size_m;
  Vec3d floor_m;  ///< lower corner of the container
};

/// Nothing unless the scene is one box of water at rest inside one upright container, with gravity
/// straight down and nothing else in it. `start` is the state before the first frame.
std::optional<BlockInContainer> blockInContainer(const FrameView& start);

}  // namespace ice_ice_baby
