#include "scenes/box_mipmaps.hpp"
#include "tests/platforms/preset_input.hpp"
#include "texunit/sample.hpp"

namespace twofold::platforms {
namespace {

Texture texture(int border) {
    const int size = 16 + 2 * border;
    const auto texels = [size](std::uint64_t seed) {
        return random_texels(seed, static_cast<std::size_t>(size * size));
    };
    Texture t{size, size, texels(1)};
    t.border = border;
    t.mipmaps = box_mipmaps(size, size, t.texels, border);
    for (std::uint64_t face = 2; face < 7; ++face)
        t.cube_faces.push_back({size, size, texels(face), {}});
    return t;
}

/// Far in and outside, often on a texel's centre or edge, q not always 1.
template <NumericModel M>
SamplePoint<typename M::Real> place(const M&, std::size_t i, double size) {
    using Real = typename M::Real;
    const bool on_grid = integer(i, 9, 0, 3) == 0;
    const double q = integer(i, 8, 0, 1) == 0 ? 1.0 : real(i, 4, 0.1, 3.0);
    const auto coordinate = [&](std::size_t k) {
        const double x = on_grid ? integer(i, k, -64, 96) / 32.0 : real(i, k, -2.0, 3.0);
        return x * size * q;
    };
    const double step = real(i, 5, 0.0, 0.5) * size;
    const double s = coordinate(1), t = coordinate(2), r = real(i, 3, -2.0, 2.0);
    const auto at = [&](double ds, double dt) {
        return ProjectiveCoordinates<Real>{static_cast<Real>(s + ds), static_cast<Real>(t + dt),
                                           static_cast<Real>(r), static_cast<Real>(q)};
    };
    return {at(0.0, 0.0), at(step, 0.25 * step), at(-0.5 * step, step)};
}

template <NumericModel M>
NamedHash lookup(const M& m, const std::string& what, const TextureUnitState& unit,
                 const UploadedTexture<M>& texture) {
    const auto border = constant_color(m, Vec4{0.2, 0.4, 0.6, 0.8});
    const double size = unit.target == TextureTarget::rectangle ? 16.0 : 1.0;
    return hash_over(preset_name("sample", m, what), 128, [&](std::size_t i) {
        return sample(m, texture, unit, place(m, i, size), border);
    });
}

template <NumericModel M>
Hashes wrap_hashes(const M& m, const UploadedTexture<M>& plain,
                   const UploadedTexture<M>& bordered) {
    Hashes hashes;
    for (int wrap = 0; wrap < 5; ++wrap)
        for (const Filter filter : {Filter::nearest, Filter::linear}) {
            TextureUnitState unit;
            unit.wrap_s = unit.wrap_t = static_cast<Wrap>(wrap);
            unit.min_filter = unit.mag_filter = filter;
            const std::string what =
                fmt::format("{}-wrap-{}", filter == Filter::linear ? "linear" : "nearest", wrap);
            hashes.push_back(lookup(m, what, unit, plain));
            hashes.push_back(lookup(m, what + "-with-border", unit, bordered));
        }
    return hashes;
}

template <NumericModel M>
Hashes level_hashes(const M& m, const UploadedTexture<M>& texture) {
    Hashes hashes;
    for (int mip = 0; mip < 3; ++mip)
        for (const Filter filter : {Filter::nearest, Filter::linear}) {
            TextureUnitState unit;
            unit.min_filter = filter;
            unit.mip_filter = static_cast<MipFilter>(mip);
            unit.lod_bias = 0.25;
            hashes.push_back(lookup(m, fmt::format("levels-{}-{}", mip, static_cast<int>(filter)),
                                    unit, texture));
        }
    return hashes;
}

template <NumericModel M>
Hashes target_hashes(const M& m, const UploadedTexture<M>& texture) {
    TextureUnitState cube, rectangle;
    cube.target = TextureTarget::cube_map;
    rectangle.target = TextureTarget::rectangle;
    return {lookup(m, "cube-map", cube, texture), lookup(m, "rectangle", rectangle, texture)};
}

}  // namespace

Hashes lookup_hashes() {
    return over_presets([](const auto& m) {
        const auto plain = upload(m, texture(0)), bordered = upload(m, texture(1));
        Hashes hashes = wrap_hashes(m, plain, bordered);
        append(hashes, level_hashes(m, plain));
        append(hashes, target_hashes(m, plain));
        return hashes;
    });
}

}  // namespace twofold::platforms
