#pragma once

namespace twofold {

enum class Solver { qmr, lsmr };

/// How closely the factorisation follows the paper: `letter` has no smoothness and seam rows, no row
/// weights, no column scaling and stops by the iteration limit alone; `paper` adds what makes it work.
enum class Method { letter, paper };

/// Everything that decides the two factor maps, given the samples and the white point.
/// Defaults are those of the method preset `paper`.
struct FactorSettings {
    Method method = Method::paper;
    int map_size = 64;             ///< R: texels along the edge of one paraboloid face
    double guard = 0.875;          ///< g: disc radius in units of half the map's edge, 0 < g <= 1
    int samples = 200000;          ///< S: (v, n) pairs of the fit
    int held_out = 20000;          ///< (v, n) pairs of the error figures, none of them in the fit
    Solver solver = Solver::qmr;
    double tolerance = 1e-4;       ///< stop at |A^T r| <= tolerance |A^T b|
    int iteration_limit = 200;
    double floor = 1e-3;           ///< epsilon: radiance is raised to floor * mean before the logarithm
    double cap = 4.0;              ///< radiance is lowered to cap * white before the logarithm; 0 = off
    double row_weight = 0.25;      ///< w: row i is weighted by (L_i / mean L)^w
    double smoothness = 1.0;       ///< lambda of the Laplacian rows; 0 = off
    double seam = 0.3;             ///< scale of the seam rows relative to the Laplacian rows; 0 = off
    bool column_scaling = true;    ///< solve A D^-1 y with D_j the norm of column j
    double fill_power = 2.0;       ///< p of the inverse-distance fill of texels that no sample touches
};

/// The settings of a method preset, every field at its documented value.
FactorSettings method_preset(Method method);

}  // namespace twofold
