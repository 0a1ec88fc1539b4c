#include "bench/tables.hpp"

#include <algorithm>

#include "texunit/random.hpp"

namespace twofold::bench {
namespace {

std::uint8_t random_byte(std::uint64_t seed, std::uint64_t index) {
    const std::uint32_t bits = random_u32(seed, index);
    switch (bits >> 30) {
        case 0:
            return 0;
        case 1:
            return 255;
        default:
            return static_cast<std::uint8_t>(bits);
    }
}

std::uint8_t byte_at(int value) { return static_cast<std::uint8_t>(std::clamp(value, 0, 255)); }

void append_square(Mesh& mesh, int i, int j, int n) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const Vec2 corner : {Vec2(0, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)}) {
        const double s = (i + corner.x) / n, t = (j + corner.y) / n;
        mesh.positions.emplace_back(2.0 * s - 1.0, 2.0 * t - 1.0, 0.0);
        mesh.normals.emplace_back(0.0, 0.0, 1.0);
        mesh.texcoords[0].emplace_back(s, t, 0.0, 1.0);
    }
    mesh.indices.insert(mesh.indices.end(),
                        {first, first + 1, first + 2, first, first + 2, first + 3});
}

}  // namespace

Frame empty_frame(int size) {
    Frame frame;
    frame.width = size;
    frame.height = size;
    frame.clear_color = color_of(key_color);
    return frame;
}

Vec4 color_of(Rgba8 bytes) { return Vec4{bytes.r, bytes.g, bytes.b, bytes.a} / 255.0; }

Rgba8 random_bytes(std::uint64_t seed, std::uint64_t index) {
    return {random_byte(seed, 4 * index), random_byte(seed, 4 * index + 1),
            random_byte(seed, 4 * index + 2), random_byte(seed, 4 * index + 3)};
}

std::vector<Rgba8> random_texels(std::uint64_t seed, int width, int height) {
    std::vector<Rgba8> texels;
    const auto count = static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height);
    for (std::uint64_t i = 0; i < count; ++i) texels.push_back(random_bytes(seed, i));
    return texels;
}

Texture random_texture(std::uint64_t seed, int size, BaseFormat format) {
    return {size, size, random_texels(seed, size, size), format};
}

Texture smooth_texture(int size, int rise) {
    std::vector<Rgba8> texels;
    for (int j = 0; j < size; ++j)
        for (int i = 0; i < size; ++i)
            texels.push_back({byte_at(rise * i), byte_at(rise * j), byte_at(rise * (i + j) / 2),
                              byte_at(255 - rise * (i + j) / 2)});
    return {size, size, std::move(texels)};
}

Mesh squares(int n, std::uint64_t seed, bool shared_color) {
    Mesh mesh;
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) append_square(mesh, i, j, n);
    for (std::size_t v = 0; v < mesh.positions.size(); ++v)
        mesh.colors.push_back(color_of(random_bytes(seed, shared_color ? v / 4 : v)));
    return mesh;
}

Mesh squares_at_depths(int n, std::uint64_t seed, int levels) {
    Mesh mesh = squares(n, seed, true);
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        const auto level = random_u32(seed + 1, v / 4) % static_cast<std::uint32_t>(levels);
        mesh.positions[v].z = (static_cast<double>(level) + 0.5) / levels * 2.0 - 1.0;
    }
    return mesh;
}

TextureUnitState nearest_unit(std::size_t index, const TexEnv& env) {
    TextureUnitState unit;
    unit.texture = index;
    unit.min_filter = Filter::nearest;
    unit.mag_filter = Filter::nearest;
    unit.env = env;
    return unit;
}

}  // namespace twofold::bench
