#pragma once

// What any processor has, SSE4, AVX2 and AVX-512 are enough, without what no loop uses.
// Highway 1.0.3 has no vectors of binary64 for 32-bit ARM and WebAssembly; SVE's and RISC-V's
// cannot be members of a class.
#ifdef __arm__
#define TWOFOLD_NO_BINARY64 HWY_NEON
#else
#define TWOFOLD_NO_BINARY64 (HWY_WASM | HWY_WASM_EMU256)
#endif
#define HWY_DISABLED_TARGETS                                                            \
    (HWY_SSSE3 | HWY_AVX3_DL | TWOFOLD_NO_BINARY64 | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | \
     HWY_SVE2_128 | HWY_RVV)
// ARM: the vectors that the compiler is told of. With others g++ refuses arrays of vectors.
#define TOOLCHAIN_MISS_SYS_AUXV_H
#define HWY_DISABLE_PCLMUL_AES
#define HWY_DISABLE_F16C
// Highway leaves its portable vectors out with g++ before 12.3, whose vectoriser compiles MulHigh
// of 16 bits wrong (GCC bug 106322). MulHigh is not used here.
#define HWY_BROKEN_EMU128 0
// Assertions would need Highway's library (vector_width.cpp).
#define HWY_IS_DEBUG_BUILD 0
