#include <catch2/catch.hpp>
#include <cmath>

#include "sample_builders.hpp"
#include "texunit/sample.hpp"

/// The levels of a cube map's faces.
using namespace twofold;

namespace {
/// Six faces of 16 x 16 down to 1 x 1: red tells the face, green the level.
Texture leveled_cube() {
    const auto image = [](int face, int level) {
        const int size = 16 >> level;
        const Rgba8 texel{static_cast<std::uint8_t>(40 * face),
                          static_cast<std::uint8_t>(50 * level), 0, 255};
        return TextureImage{size, size,
                            std::vector<Rgba8>(static_cast<std::size_t>(size * size), texel)};
    };
    const auto levels = [&](int face) {
        std::vector<TextureImage> mipmaps;
        for (int level = 1; level <= 4; ++level) mipmaps.push_back(image(face, level));
        return mipmaps;
    };
    Texture cube{16, 16, image(0, 0).texels, BaseFormat::rgba, levels(0)};
    for (int face = 1; face < 6; ++face)
        cube.cube_faces.push_back({16, 16, image(face, 0).texels, levels(face)});
    return cube;
}

/// A direction on face 2 axis + (sign < 0): `sign` along the axis, (a, b) along the next two.
template <class Real>
ProjectiveCoordinates<Real> direction(int axis, double sign, double a, double b) {
    std::array<double, 3> d{};
    d[static_cast<std::size_t>(axis)] = sign;
    d[static_cast<std::size_t>((axis + 1) % 3)] = a;
    d[static_cast<std::size_t>((axis + 2) % 3)] = b;
    return coordinates<Real>(d[0], d[1], d[2], 1.0);
}

TextureUnitState cube_unit(MipFilter mip) {
    TextureUnitState unit = unit_with(Wrap::clamp_to_edge, Filter::nearest);
    unit.target = TextureTarget::cube_map;
    unit.mip_filter = mip;
    return unit;
}
}  // namespace

/// A step of x along the face is x / 2 of its 16 texels: rho = 8 x, lambda = 3 + log2 x.
TEMPLATE_LIST_TEST_CASE("a cube map's level follows the steps along the fragment's face",
                        "[cube_map]", AllModels) {
    using M = TestType;
    using Real = typename M::Real;
    const M m{};
    const auto texture = upload(m, leveled_cube());
    for (int face = 0; face < 6; ++face)
        for (int level = 0; level <= 4; ++level) {
            const double sign = face % 2 == 0 ? 1.0 : -1.0, step = std::ldexp(1.0, level - 3);
            const auto at = [&](double a, double b) {
                return direction<Real>(face / 2, sign, a, b);
            };
            const auto read =
                sample(m, texture, cube_unit(MipFilter::nearest),
                       {at(-0.25, 0.0), at(-0.25 + step, 0.0), at(-0.25, -step / 2)}, {});
            CHECK(read == m.texel(Rgba8{static_cast<std::uint8_t>(40 * face),
                                        static_cast<std::uint8_t>(50 * level), 0, 255}));
        }
}

/// Half-way in direction between two levels of 50 steps; a neighbour on the next face is laid on
/// the fragment's own.
TEST_CASE("levels of a cube map are blended, across its edges too", "[cube_map]") {
    const Ideal64 m{};
    const auto texture = upload(m, leveled_cube());
    const double step = std::exp2(1.5 - 3.0);
    for (const double a : {-0.25, 0.9}) {
        const auto read =
            sample(m, texture, cube_unit(MipFilter::linear),
                   {direction<double>(2, 1.0, a, 0.0), direction<double>(2, 1.0, a + step, 0.0),
                    direction<double>(2, 1.0, a, 0.0)},
                   {});
        CHECK(read[0] == Approx(160.0 / 255.0));
        CHECK(read[1] == Approx(75.0 / 255.0));
    }
}

TEST_CASE("a cube map's faces wrap as any image does", "[cube_map]") {
    const Nv17 m{};
    const std::vector<Rgba8> columns{
        {10, 0, 0, 255}, {50, 0, 0, 255}, {10, 0, 0, 255}, {50, 0, 0, 255}};
    Texture cube{2, 2, columns};
    for (int face = 1; face < 6; ++face) cube.cube_faces.push_back({2, 2, columns});
    const auto texture = upload(m, cube);
    // +x at s = 0: the first column, blended with what the wrap mode puts beyond it.
    const std::array expected{30, 44, 10, 44, 10};
    for (std::size_t w = 0; w < all_wraps.size(); ++w) {
        TextureUnitState unit = unit_with(all_wraps[w], Filter::linear);
        unit.target = TextureTarget::cube_map;
        CHECK(red_at(m, texture, unit,
                     {coordinates<double>(1, 0, 1, 1), coordinates<double>(1, 0, 1, 1),
                      coordinates<double>(1, 0, 1, 1)}) == expected[w]);
    }
}
