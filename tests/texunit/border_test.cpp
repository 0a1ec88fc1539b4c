#include <catch2/catch.hpp>
#include <cmath>

#include "sample_builders.hpp"
#include "texunit/random.hpp"
#include "texunit/sample.hpp"

/// Textures with border texels, against the text of OpenGL 1.3 written out once more.
using namespace twofold;

namespace {
constexpr Rgba8 constant_border{77, 78, 79, 80};

/// Random texels; sizes are those inside the border, which is one texel wide.
Texture bordered_texture(int width, int height, std::uint64_t seed = 1) {
    std::vector<Rgba8> texels;
    const auto byte = [&](std::uint64_t k) {
        return static_cast<std::uint8_t>(random_u32(seed, k));
    };
    for (int k = 0; k < (width + 2) * (height + 2); ++k) {
        const auto at = 4 * static_cast<std::uint64_t>(k);
        texels.push_back({byte(at), byte(at + 1), byte(at + 2), byte(at + 3)});
    }
    Texture texture{width + 2, height + 2, std::move(texels)};
    texture.border = 1;
    return texture;
}

/// What one axis of a lookup reads: texels i0 and i1, of -1 to n, and the weight of i1.
struct Axis {
    int i0, i1;
    double weight;
};

/// 3.8.5: the coordinate as the wrap mode limits it; mirrored_repeat is that of OpenGL 1.4, 3.8.6.
double wrapped(double s, int n, Wrap wrap) {
    const double half = 1.0 / (2.0 * n), fraction = s - std::floor(s);
    const bool odd = std::fmod(std::fabs(std::floor(s)), 2.0) == 1.0;
    switch (wrap) {
        case Wrap::repeat:
            return fraction;
        case Wrap::clamp:
            return std::fmin(std::fmax(s, 0.0), 1.0);
        case Wrap::clamp_to_edge:
            return std::fmin(std::fmax(s, half), 1.0 - half);
        case Wrap::clamp_to_border:
            return std::fmin(std::fmax(s, -half), 1.0 + half);
        case Wrap::mirrored_repeat:
            break;
    }
    return std::fmin(std::fmax(odd ? 1.0 - fraction : fraction, half), 1.0 - half);
}

/// 3.8.7: equation 3.19, and the i0, i1 and weight of equation 3.20.
Axis axis_by_text(double s, int n, Wrap wrap, Filter filter) {
    const double u = n * wrapped(s, n, wrap);
    if (filter == Filter::nearest) {
        const bool at_end = u == n && wrap != Wrap::clamp_to_border;
        const int i = at_end ? n - 1 : static_cast<int>(std::floor(u));
        return {i, i, 0.0};
    }
    const int i0 = static_cast<int>(std::floor(u - 0.5));
    const double weight = u - 0.5 - std::floor(u - 0.5);
    if (wrap != Wrap::repeat) return {i0, i0 + 1, weight};
    return {(i0 + n) % n, (i0 + 1) % n, weight};
}

/// Beyond the border there is only the constant colour.
Rgba8 texel_by_text(const Texture& texture, int i, int j) {
    const int x = i + 1, y = j + 1;
    if (x < 0 || y < 0 || x >= texture.width || y >= texture.height) return constant_border;
    return std::get<std::vector<Rgba8>>(
        texture.texels)[static_cast<std::size_t>(y * texture.width + x)];
}

template <NumericModel M>
Color<typename M::Channel> lookup_by_text(const M& m, const Texture& texture, Filter filter,
                                          const Axis& x, const Axis& y) {
    const auto texel = [&](int i, int j) { return m.texel(texel_by_text(texture, i, j)); };
    if (filter == Filter::nearest) return texel(x.i0, y.i0);
    using Real = typename M::Real;
    const auto t00 = texel(x.i0, y.i0), t10 = texel(x.i1, y.i0), t01 = texel(x.i0, y.i1),
               t11 = texel(x.i1, y.i1);
    Color<typename M::Channel> result;
    for (std::size_t c = 0; c < 4; ++c)
        result[c] = m.filter(t00[c], t10[c], t01[c], t11[c], static_cast<Real>(x.weight),
                             static_cast<Real>(y.weight));
    return result;
}

/// How many of 41 x 41 lookups from -1.25 to 2.5 are not what the text says. Steps of 3/32 keep all
/// coordinates exact; mirrored ones at whole texels are left out, where the chip's rule is another.
template <NumericModel M>
int wrong_lookups(const M& m, const Texture& texture, Wrap wrap_s, Wrap wrap_t, Filter filter) {
    const auto uploaded = upload(m, texture);
    TextureUnitState unit = unit_with(wrap_s, filter);
    unit.wrap_t = wrap_t;
    const int width = texture.width - 2, height = texture.height - 2;
    const auto tie = [&](double s, int n, Wrap wrap) {
        return filter == Filter::nearest && wrap == Wrap::mirrored_repeat &&
               s * n == std::floor(s * n);
    };
    int wrong = 0;
    for (int a = 0; a <= 40; ++a)
        for (int b = 0; b <= 40; ++b) {
            const double s = -1.25 + a * 3.0 / 32.0, t = -1.25 + b * 3.0 / 32.0;
            if (tie(s, width, wrap_s) || tie(t, height, wrap_t)) continue;
            const auto at = coordinates<typename M::Real>(s, t, 0.0, 1.0);
            wrong += sample(m, uploaded, unit, {at, at, at}, m.texel(constant_border)) !=
                     lookup_by_text(m, texture, filter, axis_by_text(s, width, wrap_s, filter),
                                    axis_by_text(t, height, wrap_t, filter));
        }
    return wrong;
}
}  // namespace

TEMPLATE_LIST_TEST_CASE("border texels are read as the text of OpenGL 1.3 says", "[border]",
                        AllModels) {
    const TestType m{};
    for (const auto& [width, height] : {std::pair{4, 4}, {1, 8}, {8, 1}, {1, 1}, {2, 4}})
        for (const Wrap s : all_wraps)
            for (const Wrap t : all_wraps)
                for (const Filter filter : {Filter::nearest, Filter::linear}) {
                    CAPTURE(width, height, static_cast<int>(s), static_cast<int>(t),
                            static_cast<int>(filter));
                    CHECK(wrong_lookups(m, bordered_texture(width, height), s, t, filter) == 0);
                }
}

TEST_CASE("a border of the constant colour is the same as none", "[border]") {
    const Ideal64 m{};
    Texture with = bordered_texture(4, 2);
    auto& texels = std::get<std::vector<Rgba8>>(with.texels);
    std::vector<Rgba8> inside;
    for (int k = 0; k < 24; ++k) {
        const int i = k % 6, j = k / 6;
        auto& texel = texels[static_cast<std::size_t>(k)];
        if (i > 0 && i < 5 && j > 0 && j < 3)
            inside.push_back(texel);
        else
            texel = constant_border;
    }
    const auto bordered = upload(m, with), plain = upload(m, Texture{4, 2, inside});
    CHECK(bordered.levels[0].texels == plain.levels[0].texels);
    for (const Wrap wrap : all_wraps)
        for (const Filter filter : {Filter::nearest, Filter::linear})
            for (int k = -40; k <= 80; ++k) {
                const auto at = coordinates<double>(k / 37.0, k / 23.0, 0.0, 1.0);
                const auto border = m.texel(constant_border);
                const auto unit = unit_with(wrap, filter);
                CHECK(sample(m, bordered, unit, {at, at, at}, border) ==
                      sample(m, plain, unit, {at, at, at}, border));
            }
}

TEST_CASE("a border keeps of its texels what the base format keeps", "[border]") {
    const Nv17 m{};
    Texture texture = bordered_texture(2, 2);
    texture.base_format = BaseFormat::luminance;
    const Rgba8 corner = std::get<std::vector<Rgba8>>(texture.texels).front();
    const auto at = coordinates<double>(-1.0, -1.0, 0.0, 1.0);
    const auto read = sample(m, upload(m, texture),
                             unit_with(Wrap::clamp_to_border, Filter::nearest), {at, at, at}, {});
    CHECK(read == Color<int>{corner.r, corner.r, corner.r, 255});
}

TEMPLATE_LIST_TEST_CASE("every mipmap level has its own border", "[border]", AllModels) {
    using M = TestType;
    using Real = typename M::Real;
    const M m{};
    Texture texture = bordered_texture(8, 8, 2);
    for (int size = 4; size >= 1; size /= 2) {
        auto level = bordered_texture(size, size, 10 + static_cast<std::uint64_t>(size));
        texture.mipmaps.push_back({level.width, level.height, std::move(level.texels)});
    }
    const auto uploaded = upload(m, texture);
    TextureUnitState unit = unit_with(Wrap::clamp_to_border, Filter::nearest);
    unit.mip_filter = MipFilter::nearest;
    for (int k = 0; k < 4; ++k) {
        const double step = (1 << k) / 8.0;
        const auto read = sample(m, uploaded, unit,
                                 {coordinates<Real>(-1.0, -1.0, 0.0, 1.0),
                                  coordinates<Real>(-1.0 + step, -1.0, 0.0, 1.0),
                                  coordinates<Real>(-1.0, -1.0 + step, 0.0, 1.0)},
                                 m.texel(constant_border));
        CHECK(uploaded.levels[static_cast<std::size_t>(k)].width == 8 >> k);
        CHECK(read == uploaded.levels[static_cast<std::size_t>(k)].bordered.front());
    }
}

TEMPLATE_LIST_TEST_CASE("a cube map's face blends with its own border", "[border]", AllModels) {
    using M = TestType;
    using Real = typename M::Real;
    const M m{};
    Texture cube = bordered_texture(4, 4, 20);
    for (std::uint64_t face = 1; face < 6; ++face) {
        Texture next = bordered_texture(4, 4, 20 + face);
        cube.cube_faces.push_back({next.width, next.height, std::move(next.texels)});
    }
    const auto uploaded = upload(m, cube);
    TextureUnitState unit = unit_with(Wrap::clamp, Filter::linear);
    unit.target = TextureTarget::cube_map;
    // +x, at s = 0 and in the middle of texel row 1: sc = -z = -|x|, tc = -y = -|x| / 4.
    const auto positive = coordinates<Real>(4.0, 1.0, 4.0, 1.0);
    const auto negative = coordinates<Real>(-4.0, 1.0, -4.0, 1.0);
    for (const auto& [at, face] :
         {std::pair{positive, CubeFace::positive_x}, {negative, CubeFace::negative_x}}) {
        const auto& texels = uploaded.face(face)[0].bordered;
        const auto& outer = texels[2 * 6];
        const auto& inner = texels[2 * 6 + 1];
        const auto read = sample(m, uploaded, unit, {at, at, at}, m.texel(constant_border));
        for (std::size_t c = 0; c < 4; ++c)
            CHECK(read[c] == m.filter(outer[c], inner[c], outer[c], inner[c], Real{0.5}, Real{0}));
    }
}
