#include "study/metrics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "texunit/error.hpp"
#include "texunit/exact_math.hpp"
#include "texunit/ordered_sum.hpp"

namespace twofold {
namespace {

using Steps = std::array<int, 4>;

/// Sums that do not yet know how many terms there will be. 8-bit squares stay integers: a picture
/// would need 2^46 pixels to overflow.
struct Totals {
    PictureDifference result;
    std::uint64_t squares = 0;
};

std::string size_text(int width, int height, int channels) {
    return fmt::format("{} x {} pixels of {} channels", width, height, channels);
}

[[noreturn]] void throw_sizes_differ(const std::string& a, const std::string& b) {
    throw Error(ExitCode::sizes_differ, fmt::format("pictures differ in size: {} and {}", a, b));
}

void require_same_size(const ByteImage& a, const ByteImage& b) {
    if (a.width == b.width && a.height == b.height) return;
    throw_sizes_differ(size_text(a.width, a.height, 4), size_text(b.width, b.height, 4));
}

void require_same_size(const FloatImage& a, const FloatImage& b) {
    if (a.width == b.width && a.height == b.height && a.channels == b.channels) return;
    throw_sizes_differ(size_text(a.width, a.height, a.channels),
                       size_text(b.width, b.height, b.channels));
}

/// Where pixel number `index` lies, counted from the top left.
std::pair<int, int> position(std::size_t index, int width) {
    const auto w = static_cast<std::size_t>(width);
    return {static_cast<int>(index % w), static_cast<int>(index / w)};
}

Steps steps_between(Rgba8 p, Rgba8 q) {
    return {std::abs(p.r - q.r), std::abs(p.g - q.g), std::abs(p.b - q.b), std::abs(p.a - q.a)};
}

int largest(const Steps& steps) { return *std::max_element(steps.begin(), steps.end()); }

bool covered(Rgba8 p) { return p.a != 0; }

void add_pixel(Totals& totals, const Steps& steps, std::size_t index, int width) {
    PictureDifference& d = totals.result;
    const int most = largest(steps);
    ++d.pixels_compared;
    ++d.histogram[static_cast<std::size_t>(most)];
    if (most == 0) return;
    ++d.differing_pixels;
    if (!d.first_difference) d.first_difference = position(index, width);
    d.max_steps = std::max(d.max_steps, most);
    for (std::size_t c = 0; c < steps.size(); ++c) {
        d.max_per_channel[c] = std::max(d.max_per_channel[c], steps[c]);
        totals.squares += static_cast<std::uint64_t>(steps[c] * steps[c]);
    }
}

double root_mean(double squares, std::size_t count) {
    return count == 0 ? 0.0 : std::sqrt(squares / static_cast<double>(count));
}

double psnr(double rms, double peak) {
    if (rms == 0.0) return std::numeric_limits<double>::infinity();
    constexpr double per_log = 0x1.15f2ced384f28p+3;  // 20 / ln 10
    return per_log * exact::log(peak / rms);
}

PictureDifference finished(const Totals& totals, std::size_t channels) {
    PictureDifference d = totals.result;
    d.rms_steps = root_mean(static_cast<double>(totals.squares), d.pixels_compared * channels);
    d.psnr_db = psnr(d.rms_steps, 255.0);
    return d;
}

bool same(float p, float q) { return p == q || (std::isnan(p) && std::isnan(q)); }

bool have_distance(float p, float q) { return std::isfinite(p) && std::isfinite(q); }

double distance(float p, float q) {
    return std::fabs(static_cast<double>(p) - static_cast<double>(q));
}

/// Two float pictures of the same size and which of their samples are compared.
struct FloatPair {
    const FloatImage& a;
    const FloatImage& b;
    bool covered_only;

    std::size_t channels() const { return static_cast<std::size_t>(a.channels); }
    bool a_covers(std::size_t pixel) const { return a.samples[pixel * 4 + 3] != 0.0f; }
    bool b_covers(std::size_t pixel) const { return b.samples[pixel * 4 + 3] != 0.0f; }

    bool compares(std::size_t sample) const {
        if (!covered_only) return true;
        const std::size_t pixel = sample / 4;
        return sample % 4 != 3 && a_covers(pixel) && b_covers(pixel);
    }

    /// 0 where nothing is compared or there is no distance.
    double squared_distance(std::size_t sample) const {
        const float p = a.samples[sample], q = b.samples[sample];
        if (same(p, q) || !have_distance(p, q) || !compares(sample)) return 0.0;
        const double d = distance(p, q);
        return d * d;
    }
};

void add_sample(FloatDifference& d, float p, float q) {
    ++d.samples_compared;
    if (same(p, q)) return;
    ++d.differing_samples;
    if (have_distance(p, q))
        d.max_abs = std::max(d.max_abs, distance(p, q));
    else
        ++d.without_distance;
}

void add_pixel(FloatDifference& d, const FloatPair& pair, std::size_t pixel) {
    const std::size_t before = d.differing_samples, channels = pair.channels();
    for (std::size_t i = pixel * channels; i < (pixel + 1) * channels; ++i) {
        if (pair.compares(i)) add_sample(d, pair.a.samples[i], pair.b.samples[i]);
    }
    if (channels == 4 && pair.a_covers(pixel) != pair.b_covers(pixel)) ++d.coverage_differs;
    if (d.differing_samples == before) return;
    ++d.differing_pixels;
    if (!d.first_difference) d.first_difference = position(pixel, pair.a.width);
}

FloatDifference float_difference(const FloatPair& pair) {
    FloatDifference d;
    const std::size_t samples = pair.a.samples.size();
    for (std::size_t i = 0; i * pair.channels() < samples; ++i) add_pixel(d, pair, i);
    const double squares =
        ordered_sum(samples, [&](std::size_t i) { return pair.squared_distance(i); });
    d.rms = root_mean(squares, d.samples_compared - d.without_distance);
    d.psnr_db = psnr(d.rms, 1.0);
    return d;
}

std::uint8_t mixed(std::uint8_t from, std::uint8_t to, int part, int whole) {
    return static_cast<std::uint8_t>((from * (whole - part) + to * part + whole / 2) / whole);
}

/// Steps 1 to `full_scale` run through heat_colors[1] to the last. Even one step stands off from
/// the colour of equality, which a ramp from zero would hide.
Rgba8 heat_color(int steps, int full_scale) {
    if (steps == 0) return heat_colors.front();
    if (steps >= full_scale) return heat_colors.back();
    const int intervals = static_cast<int>(heat_colors.size()) - 2;
    const int whole = full_scale - 1;
    const int along = (steps - 1) * intervals;
    const Rgba8 from = heat_colors[static_cast<std::size_t>(1 + along / whole)];
    const Rgba8 to = heat_colors[static_cast<std::size_t>(2 + along / whole)];
    const int part = along % whole;
    return {mixed(from.r, to.r, part, whole), mixed(from.g, to.g, part, whole),
            mixed(from.b, to.b, part, whole), 255};
}

Rgba8 heat_pixel(Rgba8 p, Rgba8 q, int full_scale) {
    if (covered(p) != covered(q)) return coverage_color;
    const int most = largest(steps_between(p, q));
    if (most == 0 && !covered(p)) return {0, 0, 0, 0};
    return heat_color(most, full_scale);
}

}  // namespace

const std::array<Rgba8, 10> heat_colors{{{0, 0, 4, 255},
                                         {27, 12, 66, 255},
                                         {75, 12, 107, 255},
                                         {120, 28, 109, 255},
                                         {165, 44, 96, 255},
                                         {207, 68, 70, 255},
                                         {237, 105, 37, 255},
                                         {251, 154, 6, 255},
                                         {247, 208, 60, 255},
                                         {252, 255, 164, 255}}};

PictureDifference difference(const ByteImage& a, const ByteImage& b) {
    require_same_size(a, b);
    Totals totals;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const Rgba8 p = a.pixels[i], q = b.pixels[i];
        if (covered(p) != covered(q)) ++totals.result.coverage_differs;
        add_pixel(totals, steps_between(p, q), i, a.width);
    }
    return finished(totals, 4);
}

PictureDifference difference_where_covered(const ByteImage& a, const ByteImage& b) {
    require_same_size(a, b);
    Totals totals;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const Rgba8 p = a.pixels[i], q = b.pixels[i];
        if (covered(p) != covered(q)) ++totals.result.coverage_differs;
        if (!covered(p) || !covered(q)) continue;
        Steps steps = steps_between(p, q);
        steps[3] = 0;
        add_pixel(totals, steps, i, a.width);
    }
    return finished(totals, 3);
}

FloatDifference difference(const FloatImage& a, const FloatImage& b) {
    require_same_size(a, b);
    return float_difference({a, b, false});
}

FloatDifference difference_where_covered(const FloatImage& a, const FloatImage& b) {
    require_same_size(a, b);
    if (a.channels != 4) {
        throw Error(ExitCode::failure,
                    fmt::format("coverage needs 4 channels, the pictures have {}", a.channels));
    }
    return float_difference({a, b, true});
}

ByteImage heat_map(const ByteImage& a, const ByteImage& b, int full_scale_steps) {
    require_same_size(a, b);
    const int full_scale = std::clamp(full_scale_steps, 1, 255);
    ByteImage heat{a.width, a.height, {}};
    heat.pixels.resize(a.pixels.size());
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        heat.pixels[i] = heat_pixel(a.pixels[i], b.pixels[i], full_scale);
    }
    return heat;
}

}  // namespace twofold
