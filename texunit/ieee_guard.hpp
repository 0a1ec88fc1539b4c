#pragma once

/// Refuses to compile where the compiler was told that arithmetic need not be IEEE 754's: no result
/// of this project would then be reproducible (docs/exactness.md, section 2). g++ leaves
/// __GCC_IEC_559 below 1 under every partial fast-math flag; clang leaves no macro for those, so
/// cmake/exactness.cmake searches the flags.
#if defined(__FAST_MATH__) || __FINITE_MATH_ONLY__ || \
    (defined(__GCC_IEC_559) && __GCC_IEC_559 < 1) || __FLT_EVAL_METHOD__ != 0
#error "twofold: needs IEEE arithmetic (no fast-math, no x87)"
#endif
