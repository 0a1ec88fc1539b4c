#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "factor/half_angle.hpp"
#include "factor/measured_data.hpp"
#include "factor/solver.hpp"
#include "texunit/texture.hpp"

/// The BRDF itself, homomorphically factored: f(l, v) ~ alpha p(l) q(h) p(v) in binary32. It has a
/// value in every direction, measured or not, and is what the paper integrates in place of measured
/// data. On an isotropic surface p and q are symmetric about the normal, whatever the tangents: the
/// unknowns are the values along one radius of each map, so a row has 2 + 2 + 2 weights.
/// @source McCool, Ang & Ahmad, Homomorphic Factorization of BRDFs for High-Performance Rendering,
///         2001; seed paper, section 3.2
namespace twofold {

/// Values at even steps of the unit interval, linear between.
struct Profile {
    std::vector<Rgba32f> nodes;
};

/// p lies over the paraboloid radius tan(theta / 2), q over (1 - cos theta_h)^(1/4).
struct ProductBrdf {
    Rgba32f alpha{};  ///< p and q have the maximum 1
    Profile p, q;
};

/// tan(theta / 2) of an angle of cosine >= 0.
inline double paraboloid_radius(double cosine) {
    const double inside = cosine < 1.0 ? cosine : 1.0;
    return std::sqrt((1.0 - inside) / (1.0 + inside));
}

/// (1 - n.h)^(1/4) of HalfAngle alone.
inline double half_coordinate(double n_l, double n_v, double square) {
    const double s = std::sqrt(square > 1e-30 ? square : 1e-30);
    const double sum = n_l + n_v;
    return std::sqrt(std::sqrt(1.0 - (sum < s ? sum / s : 1.0)));
}

/// A profile's value at a coordinate in [0, 1].
inline Rgba32f value_at(const Profile& profile, double coordinate) {
    const double position = coordinate * static_cast<double>(profile.nodes.size() - 1);
    const auto whole = static_cast<std::size_t>(static_cast<int>(position));
    const std::size_t i = whole < profile.nodes.size() - 1 ? whole : profile.nodes.size() - 2;
    const auto t = static_cast<float>(position - static_cast<double>(i));
    Rgba32f value;
    for (std::size_t c = 0; c < 4; ++c)
        value[c] = (1.0F - t) * profile.nodes[i][c] + t * profile.nodes[i + 1][c];
    return value;
}

/// alpha p(v), the part of f that a view fixes.
inline Rgba32f view_part(const ProductBrdf& brdf, double n_v) {
    Rgba32f part = value_at(brdf.p, paraboloid_radius(n_v));
    for (std::size_t c = 0; c < 4; ++c) part[c] *= brdf.alpha[c];
    return part;
}

/// f of the view's part, the light's radius and the half vector's coordinate.
inline Rgb product(const ProductBrdf& brdf, const Rgba32f& view, double radius, double half) {
    const Rgba32f p = value_at(brdf.p, radius), q = value_at(brdf.q, half);
    Rgba32f f;
    for (std::size_t c = 0; c < 4; ++c) f[c] = view[c] * p[c] * q[c];
    return {static_cast<double>(f[0]), static_cast<double>(f[1]), static_cast<double>(f[2])};
}

/// How a channel of the samples was fitted. A sample is counted once, under the first that applies.
struct ProductFit {
    std::size_t used = 0;
    std::size_t unmeasured = 0;       ///< NaN: left out
    std::size_t floored = 0;          ///< above 0 and raised to the floor
    std::size_t zero = 0;             ///< 0 or less: raised to the floor, or masked
    bool partly_unsupported = false;  ///< zeros are masked: so many that they are no dark values
    SolverReport solver;
    double relative_rms = 0.0;  ///< of f cos cos over the used samples, against the data's own rms
    double log_rms = 0.0;       ///< of the logarithms of the used samples, floored
};

struct FactoredBrdf {
    ProductBrdf brdf;
    std::array<ProductFit, 3> fit;
};

/// Fits p and q to samples, each channel for itself: least squares of log f, floored at 1e-2 of the
/// median, rows weighted by (f / median)^(1/4), with rows for the curvature of p and q. Where 40 %
/// or more of a channel are not above 0 these are no noise and no darkness but a lack of support
/// (colours outside the gamut, D03): they are masked, and nodes of q most of whose weight is theirs
/// become 0.
/// @throws Error(failure) if no sample of any channel is above 0
FactoredBrdf factor_brdf(std::span<const BrdfSample> samples, int threads);

}  // namespace twofold
