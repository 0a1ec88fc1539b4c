#pragma once

// What any processor has, SSE4, AVX2 and AVX-512 are enough, without what no loop uses.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#define HWY_DISABLE_PCLMUL_AES
#define HWY_DISABLE_F16C
// Highway leaves its portable vectors out with g++ before 12.3, whose vectoriser compiles MulHigh of
// 16 bits wrong (GCC bug 106322). MulHigh is not used here.
#define HWY_BROKEN_EMU128 0
// Assertions would need Highway's library (vector_width.cpp).
#define HWY_IS_DEBUG_BUILD 0
