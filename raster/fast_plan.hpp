#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "raster/pass.hpp"
#include "texunit/custom.hpp"
#include "texunit/preset.hpp"

/// Which way the fast pipeline takes with each pass. Every way gives the same bytes.
namespace twofold {

struct FastRoute {
    std::string scalar_vertices;   ///< why vertices are placed one by one; empty: on vectors
    std::string scalar_fragments;  ///< why fragments are shaded one by one; empty: on vectors
    std::string apart;             ///< why it does not share the geometry of the pass before
    std::size_t group;             ///< passes of one number share vertices and set-up
};

/// One for each pass of the frame.
/// @throws as render_reference
std::vector<FastRoute> fast_routes(const Frame& frame, Preset preset,
                                   const CustomSettings& custom = {}, bool fuse = true);

}  // namespace twofold
