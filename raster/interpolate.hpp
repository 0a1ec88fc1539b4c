#pragma once
#include "raster/setup.hpp"
#include "raster/vertex.hpp"
#include "texunit/sample.hpp"

namespace twofold {

/// Window depth: linear in the window, the same for every pass over a triangle (R19).
template <NumericModel M>
double interpolate_depth(const EdgeValues& edge, const std::array<WindowVertex<M>, 3>& v) {
    const double e0 = static_cast<double>(edge[0]), e1 = static_cast<double>(edge[1]);
    const double e2 = static_cast<double>(edge[2]);
    return v[0].z + (e1 * (v[1].z - v[0].z) + e2 * (v[2].z - v[0].z)) / (e0 + e1 + e2);
}

/// One of the vertices' two colours: `&WindowVertex<M>::color` or
/// `&WindowVertex<M>::secondary_color`.
template <NumericModel M>
Color<typename M::Channel> interpolate_color(const M& m, const EdgeValues& edge,
                                             const std::array<WindowVertex<M>, 3>& v,
                                             Color<typename M::Channel> WindowVertex<M>::*member) {
    const InterpolationWeights<typename M::Real> weights{
        edge, {v[0].inverse_w, v[1].inverse_w, v[2].inverse_w}};
    Color<typename M::Channel> color;
    for (std::size_t c = 0; c < 4; ++c)
        color[c] =
            m.iterate_color(weights, (v[0].*member)[c], (v[1].*member)[c], (v[2].*member)[c]);
    return color;
}

/// The weight of each vertex for coordinates, up to a common factor. Where the vertices carry them
/// over w the doubled areas are the weights; where not, 1/w comes in here. Equal w drop out, so
/// that coordinates which are exact integers stay so.
template <NumericModel M>
std::array<typename M::Real, 3> coordinate_weights(const EdgeValues& edge,
                                                   const std::array<WindowVertex<M>, 3>& v) {
    using Real = typename M::Real;
    std::array<Real, 3> w{static_cast<Real>(edge[0]), static_cast<Real>(edge[1]),
                          static_cast<Real>(edge[2])};
    const bool equal = v[0].inverse_w == v[1].inverse_w && v[1].inverse_w == v[2].inverse_w;
    if (!M::coords_over_w && !equal)
        for (std::size_t k = 0; k < 3; ++k) w[k] *= v[k].inverse_w;
    return w;
}

/// Perspective-correct s, t, r, q up to a common factor that the division by q removes.
/// @source OpenGL 1.3, equation 3.4
template <NumericModel M>
ProjectiveCoordinates<typename M::Real> interpolate_coords(const EdgeValues& edge,
                                                           const std::array<WindowVertex<M>, 3>& v,
                                                           std::size_t unit) {
    const auto w = coordinate_weights<M>(edge, v);
    const auto sum = [&](std::size_t k) {
        return w[0] * v[0].coords[unit][k] + w[1] * v[1].coords[unit][k] +
               w[2] * v[2].coords[unit][k];
    };
    return {sum(0), sum(1), sum(2), sum(3)};
}

/// Edge values `dx`, `dy` pixels further.
inline EdgeValues moved(const EdgeValues& edge, const TriangleSetup& setup, int fraction_bits,
                        int dx, int dy) {
    EdgeValues e = edge;
    const std::int64_t one = std::int64_t{1} << fraction_bits;
    for (std::size_t k = 0; k < 3; ++k) e[k] += (setup.edge[k].a * dx + setup.edge[k].b * dy) * one;
    return e;
}

}  // namespace twofold
