#include "scenes/texture_images.hpp"

namespace twofold {
namespace {

Rgba32f rgba32f_of(const Vec4& c) {
    return {static_cast<float>(c.x), static_cast<float>(c.y), static_cast<float>(c.z),
            static_cast<float>(c.w)};
}

}  // namespace

Texture texture_of(const ByteImage& image) {
    std::vector<Rgba8> texels;
    texels.reserve(image.pixels.size());
    const auto row_size = static_cast<std::ptrdiff_t>(image.width);
    for (int y = image.height - 1; y >= 0; --y) {
        const auto row = image.pixels.begin() + y * row_size;
        texels.insert(texels.end(), row, row + row_size);
    }
    return {image.width, image.height, std::move(texels)};
}

Texture checkerboard(const Checkerboard& spec) {
    std::vector<Rgba32f> texels;
    for (int j = 0; j < spec.height; ++j)
        for (int i = 0; i < spec.width; ++i) {
            const bool odd = ((i / spec.cell + j / spec.cell) & 1) != 0;
            texels.push_back(rgba32f_of(odd ? spec.second : spec.first));
        }
    return {spec.width, spec.height, std::move(texels)};
}

}  // namespace twofold
