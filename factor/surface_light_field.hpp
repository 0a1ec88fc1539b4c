#pragma once
#include <cstdint>

#include "factor/factorize.hpp"

/// `slf`: a surface light field, f(r, s, theta, phi) ~ sum of t1_j(r, s) t2_j(theta, phi). Rows are
/// points of one surface, its vertices or the texels of a chart over its texture coordinates, and
/// columns are directions of the mirrored view, which REFLECTION_MAP generates (Chen et al. take
/// the view in a frame of the surface). Fitted and drawn as `svd` is, t1 from vertex colours or
/// from a texture of the mesh.
/// @source seed paper, equation 3; Chen, Bouguet, Chu & Grzeszczuk, Light Field Mapping, 2002
namespace twofold {

/// The rows of a surface.
struct SurfaceRows {
    std::vector<std::vector<std::uint32_t>> neighbours;  ///< of each row: what it is smooth with
    int chart_size = 0;  ///< texels along the edge of the chart; 0: rows are vertices

    std::size_t count() const { return neighbours.size(); }
};

/// The rows of a chart of size x size texels.
SurfaceRows chart_rows(int size);

/// Samples at points of a surface; `at` holds directions in the frame of the maps.
struct SurfaceSamples {
    LightingSamples lighting;
    std::vector<TexelFootprint> rows;  ///< of each sample; unused places have the weight 0
};

/// A surface's rows and samples: those of the fit and those held out of it.
struct SurfaceField {
    SurfaceRows rows;
    SurfaceSamples fit, held_out;
};

/// @param settings map_form, map_size, guard, terms, rounds, smoothness, seam, cap and scale are
/// used
/// @throws Error as factorize() does
FactoredLighting factor_surface(const SurfaceField& field, const FactorSettings& settings,
                                double white, int threads);

}  // namespace twofold
