#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <type_traits>
#include <vector>

#include "raster/bind.hpp"
#include "raster/lane_image.hpp"
#include "raster/window_mesh.hpp"

/// How far down the levels of a texture the fragments of a triangle can reach, found before it is
/// drawn. Most triangles of most pictures magnify the base.
namespace twofold {

template <NumericModel M>
TriangleSetup setup_of(const WindowMesh<M>& mesh, const MeshTriangle& t) {
    const auto point = [&](std::size_t k) {
        const PlacedVertex<M>& v = mesh.vertices[t.vertex[k]];
        return WindowPoint{v.x, v.y};
    };
    return set_up({point(0), point(1), point(2)});
}

/// The rho^2 of squared_scale() below which a level of detail is at most `lambda`. 0.999 is further
/// than the logarithms stray.
inline double squared_scale_of(double lambda, double bias) {
    constexpr double log_4 = 0x1.62e42fefa39efp+0;
    return 0.999 * exact::exp((lambda - bias) * log_4);
}

/// The rho^2 up to which a unit magnifies the base.
template <NumericModel M>
double magnified_reach(const BoundUnit<M>& unit) {
    return squared_scale_of(magnified_to(unit.state, unit.chooses_level), unit.state.lod_bias);
}

/// The rho^2 up to which vectors need not choose a level. Where only minification blends four
/// texels they choose always: weights of nearest texels are 0 only so (reads_four).
template <NumericModel M>
double only_base_reach(const BoundUnit<M>& unit) {
    const bool nearest_among_linear =
        unit.state.mag_filter == Filter::nearest && unit.state.min_filter == Filter::linear;
    return nearest_among_linear ? -1.0 : magnified_reach(unit);
}

/// For each level the rho^2 up to which a unit reads none beyond it.
template <NumericModel M>
std::vector<double> level_reaches(const BoundUnit<M>& unit) {
    std::vector<double> reaches{magnified_reach(unit)};
    for (std::size_t k = 1; k < levels_read(unit).size(); ++k)
        reaches.push_back(squared_scale_of(static_cast<double>(k), unit.state.lod_bias));
    reaches.back() = std::numeric_limits<double>::infinity();
    return reaches;
}

/// What a pixel's step adds to the doubled areas, and what coordinates are weighed with beside
/// them.
struct CoordinateSteps {
    double area;
    std::array<double, 3> dx, dy, weight;
};

template <NumericModel M>
CoordinateSteps coordinate_steps(const WindowMesh<M>& mesh, const MeshTriangle& triangle,
                                 const TriangleSetup& setup, int fraction_bits) {
    const double pixel = static_cast<double>(std::int64_t{1} << fraction_bits);
    CoordinateSteps steps{static_cast<double>(setup.doubled_area), {}, {}, {1.0, 1.0, 1.0}};
    for (std::size_t k = 0; k < 3; ++k) {
        steps.dx[k] = static_cast<double>(setup.edge[k].a) * pixel;
        steps.dy[k] = static_cast<double>(setup.edge[k].b) * pixel;
        if (!M::coords_over_w)
            steps.weight[k] = static_cast<double>(mesh.vertices[triangle.vertex[k]].inverse_w);
    }
    return steps;
}

/// Corners' places in an image, in texels, and their q.
struct CornerPlaces {
    std::array<double, 3> u, v, q;
};

/// @param coords  s, t, r, q; @param size  of the image, in texels
template <class Real>
CornerPlaces corner_places(const CoordinateSteps& steps,
                           const std::array<const std::array<Real, 4>*, 3>& coords,
                           const std::array<double, 2>& size) {
    CornerPlaces at;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto own = static_cast<double>((*coords[k])[3]), over = 1.0 / own;
        at.q[k] = steps.weight[k] * own;
        at.u[k] = static_cast<double>((*coords[k])[0]) * size[0] * over;
        at.v[k] = static_cast<double>((*coords[k])[1]) * size[1] * over;
    }
    return at;
}

inline double largest_of(const std::array<double, 3>& x) {
    return std::max({std::fabs(x[0]), std::fabs(x[1]), std::fabs(x[2])});
}

/// A bound of what a pixel's step adds to u = U / Q all over a triangle. U and Q are linear in the
/// window, so it is (U' - u Q') / (Q + Q'), where U' and Q' are the step's: u and Q lie between the
/// corners'.
/// @param step    what the step adds to each corner's weight, times its q
/// @param behind  the least Q + Q'; @param stray  what a format's rounding makes of Q at most
inline double way_bound(const std::array<double, 3>& step, const std::array<double, 3>& u,
                        double behind, double stray) {
    const double u10 = u[1] - u[0], u20 = u[2] - u[0], u21 = u[2] - u[1];
    const double way = largest_of({step[1] * u10 + step[2] * u20, step[2] * u21 - step[0] * u10,
                                   step[0] * u20 + step[1] * u21});
    return (way + 4.0 * stray * largest_of(u)) / behind;
}

/// A bound of the square of the way that a pixel's step makes in an image.
/// @param d  what the step adds to the doubled areas; @param ulps  a format's rounding, some times
inline double squared_way_bound(const CoordinateSteps& steps, const std::array<double, 3>& d,
                                const CornerPlaces& at, double ulps) {
    const std::array<double, 3> step{d[0] * at.q[0], d[1] * at.q[1], d[2] * at.q[2]};
    const double least_q = std::min({std::fabs(at.q[0]), std::fabs(at.q[1]), std::fabs(at.q[2])});
    const double stray = ulps * largest_of(at.q) * (steps.area + 3.0 * largest_of(d));
    const double behind = steps.area * least_q - std::fabs(step[0] + step[1] + step[2]) - stray;
    if (!(behind > 0.0)) return std::numeric_limits<double>::infinity();
    const double u = way_bound(step, at.u, behind, stray);
    const double v = way_bound(step, at.v, behind, stray);
    return u * u + v * v;
}

/// A bound of squared_scale() all over a triangle; infinite if there is none.
/// @param coords  s, t, r, q of the corners, all q of one sign; @param size  of the base in texels
template <class Real>
double squared_scale_bound(const CoordinateSteps& steps,
                           const std::array<const std::array<Real, 4>*, 3>& coords,
                           const std::array<double, 2>& size) {
    const double ulps = std::is_same_v<Real, float> ? 0x1p-19 : 0x1p-44;
    const CornerPlaces at = corner_places(steps, coords, size);
    return std::max(squared_way_bound(steps, steps.dx, at, ulps),
                    squared_way_bound(steps, steps.dy, at, ulps));
}

}  // namespace twofold
