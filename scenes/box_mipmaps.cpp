#include "scenes/box_mipmaps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <utility>

#include "texunit/error.hpp"
#include "texunit/ideal64.hpp"
#include "texunit/texture_format.hpp"

namespace twofold {
namespace {

using Texel = std::array<double, 4>;

/// One level before it is stored; width and height are those inside its border.
struct Level {
    int width = 0, height = 0, border = 0;
    std::vector<Texel> texels;

    const Texel& at(int i, int j) const {
        const int row = width + 2 * border;
        return texels[static_cast<std::size_t>(j + border) * static_cast<std::size_t>(row) +
                      static_cast<std::size_t>(i + border)];
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

/// The two texels along one axis, `size` long, that texel k of the next level averages: a single
/// one stands for both, and so does a border texel.
std::pair<int, int> halves(int k, int size) {
    if (k < 0) return {-1, -1};
    if (k >= std::max(size / 2, 1)) return {size, size};
    return size > 1 ? std::pair{2 * k, 2 * k + 1} : std::pair{0, 0};
}

Level halved(const Level& above) {
    const int border = above.border;
    Level level{std::max(above.width / 2, 1), std::max(above.height / 2, 1), border, {}};
    for (int j = -border; j < level.height + border; ++j)
        for (int i = -border; i < level.width + border; ++i) {
            const auto [i0, i1] = halves(i, above.width);
            const auto [j0, j1] = halves(j, above.height);
            level.texels.push_back(
                average(above.at(i0, j0), above.at(i1, j0), above.at(i0, j1), above.at(i1, j1)));
        }
    return level;
}

TextureImage stored(const Level& level) {
    std::vector<Rgba32f> texels;
    texels.reserve(level.texels.size());
    for (const Texel& t : level.texels)
        texels.push_back({static_cast<float>(t[0]), static_cast<float>(t[1]),
                          static_cast<float>(t[2]), static_cast<float>(t[3])});
    const int frame = 2 * level.border;
    return {level.width + frame, level.height + frame, std::move(texels)};
}

bool is_power_of_two(int size) {
    return size > 0 && std::has_single_bit(static_cast<unsigned>(size));
}

}  // namespace

bool has_sides_to_halve(int width, int height, int border) {
    return is_power_of_two(width - 2 * border) && is_power_of_two(height - 2 * border);
}

std::vector<TextureImage> box_mipmaps(int width, int height, const Texels& texels, int border) {
    const int inner_width = width - 2 * border, inner_height = height - 2 * border;
    if (!has_sides_to_halve(width, height, border))
        throw Error(ExitCode::failure,
                    fmt::format("mipmaps: the sides of {} x {} are not powers of two", inner_width,
                                inner_height));
    Level level{inner_width, inner_height, border, std::visit(RealTexels{width, height}, texels)};
    std::vector<TextureImage> levels;
    while (level.width > 1 || level.height > 1) {
        level = halved(level);
        levels.push_back(stored(level));
    }
    return levels;
}

}  // namespace twofold
