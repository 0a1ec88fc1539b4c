#pragma once
#include "raster/color_format.hpp"
#include "raster/fragment_ops.hpp"
#include "raster/shade.hpp"

/// What becomes of a fragment: the tests, the blend and the write. A `Target` holds colour and
/// depth of some pixels: index(x, y), color_at(i), store_color(i, c), depth_at(i), format,
/// depth_bits.
namespace twofold {

/// Blends, cuts to the format's bits and writes. A target of 16 bits cuts the source before the
/// blend too; what it stores enters with zero low bits. Missing alpha reads 1.
/// @source captures of NV2A for the order of cut and blend
template <NumericModel M, class Target>
void write_color(const BoundPass<M>& pass, Color<typename M::Pixel> source, int x, int y,
                 Target& target) {
    const M& m = pass.m;
    const std::size_t at = target.index(x, y);
    Color<typename M::Pixel> stored = target.color_at(at);
    const FormatBits format = bits_of(target.format);
    source = pass.state.dither ? dithered(m, source, format, x, y) : cut(m, source, format);
    if (pass.state.blend) {
        auto destination = stored;
        if (!format.has_alpha) destination[3] = m.pixel(1.0);
        source =
            cut(m, blended(m, *pass.state.blend, {source, destination, pass.blend_color}), format);
    }
    if (!format.has_alpha) source[3] = m.pixel(format.stored_alpha);
    for (std::size_t c = 0; c < 4; ++c)
        if (pass.state.color_mask[c]) stored[c] = source[c];
    target.store_color(at, stored);
}

/// Alpha test and depth test of a shaded fragment for pixel `at` of the target. One that fails
/// changes nothing; without a depth test the depth buffer is not written.
/// @param depth  gives the fragment's depth as the buffer holds it
template <NumericModel M, class Target, class Depth>
bool survives(const BoundPass<M>& pass, typename M::Pixel source_alpha, std::size_t at,
              Depth&& depth, Target& target, DrawCounters& counters) {
    const auto& alpha = pass.state.alpha_test;
    if (alpha && !compare(alpha->func, source_alpha, pass.alpha_reference)) {
        ++counters.alpha_failed;
        return false;
    }
    if (const auto& test = pass.state.depth_test) {
        typename M::Depth& stored = target.depth_at(at);
        const typename M::Depth z = depth();
        if (!compare(test->func, z, stored)) {
            ++counters.depth_failed;
            return false;
        }
        if (test->write) stored = z;
    }
    ++counters.written;
    return true;
}

/// A fragment's whole life: colour, alpha test, depth test, blend, write.
template <NumericModel M, class Target>
void draw_fragment(const BoundPass<M>& pass, const Fragment<M>& f, Target& target,
                   DrawCounters& counters) {
    ++counters.fragments;
    const auto depth = [&] {
        return pass.m.depth(interpolate_depth<M>(f.edge, f.triangle), target.depth_bits);
    };
    const auto source = shade(pass, f, counters);
    const std::size_t at = target.index(f.x, f.y);
    if (!survives(pass, source[3], at, depth, target, counters)) return;
    if (pass.plain_write)
        target.store_color(at, source);
    else
        write_color(pass, source, f.x, f.y, target);
}

}  // namespace twofold
