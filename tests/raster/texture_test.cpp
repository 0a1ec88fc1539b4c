#include <catch2/catch.hpp>

#include "raster/frame_check.hpp"
#include "tests/raster/builders.hpp"
#include "texunit/error.hpp"

/// Textures of a frame: which are refused, and what reaches the lookup.
namespace {
using namespace twofold;
using namespace twofold::test;

TextureImage plain_image(int size, Rgba8 texel) {
    return {size, size, std::vector<Rgba8>(static_cast<std::size_t>(size * size), texel)};
}

/// Six faces of 64 x 64 with all their levels: red tells the face, green the level.
Texture leveled_cube() {
    const auto image = [](int face, int level) {
        return plain_image(64 >> level, {static_cast<std::uint8_t>(40 * face),
                                         static_cast<std::uint8_t>(30 * level), 0, 255});
    };
    const auto mipmaps = [&](int face) {
        std::vector<TextureImage> levels;
        for (int level = 1; level <= 6; ++level) levels.push_back(image(face, level));
        return levels;
    };
    Texture cube{64, 64, image(0, 0).texels, BaseFormat::rgba, mipmaps(0)};
    for (int face = 1; face < 6; ++face)
        cube.cube_faces.push_back({64, 64, image(face, 0).texels, mipmaps(face)});
    return cube;
}

/// 16 x 16 pixels that show one face whole.
Frame face_frame(int face) {
    Mesh mesh = rectangle(0, 0, 16, 16);
    const double sign = face % 2 == 0 ? 1.0 : -1.0;
    const int axis = face / 2;
    for (Vec4& t : mesh.texcoords[0]) {
        const Vec4 at = t;
        t = Vec4{0, 0, 0, 1};
        t[axis] = sign;
        t[(axis + 1) % 3] = 2.0 * at.x - 1.0;
        t[(axis + 2) % 3] = 2.0 * at.y - 1.0;
    }
    PassState state;
    TextureUnitState unit;
    unit.texture = 0;
    unit.target = TextureTarget::cube_map;
    unit.mip_filter = MipFilter::nearest;
    unit.env.mode = TexEnvMode::replace;
    state.units[0] = unit;
    Frame frame = pixel_frame(16, 16, mesh, state);
    frame.textures = {leveled_cube()};
    return frame;
}

/// What check_frame() says of a frame with this texture, or "accepted".
std::string error_of(const Texture& texture) {
    Frame frame = pixel_frame(4, 4, rectangle(0, 0, 4, 4));
    frame.textures = {texture};
    try {
        check_frame(frame);
    } catch (const Error& error) {
        return error.what();
    }
    return "accepted";
}

Texture bordered(int width, int height, const Texels& texels, int border = 1) {
    Texture texture{width, height, texels};
    texture.border = border;
    return texture;
}
}  // namespace

TEST_CASE("64 texels on 16 pixels are a cube map's level 2 on every face", "[reference]") {
    for (const Preset preset : faithful_presets)
        for (int face = 0; face < 6; ++face) {
            CAPTURE(name_of(preset), face);
            const Framebuffer picture = render_reference(face_frame(face), preset);
            const Rgba8 expected{static_cast<std::uint8_t>(40 * face), 60, 0, 255};
            CHECK(picture.bytes == std::vector<Rgba8>(256, expected));
        }
}

TEST_CASE("a drawn border is that of its image", "[reference]") {
    Frame frame = pixel_frame(8, 8, rectangle(0, 0, 8, 8));
    frame.meshes[0].texcoords[0] = {{-1, -1, 0, 1}, {1, -1, 0, 1}, {1, 1, 0, 1}, {-1, 1, 0, 1}};
    std::vector<Rgba8> texels(9, Rgba8{10, 0, 0, 255});
    texels[4] = {200, 0, 0, 255};
    frame.textures = {bordered(3, 3, texels)};
    TextureUnitState unit;
    unit.texture = 0;
    unit.wrap_s = unit.wrap_t = Wrap::clamp_to_border;
    unit.min_filter = unit.mag_filter = Filter::nearest;
    unit.env.mode = TexEnvMode::replace;
    unit.border_color = Vec4{1.0};
    frame.passes[0].state.units[0] = unit;
    for (const Preset preset : faithful_presets)
        CHECK(red_histogram(render_reference(frame, preset)) ==
              std::map<int, int>{{10, 48}, {200, 16}});
}

TEST_CASE("borders and levels that cannot be are refused", "[reference]") {
    const std::vector<Rgba8> nine(9), four(4);
    CHECK(error_of(bordered(3, 3, nine)) == "accepted");
    CHECK(error_of(bordered(3, 3, nine, 2)) == "texture 0: border 2 is not 0 or 1");
    CHECK(error_of(bordered(2, 2, four)) == "texture 0: 2 x 2 has nothing inside its border");
    CHECK(
        error_of(bordered(4, 4, PackedTexels{TextureFormat::dxt1, std::vector<std::uint8_t>(8)})) ==
        "texture 0: compressed texels have no border");
    Texture level = bordered(4, 4, std::vector<Rgba8>(16));
    level.mipmaps = {{2, 2, four}};
    CHECK(error_of(level) == "texture 0: 2 x 2 has nothing inside its border");
    Texture cube = leveled_cube();
    CHECK(error_of(cube) == "accepted");
    cube.cube_faces[3].mipmaps.pop_back();
    CHECK(error_of(cube) == "texture 0: a face of 5 mipmaps in a cube map of 6");
}
