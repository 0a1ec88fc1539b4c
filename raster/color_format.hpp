#pragma once
#include <array>

#include "raster/framebuffer.hpp"
#include "raster/pass.hpp"

/// What a framebuffer format keeps of a colour.
namespace twofold {

struct FormatBits {
    std::array<int, 3> rgb;
    bool has_alpha;
    double stored_alpha;  ///< written where there is no alpha
};

constexpr FormatBits bits_of(ColorFormat format) {
    switch (format) {
        case ColorFormat::rgba8888:
            break;
        case ColorFormat::xrgb8888_z:
            return {{8, 8, 8}, false, 0.0};
        case ColorFormat::xrgb8888_o:
            return {{8, 8, 8}, false, 1.0};
        case ColorFormat::rgb565:
            return {{5, 6, 5}, false, 1.0};
        case ColorFormat::xrgb1555_z:
            return {{5, 5, 5}, false, 0.0};
        case ColorFormat::xrgb1555_o:
            return {{5, 5, 5}, false, 1.0};
    }
    return {{8, 8, 8}, true, 1.0};
}

/// The 4 x 4 Bayer matrix in sixteenths of a step, by (y & 3, x & 3). @source chosen
inline constexpr std::array<std::array<int, 4>, 4> bayer{
    {{0, 8, 2, 10}, {12, 4, 14, 6}, {3, 11, 1, 9}, {15, 7, 13, 5}}};

/// Red, green and blue cut to the format's bits, the low bits zero; alpha as it is.
template <NumericModel M>
Color<typename M::Pixel> cut(const M& m, Color<typename M::Pixel> c, const FormatBits& format) {
    for (std::size_t k = 0; k < 3; ++k) c[k] = m.quantise(c[k], format.rgb[k]);
    return c;
}

/// The same with a fraction of a step added first that depends on the pixel.
template <NumericModel M>
Color<typename M::Pixel> dithered(const M& m, Color<typename M::Pixel> c, const FormatBits& format,
                                  int x, int y) {
    const int sixteenths = bayer[static_cast<std::size_t>(y & 3)][static_cast<std::size_t>(x & 3)];
    for (std::size_t k = 0; k < 3; ++k)
        if (format.rgb[k] < 8) c[k] = m.add_dither(c[k], format.rgb[k], sixteenths);
    return cut(m, c, format);
}

}  // namespace twofold
