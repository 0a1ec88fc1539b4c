#include "scenes/box_mipmaps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

#include "texunit/error.hpp"
#include "texunit/ideal64.hpp"
#include "texunit/texture_format.hpp"

namespace twofold {
namespace {

using Texel = std::array<double, 4>;

/// One level before it is stored.
struct Level {
    int width = 0, height = 0;
    std::vector<Texel> texels;

    const Texel& at(int i, int j) const {
        return texels[static_cast<std::size_t>(j) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(i)];
    }
};

struct RealTexels {
    int width, height;

    std::vector<Texel> operator()(const PackedTexels& packed) const {
        return decode(Ideal64{}, packed, width, height);
    }
    template <class T>
    std::vector<Texel> operator()(const std::vector<T>& texels) const {
        std::vector<Texel> result;
        result.reserve(texels.size());
        for (const T& texel : texels) result.push_back(Ideal64::texel(texel));
        return result;
    }
};

Texel average(const Texel& a, const Texel& b, const Texel& c, const Texel& d) {
    Texel result{};
    for (std::size_t k = 0; k < result.size(); ++k) result[k] = (a[k] + b[k] + c[k] + d[k]) / 4.0;
    return result;
}

/// Where one side is a single texel already, that texel stands for both.
Level halved(const Level& above) {
    Level level{std::max(above.width / 2, 1), std::max(above.height / 2, 1), {}};
    const int di = above.width > 1 ? 1 : 0, dj = above.height > 1 ? 1 : 0;
    for (int j = 0; j < level.height; ++j)
        for (int i = 0; i < level.width; ++i) {
            const int i0 = i << di, j0 = j << dj;
            level.texels.push_back(average(above.at(i0, j0), above.at(i0 + di, j0),
                                           above.at(i0, j0 + dj), above.at(i0 + di, j0 + dj)));
        }
    return level;
}

TextureImage stored(const Level& level) {
    std::vector<Rgba32f> texels;
    texels.reserve(level.texels.size());
    for (const Texel& t : level.texels)
        texels.push_back({static_cast<float>(t[0]), static_cast<float>(t[1]),
                          static_cast<float>(t[2]), static_cast<float>(t[3])});
    return {level.width, level.height, std::move(texels)};
}

bool is_power_of_two(int size) {
    return size > 0 && std::has_single_bit(static_cast<unsigned>(size));
}

}  // namespace

std::vector<TextureImage> box_mipmaps(int width, int height, const Texels& texels) {
    if (!is_power_of_two(width) || !is_power_of_two(height))
        throw Error(
            ExitCode::failure,
            fmt::format("mipmaps: the sides of {} x {} are not powers of two", width, height));
    Level level{width, height, std::visit(RealTexels{width, height}, texels)};
    std::vector<TextureImage> levels;
    while (level.width > 1 || level.height > 1) {
        level = halved(level);
        levels.push_back(stored(level));
    }
    return levels;
}

}  // namespace twofold
