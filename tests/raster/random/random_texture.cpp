#include "scenes/box_mipmaps.hpp"
#include "scenes/texture_images.hpp"
#include "tests/raster/random/random_parts.hpp"
#include "texunit/byte_arithmetic.hpp"
#include "texunit/paraboloid.hpp"
#include "texunit/texture_format.hpp"

/// Small textures of every format.
namespace twofold::test {
namespace {

std::size_t texel_count(int width, int height) {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
}

std::uint8_t random_byte(Dice& dice) { return static_cast<std::uint8_t>(dice.bits() >> 56); }

/// Alpha is often 0 or 255, or the same everywhere: what alpha tests are made for.
std::vector<Rgba8> random_bytes(Dice& dice, std::size_t count) {
    const int kind = dice.integer(0, 2);
    const std::uint8_t all = dice.one_of<std::uint8_t>({0, 127, 128, 255, 255});
    std::vector<Rgba8> texels;
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint64_t bits = dice.bits();
        const auto byte = [bits](int k) { return static_cast<std::uint8_t>(bits >> (8 * k)); };
        const std::uint8_t edge = (bits >> 40 & 3) != 0 ? 255 : 0;
        texels.push_back(
            {byte(0), byte(1), byte(2), kind == 0 ? byte(3) : (kind == 1 ? edge : all)});
    }
    return texels;
}

/// A chequer is what a scene file can say of floats.
Texels random_floats(Dice& dice, int width, int height) {
    if (dice.chance(0.5))
        return checkerboard(
                   {width, height, dice.integer(1, 3), random_color(dice), random_color(dice)})
            .texels;
    std::vector<Rgba32f> texels;
    for (std::size_t i = 0; i < texel_count(width, height); ++i) {
        const Vec4 c = random_color(dice);
        texels.push_back({static_cast<float>(c.x), static_cast<float>(c.y), static_cast<float>(c.z),
                          static_cast<float>(c.w)});
    }
    return texels;
}

PackedTexels random_packed(Dice& dice, int width, int height, TextureFormat format) {
    PackedTexels texels{format, std::vector<std::uint8_t>(bytes_of(format, width, height))};
    for (std::uint8_t& byte : texels.bytes) byte = random_byte(dice);
    return texels;
}

Texels random_texels(Dice& dice, int width, int height, int kind, TextureFormat format) {
    if (kind < 5) return random_bytes(dice, texel_count(width, height));
    if (kind < 7) return random_floats(dice, width, height);
    return random_packed(dice, width, height, format);
}

int random_side(Dice& dice) {
    return dice.chance(0.06) ? 64 : dice.one_of({1, 2, 3, 4, 4, 5, 7, 8, 8, 16, 16, 17});
}

}  // namespace

Texture random_texture(Dice& dice) {
    const int kind = dice.integer(0, 10);
    const auto format = dice.up_to(TextureFormat::dxt5);
    const bool cube = dice.chance(0.1);
    const int inner_width = cube ? dice.integer(1, 8) : random_side(dice);
    const int inner_height = cube ? inner_width : random_side(dice);
    const int border = kind < 8 && dice.chance(0.1) ? 1 : 0;
    const int width = inner_width + 2 * border, height = inner_height + 2 * border;
    Texture texture{width, height, random_texels(dice, width, height, kind, format)};
    if (std::holds_alternative<PackedTexels>(texture.texels))
        texture.base_format = base_format_of(format);
    if (dice.chance(0.2)) texture.base_format = dice.up_to(BaseFormat::rgba);
    for (int face = 1; cube && face < 6; ++face)
        texture.cube_faces.push_back(
            {width, height, random_texels(dice, width, height, kind, format)});
    texture.border = std::holds_alternative<PackedTexels>(texture.texels) ? 0 : border;
    if (!cube && has_sides_to_halve(width, height, texture.border) && dice.chance(0.4))
        texture.mipmaps = box_mipmaps(width, height, texture.texels, texture.border);
    return texture;
}

Rgba8 byte_color(const Vec4& color) {
    const auto byte = [](double x) { return static_cast<std::uint8_t>(rn8(x)); };
    return {byte(color.x), byte(color.y), byte(color.z), byte(color.w)};
}

std::vector<Rgba8> as_bytes(const std::vector<Rgba32f>& texels) {
    std::vector<Rgba8> bytes;
    for (const Rgba32f& t : texels) bytes.push_back(byte_color({t[0], t[1], t[2], t[3]}));
    return bytes;
}

Texture random_disc(Dice& dice, int size, double guard) {
    std::vector<Rgba8> texels = random_bytes(dice, texel_count(size, size));
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x)
            texels[static_cast<std::size_t>(y * size + x)].a =
                texel_is_opaque(x, y, size, guard) ? 255 : 0;
    return {size, size, std::move(texels)};
}

}  // namespace twofold::test
