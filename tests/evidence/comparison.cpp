#include "tests/evidence/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "texunit/error.hpp"

namespace twofold::evidence {
namespace {

bool contains(const Rectangle& r, int x, int y) {
    return x >= r.x && y >= r.y && x < r.x + r.width && y < r.y + r.height;
}

bool contains(const CompareRegion& region, int x, int y) {
    const auto here = [&](const Rectangle& r) { return contains(r, x, y); };
    return std::any_of(region.include.begin(), region.include.end(), here) &&
           std::none_of(region.exclude.begin(), region.exclude.end(), here);
}

void require_comparable(const ByteImage& ours, const ByteImage& capture,
                        const CompareRegion& region) {
    if (ours.width != capture.width || ours.height != capture.height)
        throw Error(ExitCode::sizes_differ,
                    fmt::format("the capture has {} x {} pixels, the framebuffer {} x {}",
                                capture.width, capture.height, ours.width, ours.height));
    for (const Rectangle& r : region.include)
        if (r.x < 0 || r.y < 0 || r.x + r.width > ours.width || r.y + r.height > ours.height)
            throw Error(ExitCode::failure,
                        fmt::format("compare.include: [{}, {}, {}, {}] reaches out of the picture",
                                    r.x, r.y, r.width, r.height));
}

/// The largest difference of two pixels over the compared channels.
int difference(Rgba8 a, Rgba8 b, const std::array<bool, 4>& channels) {
    const std::array<int, 4> steps{std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b),
                                   std::abs(a.a - b.a)};
    int largest = 0;
    for (std::size_t c = 0; c < 4; ++c)
        if (channels[c]) largest = std::max(largest, steps[c]);
    return largest;
}

/// Calls visit(x, y, inside the region, difference there) for all pixels, row by row.
template <class Visit>
void for_each_pixel(const ByteImage& ours, const ByteImage& capture, const CompareRegion& region,
                    Visit visit) {
    std::size_t i = 0;
    for (int y = 0; y < ours.height; ++y)
        for (int x = 0; x < ours.width; ++x, ++i)
            visit(x, y, contains(region, x, y),
                  difference(ours.pixels[i], capture.pixels[i], region.channels));
}

std::uint8_t dimmed(std::uint8_t value, bool inside) {
    return static_cast<std::uint8_t>(inside ? value / 3 : value / 8);
}

}  // namespace

Comparison compare(const ByteImage& ours, const ByteImage& capture, const CompareRegion& region,
                   const std::vector<std::pair<int, int>>& expected) {
    require_comparable(ours, capture, region);
    Comparison result;
    for_each_pixel(ours, capture, region, [&](int x, int y, bool inside, int steps) {
        if (!inside) return;
        ++result.compared;
        if (steps == 0) return;
        const std::pair at{x, y};
        result.max_difference = std::max(result.max_difference, steps);
        result.wrong.push_back(at);
        if (std::find(expected.begin(), expected.end(), at) == expected.end())
            result.wrong_beyond.push_back(at);
    });
    return result;
}

ByteImage difference_picture(const ByteImage& ours, const ByteImage& capture,
                             const CompareRegion& region) {
    require_comparable(ours, capture, region);
    ByteImage picture{ours.width, ours.height, {}};
    picture.pixels.reserve(ours.pixels.size());
    for_each_pixel(ours, capture, region, [&](int, int, bool inside, int steps) {
        const std::uint8_t grey = dimmed(capture.pixels[picture.pixels.size()].g, inside);
        const auto yellow = static_cast<std::uint8_t>(std::min(255, 8 * steps));
        picture.pixels.push_back(inside && steps > 0 ? Rgba8{255, yellow, 0, 255}
                                                     : Rgba8{grey, grey, grey, 255});
    });
    return picture;
}

}  // namespace twofold::evidence
