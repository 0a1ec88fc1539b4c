#pragma once
#include <string_view>

namespace twofold {

/// Holds the vectors of this process to `widest`, to compare what processors give: baseline (what
/// any processor has), sse4, avx2 or avx3 (AVX-512). A processor that has less uses what it has.
/// Not while a frame is being drawn.
/// @throws Error with the names that there are
void limit_vectors(std::string_view widest);

}  // namespace twofold
