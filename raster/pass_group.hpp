#pragma once
#include <array>
#include <string>
#include <vector>

#include "raster/pass.hpp"

/// Which passes of a frame the fast pipeline walks together.
namespace twofold {

/// What the vertex stage computes for a unit: the mesh's coordinates of `unit`, or generated ones,
/// times the matrix.
struct CoordinateSet {
    std::size_t unit;
    TexGenState texgen;
    Mat4 matrix;
    bool operator==(const CoordinateSet&) const = default;
};

/// Passes that follow one another over the same geometry. The vertices are transformed and the
/// triangles set up once for all of them; each pass then covers, tests and shades in its turn.
struct PassGroup {
    std::vector<std::size_t> passes;  ///< indices into the frame's passes
    std::vector<CoordinateSet> sets;  ///< at most max_units
    /// set_of[k][u]: the set that unit u of the group's pass k reads
    std::vector<std::array<std::size_t, max_units>> set_of;
    std::string apart;  ///< why it does not belong to the group before; empty for the first
};

/// Why two passes cannot share their geometry; empty if they can.
std::string why_not_fused(const Pass& first, const Pass& second);

/// The frame's passes in their order. Without `fuse` each is a group of its own.
std::vector<PassGroup> group_passes(const Frame& frame, bool fuse);

}  // namespace twofold
