#include "study/sweep/errors.hpp"

#include <cmath>

#include "study/outline.hpp"
#include "study/pictures.hpp"
#include "texunit/ordered_sum.hpp"

namespace twofold {
namespace {

/// The pixels that are compared, as `difference_where_covered` takes them.
std::vector<std::size_t> compared_pixels(const ByteImage& a, const ByteImage& b) {
    std::vector<std::size_t> compared;
    for (std::size_t i = 0; i < a.pixels.size(); ++i)
        if (a.pixels[i].a != 0 && b.pixels[i].a != 0) compared.push_back(i);
    return compared;
}

double rgb_sum(const std::vector<std::size_t>& pixels, auto&& square) {
    return ordered_sum(3 * pixels.size(),
                       [&](std::size_t i) { return square(pixels[i / 3], i % 3); });
}

double share_of(const std::vector<std::size_t>& pixels, auto&& holds) {
    std::size_t count = 0;
    for (const std::size_t i : pixels) count += holds(i) ? 1U : 0U;
    return pixels.empty() ? 0.0 : static_cast<double>(count) / static_cast<double>(pixels.size());
}

bool any_channel(Rgba8 p, Rgba8 q, auto&& holds) {
    return holds(p.r, q.r) || holds(p.g, q.g) || holds(p.b, q.b);
}

}  // namespace

CellErrors errors_between(const Framebuffer& picture, const Framebuffer& reference,
                          const std::vector<bool>& outline) {
    const ByteImage a = without_outline(byte_image(picture), outline), b = byte_image(reference);
    CellErrors errors{difference_where_covered(a, b), 0.0, 0.0, 0.0, 0.0};
    const auto pixels = compared_pixels(a, b);
    const auto squared = [&](std::size_t i, std::size_t c) {
        const double d = picture.values[i][c] - reference.values[i][c];
        return d * d;
    };
    const auto brightness = [&](std::size_t i, std::size_t c) {
        return reference.values[i][c] * reference.values[i][c];
    };
    const double difference = rgb_sum(pixels, squared), whole = rgb_sum(pixels, brightness);
    if (!pixels.empty())
        errors.real_rms_steps =
            255.0 * std::sqrt(difference / static_cast<double>(3 * pixels.size()));
    if (whole > 0.0) errors.relative_rms = std::sqrt(difference / whole);
    errors.clipped_share = share_of(pixels, [&](std::size_t i) {
        return any_channel(a.pixels[i], b.pixels[i],
                           [](int p, int q) { return p == 255 && q < 255; });
    });
    errors.vanished_share = share_of(pixels, [&](std::size_t i) {
        return any_channel(a.pixels[i], b.pixels[i], [](int p, int q) { return p == 0 && q > 0; });
    });
    return errors;
}

}  // namespace twofold
