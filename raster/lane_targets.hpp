#pragma once

// What any processor has, SSE4, AVX2 and AVX-512 are enough.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
// Highway leaves its portable vectors out with g++ before 12.3, whose vectoriser compiles MulHigh of
// 16 bits wrong (GCC bug 106322). MulHigh is not used here.
#define HWY_BROKEN_EMU128 0
