#include <fmt/format.h>

#include <algorithm>

#include "scenes/scene_names.hpp"
#include "scenes/scene_parts.hpp"
#include "texunit/texture_format.hpp"

/// Textures.
namespace twofold::scene_io {
namespace {

Checkerboard read_checkerboard(const JsonValue& value) {
    const JsonObject fields(value, {"width", "height", "cell", "first", "second"});
    const Checkerboard absent;
    return {.width = fields.integer("width", 1, 4096, absent.width),
            .height = fields.integer("height", 1, 4096, absent.height),
            .cell = fields.integer("cell", 1, 4096, absent.cell),
            .first = fields.vec4("first", unit_interval, absent.first),
            .second = fields.vec4("second", unit_interval, absent.second)};
}

std::vector<std::uint8_t> read_bytes(const JsonValue& value, std::size_t count) {
    std::vector<std::uint8_t> bytes;
    bytes.reserve(count);
    for (const JsonValue& byte : value.elements(count, count))
        bytes.push_back(static_cast<std::uint8_t>(byte.integer(0, 255)));
    return bytes;
}

InlineTexels read_texels(const JsonValue& value) {
    const JsonObject fields(value, {"width", "height", "format", "bytes"});
    constexpr int most = static_cast<int>(max_inline_texels);
    InlineTexels image;
    image.width = fields.at("width").integer(1, most);
    image.height = fields.at("height").integer(1, most);
    if (image.width * image.height > most)
        value.fail(fmt::format("{} x {} are more than {} texels, which are for a file", image.width,
                               image.height, most));
    PackedTexels& texels = image.texels;
    texels.format = fields.enumerator("format", texture_format_names, texels.format);
    texels.bytes =
        read_bytes(fields.at("bytes"), bytes_of(texels.format, image.width, image.height));
    return image;
}

TextureImageSpec read_image_kind(const JsonObject& fields, std::string_view kind) {
    if (kind == "file") return TextureFile{.path = fields.at(kind).text()};
    if (kind == "checkerboard") return read_checkerboard(fields.at(kind));
    return read_texels(fields.at(kind));
}

TextureImageSpec read_face(const JsonValue& value) {
    const JsonObject fields(value, {"file", "checkerboard", "texels"});
    return read_image_kind(fields, fields.one_of({"file", "checkerboard", "texels"}));
}

std::vector<TextureImageSpec> read_cube(const JsonValue& value) {
    const JsonObject fields(value, {"faces"});
    std::vector<TextureImageSpec> faces;
    for (const JsonValue& face : fields.at("faces").elements(6, 6))
        faces.push_back(read_face(face));
    return faces;
}

/// What the image's own format holds: all four channels unless its texels say otherwise.
BaseFormat natural_base_format(const TextureImageSpec& image) {
    const auto* texels = std::get_if<InlineTexels>(&image);
    return texels ? base_format_of(texels->texels.format) : BaseFormat::rgba;
}

bool any_compressed(const std::vector<TextureImageSpec>& images) {
    return std::any_of(images.begin(), images.end(), [](const TextureImageSpec& image) {
        const auto* texels = std::get_if<InlineTexels>(&image);
        return texels != nullptr && is_block_compressed(texels->texels.format);
    });
}

}  // namespace

TextureSpec read_texture(const JsonValue& value) {
    const JsonObject fields(
        value, {"file", "checkerboard", "texels", "cube", "base_format", "mipmaps", "border"});
    const std::string_view kind = fields.one_of({"file", "checkerboard", "texels", "cube"});
    TextureSpec texture;
    texture.images =
        kind == "cube" ? read_cube(fields.at(kind)) : std::vector{read_image_kind(fields, kind)};
    texture.base_format = fields.enumerator("base_format", base_format_names,
                                            natural_base_format(texture.images.front()));
    texture.mipmaps = fields.enumerator("mipmaps", mipmaps_names, texture.mipmaps);
    texture.border = fields.integer("border", 0, 1, texture.border);
    if (texture.border != 0 && any_compressed(texture.images))
        fields.at("border").fail("compressed texels have no border");
    return texture;
}

}  // namespace twofold::scene_io
