// Which instruction sets Highway is to leave out; to be included before it.
//
// Vectors of unknown length (SVE) cannot be members of a struct; every such processor has NEON.
#pragma once

#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128)
