#include "study/pictures.hpp"

#include <fmt/format.h>

#include "texunit/byte_arithmetic.hpp"
#include "texunit/fnv1a.hpp"

namespace twofold {
namespace {

/// Calls `append` for each texel, rows from the top.
template <class Texel, class Append>
void from_the_top(const Texture& texture, const std::vector<Texel>& texels, Append&& append) {
    const auto width = static_cast<std::size_t>(texture.width);
    for (std::size_t row = static_cast<std::size_t>(texture.height); row-- > 0;)
        for (std::size_t i = 0; i < width; ++i) append(texels[row * width + i]);
}

template <class T>
std::string hex_hash(T&& feed) {
    Fnv1a hash;
    feed(hash);
    return fmt::format("{:016x}", hash.value());
}

void feed_image(Fnv1a& hash, const ByteImage& image) {
    hash.u32(static_cast<std::uint32_t>(image.width)).u32(static_cast<std::uint32_t>(image.height));
    hash.u32(4);
    for (const Rgba8 p : image.pixels) hash.u8(p.r).u8(p.g).u8(p.b).u8(p.a);
}

}  // namespace

ByteImage byte_image(const Framebuffer& picture) {
    return {picture.width, picture.height, picture.bytes};
}

FloatImage float_image(const Framebuffer& picture) {
    FloatImage image{picture.width, picture.height, 4, {}};
    for (const auto& value : picture.values)
        for (const double c : value) image.samples.push_back(static_cast<float>(c));
    return image;
}

ByteImage byte_image(const Texture& texture) {
    ByteImage image{texture.width, texture.height, {}};
    if (const auto* bytes = std::get_if<std::vector<Rgba8>>(&texture.texels)) {
        from_the_top(texture, *bytes, [&](Rgba8 t) { image.pixels.push_back(t); });
    } else {
        from_the_top(texture, std::get<std::vector<Rgba32f>>(texture.texels),
                     [&](const Rgba32f& t) {
                         const auto byte = [](float x) {
                             return static_cast<std::uint8_t>(rn8(static_cast<double>(x)));
                         };
                         image.pixels.push_back({byte(t[0]), byte(t[1]), byte(t[2]), byte(t[3])});
                     });
    }
    return image;
}

FloatImage float_image(const Texture& texture) {
    FloatImage image{texture.width, texture.height, 4, {}};
    const auto append = [&](float x) { image.samples.push_back(x); };
    if (const auto* bytes = std::get_if<std::vector<Rgba8>>(&texture.texels)) {
        from_the_top(texture, *bytes, [&](Rgba8 t) {
            for (const int c : {t.r, t.g, t.b, t.a}) append(static_cast<float>(c) / 255.0f);
        });
    } else {
        from_the_top(texture, std::get<std::vector<Rgba32f>>(texture.texels),
                     [&](const Rgba32f& t) {
                         for (const float c : t) append(c);
                     });
    }
    return image;
}

std::string hash_of(const Framebuffer& picture) {
    return hex_hash([&](Fnv1a& hash) { feed_image(hash, byte_image(picture)); });
}

std::string hash_of(const Texture& texture) {
    return hex_hash([&](Fnv1a& hash) { feed_image(hash, byte_image(texture)); });
}

std::string hash_of(const FactorMap& map) {
    return hex_hash([&](Fnv1a& hash) {
        for (const Texture& face : faces_of(map.bytes)) feed_image(hash, byte_image(face));
    });
}

std::string hash_of_t1(const ProductTerm& term) {
    if (term.vertices.empty()) return hash_of(term.t1);
    return hex_hash([&](Fnv1a& hash) {
        for (const Rgb& c : term.vertices) hash.f64(c.x).f64(c.y).f64(c.z);
    });
}

}  // namespace twofold
