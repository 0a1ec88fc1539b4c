#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "texunit/texture.hpp"

/// The pictures that descriptions of captures name by a rule instead of listing texels. Row 0 is
/// the top row; in a texture it is the row at t = 0.
namespace twofold::evidence {

/// Squares of `size` texels; the one at (0, 0) is `first`.
struct Checkerboard {
    Rgba8 first, second;
    int size = 1;
};

/// A checkerboard in one rectangle, counted from the rectangle's corner, and one colour around it.
struct CheckerboardWindow {
    Checkerboard inside;
    Rgba8 outside;
    int x = 0, y = 0, width = 0, height = 0;
};

struct ConstantColor {
    Rgba8 value;
};

/// What a channel of a gradient follows: coordinates run from 0 to 255 over the picture.
enum class Ramp { x, y, inverted_y, x_plus_y };

/// Each channel r, g, b, a is a ramp or one value.
struct Gradient {
    std::array<std::variant<Ramp, std::uint8_t>, 4> channels;
};

/// Four gradients of half the size, and an alpha that falls from the centre to 0 in the corners.
struct RadialAlphaPattern {};

/// Squares of `size` texels in eight colours, opaque and translucent by turns, along the diagonals.
struct ColouredCheckerboard {
    int size = 1;
};

using TexelRule = std::variant<Checkerboard, CheckerboardWindow, ConstantColor, Gradient,
                               RadialAlphaPattern, ColouredCheckerboard>;

/// All texels that the rule gives for a picture of width x height.
ByteImage picture_of(const TexelRule& rule, int width, int height);

/// The same picture with red and blue exchanged.
ByteImage with_red_and_blue_swapped(ByteImage picture);

/// The luminance floor(0.299 r + 0.587 g + 0.114 b), each operation rounded to binary32.
std::uint8_t luminance(Rgba8 texel);

/// A picture as a texture of `format` stores it: components lose their low bits, luminance formats
/// get luminance().
PackedTexels stored(const ByteImage& picture, TextureFormat format);

}  // namespace twofold::evidence
