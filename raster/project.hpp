#pragma once
#include "raster/pass.hpp"
#include "raster/transform.hpp"
#include "raster/vertex.hpp"

/// The end of the vertex stage: division by w, the snap, and the conversion of attributes.
namespace twofold {

/// A window coordinate in snap units, cut toward zero.
constexpr std::int64_t snapped(double x, int fraction_bits) {
    return static_cast<std::int64_t>(x * static_cast<double>(std::int64_t{1} << fraction_bits));
}

/// The colours and coordinates of a vertex whose place is known; `rw` is 1/w.
template <NumericModel M>
void convert_attributes(const M& m, const ClipVertex& v, typename M::Vertex::Word rw,
                        bool perspective, WindowVertex<M>& out) {
    using A = typename M::Vertex;
    using Real = typename M::Real;
    out.inverse_w =
        perspective ? static_cast<Real>(A::to_double(A::emitted_reciprocal(rw))) : Real{1};
    out.color = m.vertex_color(words_of<A>(v.color));
    out.secondary_color = m.vertex_color(words_of<A>(v.secondary_color));
    for (std::size_t u = 0; u < max_units; ++u) {
        const auto coords = words_of<A>(v.coords[u]);
        for (std::size_t k = 0; k < 4; ++k) {
            const bool over_w = M::coords_over_w && perspective;
            out.coords[u][k] =
                static_cast<Real>(A::to_double(over_w ? A::mul(coords[k], rw) : coords[k]));
        }
    }
}

/// A clip-space vertex in the window. It lies inside the guard band: |x|, |y| <= 2^15 pixels.
template <NumericModel M>
WindowVertex<M> project(const M& m, const ClipVertex& v, const Viewport& viewport,
                        bool perspective) {
    using A = typename M::Vertex;
    const auto clip = words_of<A>(v.clip);
    const auto rw = A::clip_reciprocal(clip[3]);
    const auto window = [&](std::size_t k, double offset) {
        return A::to_double(A::sum(A::mul(clip[k], rw), A::from_double(offset)));
    };
    WindowVertex<M> out;
    const int bits = m.snap().fraction_bits;
    out.x = snapped(window(0, viewport.offset.x), bits);
    out.y = snapped(window(1, viewport.offset.y), bits);
    out.z = window(2, viewport.offset.z);
    convert_attributes(m, v, rw, perspective, out);
    return out;
}

/// A vertex that was given in window coordinates: no division, no bias.
template <NumericModel M>
WindowVertex<M> place(const M& m, const ClipVertex& v, bool perspective) {
    using A = typename M::Vertex;
    WindowVertex<M> out;
    const int bits = m.snap().fraction_bits;
    out.x = snapped(v.clip.x, bits);
    out.y = snapped(v.clip.y, bits);
    out.z = v.clip.z;
    convert_attributes(m, v, A::reciprocal(A::from_double(v.clip.w)), perspective, out);
    return out;
}

}  // namespace twofold
