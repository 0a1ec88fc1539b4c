#include "raster/clip.hpp"
#include "raster/coverage.hpp"
#include "tests/platforms/named_hash.hpp"

namespace twofold::platforms {
namespace {

WindowPoint snapped_point(std::size_t i, std::size_t place, int bits) {
    // A quarter of the corners lies on pixel centres.
    const int one = 1 << bits;
    const bool on_centre = integer(i, place + 20, 0, 3) == 0;
    const auto coordinate = [&](std::size_t k) {
        const int x = integer(i, k, -8 * one, 40 * one);
        return std::int64_t{on_centre ? x / one * one + one / 2 : x};
    };
    return {coordinate(place), coordinate(place + 1)};
}

/// Pixels and edge values of small triangles.
NamedHash coverage_hash(int bits) {
    Fnv1a hash;
    for (std::size_t i = 0; i < 128; ++i) {
        const auto t = set_up(
            {snapped_point(i, 1, bits), snapped_point(i, 4, bits), snapped_point(i, 7, bits)});
        feed(hash, t.doubled_area);
        for_each_covered_pixel(t, bits, {0, 0, 32, 32},
                               [&](int x, int y, const std::array<std::int64_t, 3>& e) {
                                   feed(hash, x);
                                   feed(hash, y);
                                   feed(hash, e);
                               });
    }
    return {fmt::format("coverage/{}-bits", bits), hash.value()};
}

ClipVertex clip_vertex(std::size_t i, std::size_t place, double reach) {
    ClipVertex v{};
    const auto at = [&](std::size_t k) { return real(i, place + k, -reach, reach); };
    const double x = at(0), y = at(1), z = at(2), w = at(3);
    v.clip = {x, y, z, w};
    v.color = Vec4{real(i, place + 4, 0.0, 1.0)};
    v.coords[0] = Vec4{real(i, place + 5, -1.0, 1.0)};
    return v;
}

NamedHash clip_hash(double reach) {
    Fnv1a hash;
    const Viewport viewport = viewport_of(640, 480, {4, 1.0 / 32.0});
    for (std::size_t i = 0; i < 256; ++i) {
        const ClippedPolygon polygon =
            clip({clip_vertex(i, 1, reach), clip_vertex(i, 11, reach), clip_vertex(i, 21, reach)},
                 viewport, {640, 480});
        feed(hash, static_cast<int>(polygon.result));
        for (std::size_t k = 0; k < polygon.size; ++k) {
            feed(hash, polygon.vertices[k].clip);
            feed(hash, polygon.vertices[k].color);
            feed(hash, polygon.vertices[k].coords[0]);
        }
    }
    return {fmt::format("clip/reach-{}", reach), hash.value()};
}

}  // namespace

Hashes triangle_hashes() {
    Hashes hashes;
    for (const int bits : {0, 1, 4, 8, 12}) hashes.push_back(coverage_hash(bits));
    for (const double reach : {1.0, 100.0, 1000.0, 1e6, 1e12}) hashes.push_back(clip_hash(reach));
    return hashes;
}

}  // namespace twofold::platforms
