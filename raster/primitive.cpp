#include "raster/primitive.hpp"

namespace twofold {
namespace {

using Indices = std::vector<std::uint32_t>;
using Triangles = std::vector<AssembledTriangle>;

void separate_triangles(const Indices& v, bool last, Triangles& out) {
    for (std::size_t i = 0; i + 2 < v.size(); i += 3)
        out.push_back({{v[i], v[i + 1], v[i + 2]}, last ? v[i + 2] : v[i]});
}

void strip(const Indices& v, bool last, Triangles& out) {
    for (std::size_t i = 0; i + 2 < v.size(); ++i) {
        const std::size_t odd = i & 1;
        out.push_back({{v[i + odd], v[i + 1 - odd], v[i + 2]}, last ? v[i + 2] : v[i]});
    }
}

void fan(const Indices& v, bool last, Triangles& out) {
    for (std::size_t i = 1; i + 1 < v.size(); ++i)
        out.push_back({{v[0], v[i], v[i + 1]}, last ? v[i + 1] : v[i]});
}

void polygon(const Indices& v, Triangles& out) {
    for (std::size_t i = 1; i + 1 < v.size(); ++i) out.push_back({{v[0], v[i], v[i + 1]}, v[0]});
}

void quads(const Indices& v, Triangles& out) {
    for (std::size_t i = 0; i + 3 < v.size(); i += 4) {
        out.push_back({{v[i], v[i + 1], v[i + 2]}, v[i + 3]});
        out.push_back({{v[i], v[i + 2], v[i + 3]}, v[i + 3]});
    }
}

void quad_strip(const Indices& v, Triangles& out) {
    for (std::size_t i = 0; i + 3 < v.size(); i += 2) {
        out.push_back({{v[i], v[i + 1], v[i + 2]}, v[i + 3]});
        out.push_back({{v[i + 2], v[i + 1], v[i + 3]}, v[i + 3]});
    }
}

}  // namespace

Triangles assemble(Primitive primitive, const Indices& indices, ProvokingVertex provoking) {
    Triangles out;
    const bool last = provoking == ProvokingVertex::last;
    switch (primitive) {
        case Primitive::triangles:
            separate_triangles(indices, last, out);
            break;
        case Primitive::triangle_strip:
            strip(indices, last, out);
            break;
        case Primitive::triangle_fan:
            fan(indices, last, out);
            break;
        case Primitive::quads:
            quads(indices, out);
            break;
        case Primitive::quad_strip:
            quad_strip(indices, out);
            break;
        case Primitive::polygon:
            polygon(indices, out);
            break;
    }
    return out;
}

}  // namespace twofold
