#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "factor/samples.hpp"

namespace twofold {

/// Smallest n.v that surface_views() gives: views nearer to the horizon are raised to it. In
/// 200,000 samples that happens once in 500 runs, and keeps 1 / n.v of Cook-Torrance in reach.
inline constexpr double least_view_cosine = 1e-4;

/// Pairs (n, v) spread evenly over every pair that can be seen: n uniform on the sphere, v
/// cosine-weighted about n. The points are those of one additive recurrence in integers, so they
/// are the same everywhere.
/// @param count pairs wanted, 0 <= count < 2^31
/// @param sequence which stretch of the recurrence; different values below 2^32 share no point, so
/// a set
///        of another sequence can be held out of a fit
/// @param first where in the stretch the first pair is
/// @return unit vectors, n.v >= least_view_cosine up to rounding
/// @source M. Roberts, The Unreasonable Effectiveness of Quasirandom Sequences, 2018
std::vector<SurfaceView> surface_views(int count, std::uint64_t sequence, int first = 0);

/// How many of the pairs lie at the horizon, n.v <= least_view_cosine (up to rounding).
int count_at_horizon(std::span<const SurfaceView> views);

/// The unit vector a along `normal` plus the part (x, y) across it, in a frame that depends on
/// `normal` alone.
/// @source Duff et al., Building an Orthonormal Basis, Revisited, JCGT 2017
Vec3 about(Vec3 normal, double x, double y, double along);

}  // namespace twofold
