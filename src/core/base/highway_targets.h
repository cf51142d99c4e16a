// Instruction sets that Highway must skip. Include this before Highway.
//
// Scalable vectors (SVE) cannot be struct members. Every processor with SVE also has NEON.
#pragma once

#ifdef IIB_SANITIZED
// A sanitizer needs half a minute more for each file and set; the narrowest and a wide one will do.
#define HWY_DISABLED_TARGETS \
  (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_SSSE3 | HWY_SSE4 | HWY_AVX2 | HWY_AVX3_DL)
#else
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128)
#endif
