#pragma once

// What any processor has, SSE4, AVX2 and AVX-512 are enough, without what no loop uses.
// Highway 1.0.3 has no vectors of binary64 for WebAssembly.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL | HWY_WASM | HWY_WASM_EMU256)
#define HWY_DISABLE_PCLMUL_AES
#define HWY_DISABLE_F16C
// Highway leaves its portable vectors out with g++ before 12.3, whose vectoriser compiles MulHigh of
// 16 bits wrong (GCC bug 106322). MulHigh is not used here.
#define HWY_BROKEN_EMU128 0
// Assertions would need Highway's library (vector_width.cpp).
#define HWY_IS_DEBUG_BUILD 0
