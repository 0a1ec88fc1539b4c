#pragma once
#include "raster/bind.hpp"
#include "raster/color_format.hpp"

/// What a picture holds before its first pass, and how it leaves the framebuffer.
namespace twofold {

/// The clear colour as the frame's format keeps it.
template <NumericModel M>
Color<typename M::Pixel> clear_color(const M& m, const Frame& frame) {
    return cut(m, pixels_of(m, frame.clear_color), bits_of(frame.color_format));
}

/// The initial colour of pixel i of a frame that has a picture to start from.
template <NumericModel M>
Color<typename M::Pixel> initial_color(const M& m, const Frame& frame, std::size_t i) {
    const Rgba8 p = frame.initial_color->pixels[i];
    return cut(m, pixels_of(m, Vec4{p.r, p.g, p.b, p.a} / 255.0), bits_of(frame.color_format));
}

/// Appends a pixel to a finished picture.
template <NumericModel M>
void append_pixel(const M& m, const Color<typename M::Pixel>& c, Framebuffer& out) {
    out.bytes.push_back(
        {m.to_unorm8(c[0]), m.to_unorm8(c[1]), m.to_unorm8(c[2]), m.to_unorm8(c[3])});
    out.values.push_back({m.to_real(c[0]), m.to_real(c[1]), m.to_real(c[2]), m.to_real(c[3])});
}

}  // namespace twofold
