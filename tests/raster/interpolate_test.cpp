#include "raster/interpolate.hpp"

#include <catch2/catch.hpp>

#include "texunit/presets.hpp"

namespace {
using namespace twofold;

template <NumericModel M>
std::array<WindowVertex<M>, 3> corners() {
    std::array<WindowVertex<M>, 3> v{};
    const std::array<double, 3> depth{0.25, 0.5, 1.0}, w{1.0, 0.5, 0.25};
    for (std::size_t k = 0; k < 3; ++k) {
        const auto byte = static_cast<std::uint8_t>(50 + 100 * k);
        v[k].z = depth[k];
        v[k].inverse_w = static_cast<typename M::Real>(w[k]);
        v[k].color = M::texel(Rgba8{byte, 7, static_cast<std::uint8_t>(255 - byte), 255});
        // Texture coordinates (k, 1 - k) over w.
        const auto rw = v[k].inverse_w;
        const auto s = static_cast<typename M::Real>(k);
        v[k].coords[1] = {s * rw, (1 - s) * rw, 0, rw};
    }
    return v;
}
}  // namespace

TEMPLATE_TEST_CASE("at a vertex everything has that vertex's value", "[interpolate]", Ideal64,
                   Float32, Gl13, Nv17) {
    using M = TestType;
    const auto v = corners<M>();
    for (std::size_t k = 0; k < 3; ++k) {
        std::array<std::int64_t, 3> e{};
        e[k] = 1000;
        CHECK(interpolate_depth<M>(e, v) == v[k].z);
        CHECK(M{}.to_unorm8(M{}.finish(interpolate_color<M>(
                  M{}, e, v, &WindowVertex<M>::color)[0])) == 50 + 100 * static_cast<int>(k));
        const auto at = interpolate_coords<M>(e, v, 1);
        CHECK(at.s / at.q == static_cast<typename M::Real>(k));
        CHECK(at.t / at.q == 1 - static_cast<typename M::Real>(k));
    }
}

TEMPLATE_TEST_CASE("depth is linear in the window whatever w is", "[interpolate]", Ideal64, Float32,
                   Gl13, Nv17) {
    using M = TestType;
    CHECK(interpolate_depth<M>({2, 1, 1}, corners<M>()) == 0.5);
    CHECK(interpolate_depth<M>({0, 1, 1}, corners<M>()) == 0.75);
}

TEMPLATE_TEST_CASE("coordinates and colours are correct in perspective", "[interpolate]", Ideal64,
                   Float32, Gl13, Nv17) {
    using M = TestType;
    const auto v = corners<M>();
    // Half-way on the screen between vertices 0 and 1 the weights are 1 : 1/2.
    const auto at = interpolate_coords<M>({5, 5, 0}, v, 1);
    CHECK(static_cast<double>(at.s / at.q) == Approx(1.0 / 3));
    CHECK(static_cast<double>(at.t / at.q) == Approx(2.0 / 3));
    const auto color = interpolate_color<M>(M{}, {5, 5, 0}, v, &WindowVertex<M>::color);
    // 50 + 100 / 3; on nv17 vertex 1 gets 86/256, what the cut of 170.67 leaves.
    CHECK(M{}.to_unorm8(M{}.finish(color[0])) == (M::preset == Preset::nv17 ? 84 : 83));
    CHECK(M{}.to_unorm8(M{}.finish(color[1])) == 7);
    CHECK(M{}.to_unorm8(M{}.finish(color[3])) == 255);
}
