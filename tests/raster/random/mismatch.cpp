#include "tests/raster/random/mismatch.hpp"

#include <fmt/format.h>

#include <bit>

namespace twofold::test {
namespace {

bool same_pixel(const Framebuffer& a, const Framebuffer& b, std::size_t i) {
    if (a.bytes[i] != b.bytes[i]) return false;
    for (std::size_t c = 0; c < 4; ++c)
        if (std::bit_cast<std::uint64_t>(a.values[i][c]) !=
            std::bit_cast<std::uint64_t>(b.values[i][c]))
            return false;
    return true;
}

std::string pixel_text(const Framebuffer& picture, std::size_t i) {
    const Rgba8 p = picture.bytes[i];
    const auto& v = picture.values[i];
    return fmt::format("({} {} {} {}) = ({:a} {:a} {:a} {:a})", p.r, p.g, p.b, p.a, v[0], v[1],
                       v[2], v[3]);
}

std::string size_text(const Framebuffer& p) {
    return fmt::format("{} x {} with {} bytes and {} values", p.width, p.height, p.bytes.size(),
                       p.values.size());
}

bool same_size(const Framebuffer& a, const Framebuffer& b) {
    return a.width == b.width && a.height == b.height && a.bytes.size() == b.bytes.size() &&
           a.values.size() == b.values.size();
}

}  // namespace

std::optional<PictureMismatch> mismatch_of(const Framebuffer& expected, const Framebuffer& found) {
    if (!same_size(expected, found))
        return PictureMismatch{0, 0, 0,
                               "expected " + size_text(expected) + ", found " + size_text(found)};
    std::optional<PictureMismatch> mismatch;
    for (std::size_t i = 0; i < expected.bytes.size(); ++i) {
        if (same_pixel(expected, found, i)) continue;
        if (!mismatch) {
            const auto width = static_cast<std::size_t>(expected.width);
            mismatch = PictureMismatch{
                0, static_cast<int>(i % width), static_cast<int>(i / width),
                "expected " + pixel_text(expected, i) + ", found " + pixel_text(found, i)};
        }
        ++mismatch->pixels;
    }
    return mismatch;
}

}  // namespace twofold::test
