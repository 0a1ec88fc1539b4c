#include "raster/vector_width.hpp"

#include "raster/lane_targets.hpp"
// The targets are chosen before Highway is read.
#include <hwy/highway.h>

#include <array>
#include <string>
#include <utility>

#include "texunit/error.hpp"

/// What Highway's dispatch asks its library for. The library is not linked: when it is loaded it
/// finds out a timer's resolution for its benchmarks, which takes 4 ms.
namespace hwy {

/// Targets as lane_targets.hpp leaves them, of those that this processor has.
HWY_DLLEXPORT std::int64_t SupportedTargets() {
    std::int64_t targets = HWY_STATIC_TARGET;
#if HWY_ARCH_X86
    const auto has = [&targets](std::int64_t target, bool it_has) {
        if (it_has) targets |= target;
        return it_has;
    };
    __builtin_cpu_init();
    has(HWY_SSE4, __builtin_cpu_supports("sse4.2")) &&
        has(HWY_AVX2, __builtin_cpu_supports("avx2") && __builtin_cpu_supports("bmi") &&
                          __builtin_cpu_supports("bmi2") && __builtin_cpu_supports("fma")) &&
        has(HWY_AVX3, __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
                          __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw"));
#endif
    return targets;
}

HWY_DLLEXPORT ChosenTarget& GetChosenTarget() {
    static constinit ChosenTarget chosen;
    return chosen;
}

}  // namespace hwy

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
            return hwy::GetChosenTarget().Update(kept | HWY_STATIC_TARGET);
        }
    throw Error(ExitCode::failure, "vectors: no width '" + std::string(widest) +
                                       "'; there are: baseline sse4 avx2 avx3");
}

}  // namespace twofold
