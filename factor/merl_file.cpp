#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "factor/measured_data.hpp"
#include "factor/surface_angles.hpp"
#include "texunit/byte_cursor.hpp"
#include "texunit/exact_math.hpp"
#include "texunit/fixed.hpp"

namespace twofold {
namespace {

constexpr int half_bins = 90, difference_bins = 90, azimuth_bins = 180;
constexpr std::size_t bins =
    std::size_t{half_bins} * std::size_t{difference_bins} * std::size_t{azimuth_bins};
constexpr std::size_t file_bytes = 3 * 4 + 3 * 8 * bins;
constexpr std::array<double, 3> scale{1.0 / 1500.0, 1.15 / 1500.0, 1.66 / 1500.0};

/// f of each bin, the channels one after the other; NaN where not measured.
using Planes = std::vector<float>;

void refuse_pointer(std::span<const unsigned char> bytes, const ByteCursor& at) {
    constexpr std::string_view start = "version https://git-lfs";
    const bool pointer =
        bytes.size() >= start.size() && std::equal(start.begin(), start.end(), bytes.begin());
    if (pointer) at.fail("a Git LFS pointer, not the file itself: fetch it with git lfs pull");
}

void check_dimensions(ByteCursor& at) {
    for (const int wanted : {half_bins, difference_bins, azimuth_bins})
        if (const auto found = at.value<std::int32_t>(); found != wanted)
            at.fail(fmt::format("dimension {} where MERL has {}", found, wanted));
}

float measured(double stored, double factor) {
    const double value = stored >= 0.0 && std::isfinite(stored)
                             ? stored * factor
                             : std::numeric_limits<double>::quiet_NaN();
    return canonical(static_cast<float>(value));
}

/// wi in the frame of h: turned by -phi_h about z, then by -theta_h about y.
Vec3 difference_vector(Vec3 wi, Vec3 h) {
    const double sine = std::sqrt(h.x * h.x + h.y * h.y);
    const double c = sine > 0.0 ? h.x / sine : 1.0, s = sine > 0.0 ? h.y / sine : 0.0;
    const double x = c * wi.x + s * wi.y, y = c * wi.y - s * wi.x;
    return {h.z * x - sine * wi.z, y, sine * x + h.z * wi.z};
}

std::size_t bin_of(Vec3 wi, Vec3 wo) {
    const Vec3 h = normalized(wi + wo);
    const Vec3 d = difference_vector(wi, h);
    const double turned = azimuth(d.x, d.y);
    const double phi = turned < 0.0 ? turned + exact::pi : turned;
    const double quarter = exact::pi / 2.0;
    const int i = to_fixed(half_bins * std::sqrt(polar_angle(h) / quarter), 0, half_bins - 1);
    const int j = to_fixed(difference_bins * polar_angle(d) / quarter, 0, difference_bins - 1);
    const int k = to_fixed(azimuth_bins * phi / exact::pi, 0, azimuth_bins - 1);
    return static_cast<std::size_t>(k + azimuth_bins * (j + difference_bins * i));
}

Rgb value_at(const Planes& planes, Vec3 wi, Vec3 wo) {
    const std::size_t bin = bin_of(wi, wo);
    const auto channel = [&](std::size_t c) { return static_cast<double>(planes[c * bins + bin]); };
    return {channel(0), channel(1), channel(2)};
}

}  // namespace

void ValueCounts::add(double value) {
    ++values;
    if (!std::isfinite(value))
        ++not_finite;
    else if (value < 0.0)
        ++negative;
    else if (value == 0.0)
        ++zero;
}

MeasuredData parse_merl(std::span<const unsigned char> bytes, std::string_view name) {
    ByteCursor at(bytes, name);
    refuse_pointer(bytes, at);
    if (bytes.size() >= 12) check_dimensions(at);
    if (bytes.size() != file_bytes)
        at.fail(fmt::format("a MERL file has {} bytes, this one {}", file_bytes, bytes.size()));
    MeasuredData data;
    const auto planes = std::make_shared<Planes>(3 * bins);
    for (std::size_t c = 0; c < 3; ++c)
        for (std::size_t i = 0; i < bins; ++i) {
            const auto stored = at.value<double>();
            data.counts[c].add(stored);
            (*planes)[c * bins + i] = measured(stored, scale[c]);
        }
    data.value = [planes](Vec3 wi, Vec3 wo) { return value_at(*planes, wi, wo); };
    return data;
}

}  // namespace twofold
