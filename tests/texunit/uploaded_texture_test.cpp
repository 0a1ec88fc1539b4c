#include "texunit/uploaded_texture.hpp"

#include <catch2/catch.hpp>
#include <tuple>

#include "texunit/presets.hpp"

namespace {
using namespace twofold;

using AllModels = std::tuple<Ideal64, Float32, Gl13, Nv2x, Nv17, Coarse8, Custom>;

template <NumericModel M>
int shown(const M& m, typename M::Channel channel) {
    return m.to_unorm8(m.finish(channel));
}

template <NumericModel M>
std::array<int, 4> shown(const M& m, const Color<typename M::Channel>& c) {
    return {shown(m, c[0]), shown(m, c[1]), shown(m, c[2]), shown(m, c[3])};
}
}  // namespace

TEMPLATE_LIST_TEST_CASE("uploading keeps rows and channels in place", "[sample]", AllModels) {
    const TestType m{};
    const auto texture = upload(m, {2, 1, std::vector<Rgba8>{{1, 2, 3, 4}, {250, 251, 252, 253}}});
    REQUIRE(texture.levels.size() == 1);
    REQUIRE(texture.levels[0].texels.size() == 2);
    CHECK(shown(m, texture.levels[0].texels[0]) == std::array{1, 2, 3, 4});
    CHECK(shown(m, texture.levels[0].texels[1]) == std::array{250, 251, 252, 253});
}

TEST_CASE("a float texture above 1 is kept by the float presets and cut by the 8-bit ones",
          "[sample]") {
    const Rgba32f bright{2.0f, 0.3f, -1.0f, 1.0f};
    CHECK(Ideal64{}.texel(bright)[0] == 2.0);
    CHECK(Float32{}.texel(bright)[1] == 0.3f);
    CHECK(Gl13{}.texel(bright)[0] == 1.0);
    CHECK(Gl13{}.texel(bright)[2] == 0.0);
    CHECK(Nv17{}.texel(bright) == Color<int>{255, 77, 0, 255});
}

TEMPLATE_LIST_TEST_CASE("a base format keeps its components where the environment looks",
                        "[sample]", AllModels) {
    const TestType m{};
    const auto kept = [&](BaseFormat format) {
        const auto texture = upload(m, {1, 1, std::vector<Rgba8>{{10, 20, 30, 40}}, format});
        CHECK(texture.base_format == format);
        return shown(m, texture.levels[0].texels[0]);
    };
    CHECK(kept(BaseFormat::alpha) == std::array{0, 0, 0, 40});
    CHECK(kept(BaseFormat::luminance) == std::array{10, 10, 10, 255});
    CHECK(kept(BaseFormat::luminance_alpha) == std::array{10, 10, 10, 40});
    CHECK(kept(BaseFormat::intensity) == std::array{10, 10, 10, 10});
    CHECK(kept(BaseFormat::rgb) == std::array{10, 20, 30, 255});
    CHECK(kept(BaseFormat::rgba) == std::array{10, 20, 30, 40});
}

TEMPLATE_LIST_TEST_CASE("mipmaps and faces follow the base image, packed or not", "[sample]",
                        AllModels) {
    const TestType m{};
    Texture texture{2, 2, PackedTexels{TextureFormat::l8, {1, 2, 3, 4}}};
    texture.mipmaps.push_back({1, 1, std::vector<Rgba8>{{9, 8, 7, 6}}});
    const auto mipmapped = upload(m, texture);
    CHECK(mipmapped.has_mipmaps());
    CHECK(mipmapped.levels[1].width == 1);
    CHECK(shown(m, mipmapped.levels[0].texels[3]) == std::array{4, 4, 4, 255});
    CHECK(shown(m, mipmapped.levels[1].texels[0]) == std::array{9, 8, 7, 6});
    CHECK(shown(m, mipmapped.face(CubeFace::negative_z)[0].texels[0]) == std::array{1, 1, 1, 255});

    Texture cube{1, 1, std::vector<Rgba8>{{0, 0, 0, 0}}};
    for (std::uint8_t k = 1; k < 6; ++k)
        cube.cube_faces.push_back({1, 1, std::vector<Rgba8>{{k, k, k, k}}});
    const auto uploaded = upload(m, cube);
    CHECK_FALSE(uploaded.has_mipmaps());
    for (int k = 0; k < 6; ++k)
        CHECK(shown(m, uploaded.face(static_cast<CubeFace>(k))[0].texels[0]) ==
              std::array{k, k, k, k});
}

TEMPLATE_LIST_TEST_CASE("T11 white is one texel of ones", "[hard][T11]", AllModels) {
    const TestType m{};
    const auto white = white_texture(m);
    CHECK(white.base_format == BaseFormat::rgba);
    CHECK(white.levels[0].width == 1);
    CHECK(white.levels[0].texels.size() == 1);
    CHECK(shown(m, white.levels[0].texels[0]) == std::array{255, 255, 255, 255});
}
