// Whether what a run writes has room, told before the run instead of at its end.
#pragma once

#include "frame_loop.h"

namespace ice_ice_baby {

/// Pictures of a run at most: their names have five digits.
constexpr double kMaxPictures = 100000;

/// @throws InvalidInput for more than kMaxPictures, and for a record larger than the free space of
/// its folder
void requireRoom(const RunOutputs& outputs, const Scene& scene, double duration_s);

}  // namespace ice_ice_baby
