#pragma once
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

#include "factor/measured_data.hpp"
#include "texunit/texture.hpp"

/// A measured BRDF resampled for the lighting sum: binary32 nodes over half vector and difference
/// angle (Rusinkiewicz 1998), read by trilinear interpolation. The coordinates need square roots
/// only, and resolve what MERL's do: the first goes as the root of theta_h.
namespace twofold {

/// Where a pair of directions is in the table, each in [0, 1]: (1 - n.h)^(1/4), (1 - v.h)^(1/2) and
/// (1 + cos phi_d) / 2. An isotropic surface with a plane of symmetry has one value at each.
struct HalfAngle {
    double half;
    double difference;
    double azimuth;
};

/// @param n_l, n_v n.l and n.v, > 0
/// @param square |l + v|^2
inline HalfAngle half_angle(double n_l, double n_v, double square) {
    const double s2 = square > 1e-30 ? square : 1e-30;
    const double s = std::sqrt(s2);
    const double sum = n_l + n_v;
    const double n_h = sum < s ? sum / s : 1.0;
    const double v_h = 0.5 * s < 1.0 ? 0.5 * s : 1.0;
    const double half2 = (1.0 - n_h) * (1.0 + n_h);        // sin^2 theta_h
    const double difference2 = (1.0 - v_h) * (1.0 + v_h);  // sin^2 theta_d
    const double product = half2 * difference2;
    const double cosine = (n_v - n_l) * 0.5 / std::sqrt(product > 1e-30 ? product : 1e-30);
    const double inside = cosine < -1.0 ? -1.0 : cosine > 1.0 ? 1.0 : cosine;
    return {std::sqrt(std::sqrt(1.0 - n_h)), std::sqrt(1.0 - v_h), 0.5 + 0.5 * inside};
}

/// The table: node (i, j, k) of half, difference and azimuth at ((i * 48) + j) * 25 + k, each axis
/// from 0 to 1.
struct HalfAngleTable {
    static constexpr std::size_t half_nodes = 90, difference_nodes = 48, azimuth_nodes = 25;
    static constexpr std::size_t nodes = half_nodes * difference_nodes * azimuth_nodes;

    std::vector<Rgba32f> f;  ///< `nodes` of them; the fourth component is 0

    /// How many nodes had no value in a channel and took their neighbours' (fill_gaps).
    std::array<std::size_t, 3> filled{};
};

/// The directions of a node; z is n.l and n.v and may be below the horizon.
struct NodeDirections {
    Vec3 wi, wo;
};
NodeDirections node_directions(std::size_t node);

/// Nearer to the horizon than this cosine a measurement is not asked for: the values of all three
/// formats are extrapolated there.
inline constexpr double least_node_cosine = 0.02;

/// f at each node; NaN in every channel where a direction is below least_node_cosine.
std::vector<Rgb> node_values(const std::function<Rgb(Vec3 wi, Vec3 wo)>& value, int threads);

/// The table of node values. Negative ones become 0. A gap takes, channel by channel, the mean of
/// its known neighbours along the axes (up to 6), in rounds from the known nodes outwards.
/// @throws Error(failure) if a channel has no value at all
HalfAngleTable fill_gaps(const std::vector<Rgb>& values);

/// f at a place.
inline Rgb trilinear(const HalfAngleTable& table, const HalfAngle& at) {
    constexpr std::size_t step_i = HalfAngleTable::difference_nodes * HalfAngleTable::azimuth_nodes;
    constexpr std::size_t step_j = HalfAngleTable::azimuth_nodes;
    // Coordinates lie in [0, 1]: the conversions are in range.
    const auto lower = [](double position, std::size_t nodes) {
        const auto whole = static_cast<std::size_t>(static_cast<int>(position));
        return whole < nodes - 1 ? whole : nodes - 2;
    };
    const double x = at.half * (HalfAngleTable::half_nodes - 1);
    const double y = at.difference * (HalfAngleTable::difference_nodes - 1);
    const double z = at.azimuth * (HalfAngleTable::azimuth_nodes - 1);
    const std::size_t i = lower(x, HalfAngleTable::half_nodes);
    const std::size_t j = lower(y, HalfAngleTable::difference_nodes);
    const std::size_t k = lower(z, HalfAngleTable::azimuth_nodes);
    const auto u = static_cast<float>(x - static_cast<double>(i));
    const auto v = static_cast<float>(y - static_cast<double>(j));
    const auto w = static_cast<float>(z - static_cast<double>(k));
    const Rgba32f* corner = table.f.data() + (i * step_i + j * step_j + k);
    Rgba32f sum{};
    for (std::size_t n = 0; n < 4; ++n) {
        const float weight = (n < 2 ? 1.0F - u : u) * (n % 2 == 0 ? 1.0F - v : v);
        const Rgba32f* edge = corner + (n / 2 * step_i + n % 2 * step_j);
        for (std::size_t c = 0; c < 4; ++c)
            sum[c] += weight * ((1.0F - w) * edge[0][c] + w * edge[1][c]);
    }
    return {static_cast<double>(sum[0]), static_cast<double>(sum[1]), static_cast<double>(sum[2])};
}

}  // namespace twofold
