// Instruction sets that Highway must skip. Include this before Highway.
//
// Scalable vectors (SVE) cannot be struct members. Every processor with SVE also has NEON.
#pragma once

#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128)
