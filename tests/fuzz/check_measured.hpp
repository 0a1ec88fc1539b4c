#pragma once
#include <array>

#include "factor/measured_data.hpp"
#include "tests/fuzz/promises.hpp"

namespace twofold::hostile {

/// The function can be asked at the normal, near the horizon and anywhere between; a value may be
/// missing (NaN).
inline void check_measured(const MeasuredData& data) {
    const std::array directions{Vec3(0.0, 0.0, 1.0), Vec3(0.6, 0.0, 0.8), Vec3(-0.48, 0.64, 0.6),
                                normalized(Vec3(0.3, -0.9, 1e-9))};
    for (const Vec3 wi : directions)
        for (const Vec3 wo : directions) {
            const Rgb f = data.value(wi, wo);
            for (int c = 0; c < 3; ++c) promise(!(std::abs(f[c]) > 1e300), "a value beyond use");
        }
    for (const ValueCounts& c : data.counts)
        promise(c.not_finite + c.negative + c.zero <= c.values, "counts beyond the values");
}

}  // namespace twofold::hostile
