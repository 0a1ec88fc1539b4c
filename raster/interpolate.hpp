#pragma once
#include "raster/vertex.hpp"
#include "texunit/sample.hpp"

namespace twofold {

/// Window depth: linear in the window, the same for every pass over a triangle (R19).
template <NumericModel M>
double interpolate_depth(const std::array<std::int64_t, 3>& edge,
                         const std::array<WindowVertex<M>, 3>& v) {
    const double e0 = static_cast<double>(edge[0]), e1 = static_cast<double>(edge[1]);
    const double e2 = static_cast<double>(edge[2]);
    return v[0].z + (e1 * (v[1].z - v[0].z) + e2 * (v[2].z - v[0].z)) / (e0 + e1 + e2);
}

template <NumericModel M>
Color<typename M::Channel> interpolate_color(const std::array<std::int64_t, 3>& edge,
                                             const std::array<WindowVertex<M>, 3>& v) {
    const InterpolationWeights<typename M::Real> weights{
        edge, {v[0].inverse_w, v[1].inverse_w, v[2].inverse_w}};
    Color<typename M::Channel> color;
    for (std::size_t c = 0; c < 4; ++c)
        color[c] = M::iterate_color(weights, v[0].color[c], v[1].color[c], v[2].color[c]);
    return color;
}

/// Perspective-correct s, t, q up to a common factor that the division by q removes: the vertices
/// carry them over w, which is linear in the window. @source OpenGL 1.3, equation 3.4
template <NumericModel M>
ProjectiveCoordinates<typename M::Real> interpolate_coords(const std::array<std::int64_t, 3>& edge,
                                                           const std::array<WindowVertex<M>, 3>& v,
                                                           std::size_t unit) {
    using Real = typename M::Real;
    const Real e0 = static_cast<Real>(edge[0]), e1 = static_cast<Real>(edge[1]);
    const Real e2 = static_cast<Real>(edge[2]);
    const auto sum = [&](std::size_t k) {
        return e0 * v[0].coords[unit][k] + e1 * v[1].coords[unit][k] + e2 * v[2].coords[unit][k];
    };
    return {sum(0), sum(1), sum(2)};
}

}  // namespace twofold
