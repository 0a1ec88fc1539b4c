#pragma once
#include <span>
#include <vector>

#include "raster/pass.hpp"

/// A BRDF p(l) q(h) p(v) as passes over a mesh, two of its factors at a time.
/// @source McCool, Ang & Ahmad 2001, section 5
namespace twofold {

/// A distant light as its passes see it.
struct PassLight {
    Vec3 direction;  ///< unit, towards it, eye space
    Rgb color;       ///< what (n.l)+ is multiplied by, before the combiner's scale
};

/// What the passes need of each vertex: texture coordinates of directions in the frame of the
/// surface, projective, and max(0, n.l).
struct VertexFactors {
    std::vector<Vec4> light, half, view;
    std::vector<double> cosine;
};

VertexFactors factors_at(const Mesh& mesh, const Mat4& modelview, Vec3 light);

/// color x cosine at each vertex, clamped to 1.
std::vector<Vec4> lit_colors(const VertexFactors& factors, Rgb color);

/// Adds a pass over a copy of the mesh that has these coordinates and colours.
void add_vertex_pass(Frame& frame, const Mesh& mesh, const PassState& state,
                     std::vector<Vec4> first, std::vector<Vec4> second, std::vector<Vec4> colors);

/// Adds the passes: for each light colour x (n.l)+ x p(l) x q(h) on two units, added up by (ONE,
/// ONE), then all of it x p(v) by (ZERO, SRC_COLOR), which takes it through the framebuffer's 8
/// bits. A light more is a pass more.
/// @param first state of the object's first pass @param combiner_scale 1, 2 or 4
/// @param texture p; q follows it
void add_point_lit(Frame& frame, const Mesh& mesh, const PassState& first,
                   std::span<const PassLight> lights, int combiner_scale, std::size_t texture);

/// A unit with a texture.
TextureUnitState unit_with(std::size_t texture);

/// A later pass over the same surface: where depth is equal, blended, depth kept.
PassState drawn_over(PassState state, const Blend& blend);

/// (s, t, 0, q) of a direction in the frame of the surface on a map with the guard 7/8; below the
/// horizon those of the horizon.
Vec4 paraboloid_coordinates(Vec3 d);

}  // namespace twofold
