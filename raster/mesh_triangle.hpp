#pragma once
#include <array>
#include <cstdint>

namespace twofold {

/// What of a vertex lets vectors work on its triangles; the flags of three vertices are combined
/// by AND. Set k has bit k of each group of four.
struct VertexFlags {
    std::uint8_t positive_q = 0, negative_q = 0;  ///< and far from 0
    std::uint8_t bounded = 0;                     ///< s, t, q finite and no larger than 2^60
    bool finite = false;                          ///< depth and 1/w

    VertexFlags operator&(const VertexFlags& o) const {
        return {static_cast<std::uint8_t>(positive_q & o.positive_q),
                static_cast<std::uint8_t>(negative_q & o.negative_q),
                static_cast<std::uint8_t>(bounded & o.bounded), finite && o.finite};
    }
};

/// A triangle that has area, faces the right way and meets the picture.
struct MeshTriangle {
    std::array<std::uint32_t, 3> vertex;
    std::uint32_t provoking;      ///< whose colours all corners wear under flat shading
    std::int16_t x0, y0, x1, y1;  ///< pixels of its bounding box in the picture
    VertexFlags flags;
};

}  // namespace twofold
