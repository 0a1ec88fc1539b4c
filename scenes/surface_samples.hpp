#pragma once
#include <cstdint>
#include <string>

#include "factor/brdf.hpp"
#include "factor/distant_lights.hpp"
#include "factor/surface_light_field.hpp"
#include "raster/mesh.hpp"

namespace twofold {

/// The surface of an object: its mesh and its way into the world.
struct Surface {
    const Mesh& mesh;
    std::string name;  ///< of the mesh
    Mat4 model{1.0};
};

/// The rows that the settings ask for. Vertices are beside those that share a triangle's edge, or a
/// place.
/// @throws Error if the mesh has no triangles, or no texture coordinates where texels are rows
SurfaceRows rows_of(const Surface& surface, const FactorSettings& settings);

/// What is seen at points of a surface, spread evenly over its area, from directions
/// cosine-weighted about the normal; world space.
/// @param sequence points of different sequences are different
SurfaceSamples surface_samples(const Surface& surface, const Brdf& brdf,
                               const DistantLights& lights, const FactorSettings& settings,
                               int count, std::uint64_t sequence, int threads);

}  // namespace twofold
