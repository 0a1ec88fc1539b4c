#include "raster/vector_width.hpp"

#include "raster/lane_targets.hpp"
// The targets are chosen before Highway is read.
#include <hwy/highway.h>

#include <array>
#include <string>
#include <utility>

#include "texunit/error.hpp"

namespace twofold {
namespace {

constexpr std::array<std::pair<std::string_view, std::int64_t>, 4> widths{
    {{"baseline", HWY_STATIC_TARGET}, {"sse4", HWY_SSE4}, {"avx2", HWY_AVX2}, {"avx3", HWY_AVX3}}};

}  // namespace

void limit_vectors(std::string_view widest) {
    for (const auto& [name, target] : widths)
        if (name == widest) {
            // Better targets have lower bits.
            const std::int64_t kept = hwy::SupportedTargets() & ~(target - 1);
            return hwy::SetSupportedTargetsForTest(kept | HWY_STATIC_TARGET);
        }
    throw Error(ExitCode::failure, "vectors: no width '" + std::string(widest) +
                                       "'; there are: baseline sse4 avx2 avx3");
}

}  // namespace twofold
