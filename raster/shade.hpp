#pragma once
#include "raster/assemble.hpp"
#include "raster/bind.hpp"
#include "raster/interpolate.hpp"
#include "texunit/tex_env.hpp"

/// A fragment's colour, from the vertices' attributes to what the fragment operations get.
namespace twofold {

/// One covered pixel of a triangle.
template <NumericModel M>
struct Fragment {
    int x, y;
    const WindowTriangle<M>& triangle;
    const TriangleSetup& setup;
    EdgeValues edge;
};

template <NumericModel M>
SamplePoint<typename M::Real> with_neighbours(const BoundPass<M>& pass, const BoundUnit<M>& unit,
                                              const Fragment<M>& f,
                                              const ProjectiveCoordinates<typename M::Real>& here) {
    SamplePoint<typename M::Real> at{here, {}, {}};
    if (!unit.derivatives) return at;
    const int bits = pass.m.snap().fraction_bits;
    at.right = interpolate_coords<M>(moved(f.edge, f.setup, bits, 1, 0), f.triangle, unit.index);
    at.below = interpolate_coords<M>(moved(f.edge, f.setup, bits, 0, 1), f.triangle, unit.index);
    return at;
}

template <NumericModel M>
Color<typename M::Channel> sampled_texel(const BoundPass<M>& pass, const BoundUnit<M>& unit,
                                         const Fragment<M>& f, DrawCounters& counters) {
    const auto here = interpolate_coords<M>(f.edge, f.triangle, unit.index);
    if (undefined_coordinates(unit.state, here)) ++counters.undefined_coords;
    if (unit.only_image)
        return sample_image(pass.m, *unit.only_image, unit.addressing, unit.state.mag_filter, here,
                            unit.border);
    return sample(pass.m, *unit.texture, unit.state, with_neighbours(pass, unit, f, here),
                  unit.border);
}

/// The vertices' secondary colour and, as its alpha, the fog factor.
template <NumericModel M>
Color<typename M::Channel> secondary_color(const BoundPass<M>& pass, const Fragment<M>& f) {
    return interpolate_color<M>(pass.m, f.edge, f.triangle, &WindowVertex<M>::secondary_color);
}

/// The register combiners in place of environments, colour sum and fog. A texture register without
/// a unit holds (0, 0, 0, 1).
template <NumericModel M>
Color<typename M::Channel> combined_color(const BoundPass<M>& pass, const Fragment<M>& f,
                                          const Color<typename M::Channel>& primary,
                                          DrawCounters& counters) {
    CombinerInputs<M> in{};
    in.primary = primary;
    in.secondary = secondary_color(pass, f);
    in.fog = pass.fog_color;
    in.fog[3] = in.secondary[3];
    in.texture.fill({0, 0, 0, pass.m.one()});
    for (const BoundUnit<M>& unit : pass.units)
        in.texture[unit.index] = sampled_texel(pass, unit, f, counters);
    return run_combiners(pass.m, *pass.combiners, in);
}

/// Colour sum and fog. @source OpenGL 1.3, 3.9 and 3.10
template <NumericModel M>
void add_secondary_and_fog(const BoundPass<M>& pass, const Fragment<M>& f,
                           Color<typename M::Channel>& color) {
    const auto secondary = secondary_color(pass, f);
    for (std::size_t c = 0; c < 3; ++c) {
        if (pass.state.color_sum) color[c] = pass.m.clamp_unsigned(color[c] + secondary[c]);
        if (pass.state.fog) color[c] = pass.m.lerp(color[c], pass.fog_color[c], secondary[3]);
    }
}

/// What a unit makes of the colour it gets. The paper's products take the short way; it gives the
/// same.
template <NumericModel M>
Color<typename M::Channel> environment_color(const M& m, const BoundUnit<M>& unit,
                                             const Color<typename M::Channel>& previous,
                                             const Color<typename M::Channel>& texel,
                                             const Color<typename M::Channel>& primary) {
    if (!unit.only_modulates)
        return apply_combine(m, unit.env,
                             CombineSources<M>{texel, unit.env_color, primary, previous});
    Color<typename M::Channel> product;
    for (std::size_t c = 0; c < 4; ++c) product[c] = m.modulate(texel[c], previous[c]);
    return product;
}

template <NumericModel M>
Color<typename M::Pixel> shade(const BoundPass<M>& pass, const Fragment<M>& f,
                               DrawCounters& counters) {
    const auto primary = interpolate_color<M>(pass.m, f.edge, f.triangle, &WindowVertex<M>::color);
    auto color = primary;
    if (pass.combiners) {
        color = combined_color(pass, f, primary, counters);
    } else {
        for (const BoundUnit<M>& unit : pass.units)
            color = environment_color(pass.m, unit, color, sampled_texel(pass, unit, f, counters),
                                      primary);
        if (pass.state.color_sum || pass.state.fog) add_secondary_and_fog(pass, f, color);
    }
    return {pass.m.finish(color[0]), pass.m.finish(color[1]), pass.m.finish(color[2]),
            pass.m.finish(color[3])};
}

}  // namespace twofold
