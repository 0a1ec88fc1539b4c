#include "bench/draw/drawing.hpp"

#include <fmt/format.h>

#include "texunit/error.hpp"

namespace twofold::bench {
namespace {

struct Drawing {
    std::string_view name;
    std::size_t units;
    Filter filter;
    bool four_passes;
};

constexpr std::array drawings{
    Drawing{"clear", 0, Filter::nearest, false}, Drawing{"tex1-nearest", 1, Filter::nearest, false},
    Drawing{"tex2-persp", 2, Filter::linear, false}, Drawing{"para4", 2, Filter::linear, true}};

const Drawing& drawing_named(std::string_view name) {
    for (const Drawing& d : drawings)
        if (d.name == name) return d;
    throw Error(ExitCode::failure, fmt::format("drawing: {} is not known", name));
}

/// Textures lie in the frame as t1's front and back, then t2's.
constexpr std::size_t texture_index(std::size_t unit, std::size_t face) { return 2 * unit + face; }

/// Without what the drawing does not read, as the peers bind no more either.
Mesh mesh_of(const Inputs& in, const Drawing& drawing) {
    Mesh mesh = in.mesh;
    if (drawing.four_passes)
        mesh.texcoords = {};
    else
        mesh.normals.clear();
    if (in.triangles() != 2) return mesh;
    for (std::size_t i = 0; i < in.clip.size(); ++i) {
        mesh.positions[i] = Vec3{in.clip[i]};
        mesh.position_w.push_back(in.clip[i].w);
    }
    return mesh;
}

PassState state_of(const Inputs& in, const Drawing& drawing) {
    PassState state;
    if (in.triangles() != 2) {
        state.modelview = in.modelview;
        state.projection = in.projection;
    }
    state.cull = CullFace::back;
    state.depth_test = DepthTest{CompareFunc::lequal, true};
    for (std::size_t u = 0; u < drawing.units; ++u) {
        TextureUnitState unit;
        unit.texture = texture_index(u, 0);
        unit.min_filter = unit.mag_filter = drawing.filter;
        state.units[u] = unit;
    }
    return state;
}

/// Front and back of t1 (by the normal) times front and back of t2 (by the reflected view).
std::vector<Pass> four_passes(const Inputs& in, PassState state) {
    state.alpha_test = AlphaTest{CompareFunc::greater, 0.5};
    std::vector<Pass> passes;
    for (std::size_t pass = 0; pass < 4; ++pass) {
        const std::array<std::size_t, 2> face{pass / 2, pass % 2};
        for (std::size_t u = 0; u < 2; ++u) {
            TextureUnitState& unit = *state.units[u];
            unit.texture = texture_index(u, face[u]);
            unit.texgen = texgen_all(u == 0 ? TexGen::normal_map : TexGen::reflection_map);
            unit.matrix = in.texture_matrices[u][face[u]];
        }
        passes.push_back({state, 0});
    }
    return passes;
}

}  // namespace

Frame frame_of(const Inputs& in) {
    const Drawing& drawing = drawing_named(in.drawing);
    Frame frame;
    frame.width = frame.height = in.size;
    if (drawing.units == 0) return frame;
    frame.meshes = {mesh_of(in, drawing)};
    for (const auto& pair : in.textures)
        frame.textures.insert(frame.textures.end(), pair.begin(), pair.end());
    const PassState state = state_of(in, drawing);
    frame.passes = drawing.four_passes ? four_passes(in, state) : std::vector<Pass>{{state, 0}};
    return frame;
}

}  // namespace twofold::bench
