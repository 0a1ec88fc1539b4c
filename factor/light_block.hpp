#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "factor/brdf.hpp"
#include "factor/distant_lights.hpp"
#include "factor/samples.hpp"

/// The inner loops of the lighting sum: one view, one block of at most 256 lights, elementwise over
/// local arrays so that the compiler turns them into vectors. `evaluate` says the same in readable
/// form.
namespace twofold {

/// Cook-Torrance with everything taken out of the loop that does not depend on the light.
struct CookTorranceTable {
    /// w exp(-tan^2 / m^2) / m^2, the scale kept as a logarithm so that no product underflows
    /// early.
    struct Lobe {
        double log_scale;       ///< log(w / m^2)
        double inverse_square;  ///< 1 / m^2
    };
    std::vector<Lobe> lobes;                      ///< those of weight > 0
    Rgb diffuse_over_pi{0.0};                     ///< f of the diffuse part
    Rgb scale{0.0};                               ///< specular * constant
    std::array<double, 3> index_square_less_1{};  ///< eta^2 - 1 of each Fresnel curve
    std::array<std::size_t, 3> curve{};           ///< which curve a channel uses
    std::size_t curves = 0;                       ///< 1 where all channels have the same f0
};

/// Modified Phong, as CookTorranceTable.
struct ModifiedPhongTable {
    Rgb diffuse_over_pi{0.0};
    Rgb scale{0.0};  ///< specular (N + 2) / (2 pi)
    double exponent = 0.0;
};

/// A measured material's model, which must live as long.
struct MeasuredTable {
    const MeasuredModel& model;
};

CookTorranceTable tabulate(const CookTorrance& material);
ModifiedPhongTable tabulate(const ModifiedPhong& material);
inline MeasuredTable tabulate(const MeasuredBrdf& material) { return {*material.model}; }

/// f of a measured material.
/// @param n_l, n_v n.l and n.v, > 0
/// @param square |l + v|^2
Rgb measured_value(const MeasuredModel& model, double n_l, double n_v, double square);

/// Lights [first, first + count) of `lights`, 1 <= count <= light_block, without some of their
/// patches.
struct LightBlock {
    const DistantLights& lights;
    std::size_t first;
    std::size_t count;
    unsigned lit;  ///< bit p is set where patch p may add something; the terms of others are +0.0
};

/// Sum of f(l_k, v; n) max(0, n.l_k) W_k over the block, in the order of docs/exactness.md,
/// section 3.
/// @param at a view with n.v > 0
Rgb block_sum(const CookTorranceTable& table, LightBlock block, const SurfaceView& at);
Rgb block_sum(const ModifiedPhongTable& table, LightBlock block, const SurfaceView& at);
Rgb block_sum(const MeasuredTable& table, LightBlock block, const SurfaceView& at);

}  // namespace twofold
