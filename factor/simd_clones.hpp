#pragma once
#include <cstddef>  // defines __GLIBC__ where there is one

/// TWOFOLD_SIMD_CLONES before a function compiles it once for each vector width and lets the loader
/// choose. The bits are equal, as contraction is off and the order of every sum is written out
/// (docs/exactness.md, section 6). Nothing where the loader or a sanitizer has no place for it, and
/// with clang 14, which drops the attribute without a word.
#if defined(__x86_64__) && defined(__GLIBC__) && defined(__OPTIMIZE__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define TWOFOLD_SIMD_CLONES __attribute__((target_clones("default", "avx2", "avx512f")))
#else
#define TWOFOLD_SIMD_CLONES
#endif
