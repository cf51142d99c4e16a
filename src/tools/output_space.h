// Checks before a run that its output fits on the disk.
#pragma once

#include "frame_loop.h"

namespace ice_ice_baby {

/// Maximum number of pictures, surfaces or exports of a run, because their names have five digits.
constexpr double kMaxPictures = 100000;

/// @throws InvalidInput for more than kMaxPictures pictures, and for a record larger than the free
/// space of its folder
void requireDiskSpace(const RunOutputs& outputs, const Scene& scene, double duration_s);

}  // namespace ice_ice_baby
