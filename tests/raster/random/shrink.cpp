#include "tests/raster/random/shrink.hpp"

#include <map>

#include "raster/transform.hpp"
#include "tests/raster/random/random_parts.hpp"

namespace twofold::test {
namespace {

using Edit = std::function<void(RandomState&)>;

/// The optional and other fields of a pass that can be set back one by one.
std::vector<std::function<void(PassState&)>> pass_resets() {
    return {[](PassState& s) { s.fog.reset(); },
            [](PassState& s) { s.scissor.reset(); },
            [](PassState& s) { s.alpha_test.reset(); },
            [](PassState& s) { s.depth_test.reset(); },
            [](PassState& s) { s.blend.reset(); },
            [](PassState& s) { s.combiners.reset(); },
            [](PassState& s) { s.viewport.reset(); },
            [](PassState& s) { s.color_sum = false; },
            [](PassState& s) { s.dither = false; },
            [](PassState& s) { s.normalize = false; },
            [](PassState& s) { s.color_mask.fill(true); },
            [](PassState& s) { s.cull = CullFace::none; },
            [](PassState& s) { s.shade_model = ShadeModel::smooth; },
            [](PassState& s) { s.provoking_vertex = ProvokingVertex::last; },
            [](PassState& s) { s.perspective_correction = true; },
            [](PassState& s) { s.color = Vec4{1.0}; }};
}

std::vector<std::function<void(TextureUnitState&)>> unit_resets() {
    return {[](TextureUnitState& u) { u.texture.reset(), u.target = TextureTarget::texture_2d; },
            [](TextureUnitState& u) { u.texgen = {}; },
            [](TextureUnitState& u) { u.matrix = Mat4{1.0}; },
            [](TextureUnitState& u) { u.env = {}; },
            [](TextureUnitState& u) { u.wrap_s = u.wrap_t = Wrap::clamp_to_edge; },
            [](TextureUnitState& u) { u.min_filter = u.mag_filter; },
            [](TextureUnitState& u) { u.min_filter = u.mag_filter = Filter::nearest; },
            [](TextureUnitState& u) { u.mip_filter = MipFilter::off; },
            [](TextureUnitState& u) { u.lod_bias = 0.0; },
            [](TextureUnitState& u) { u.border_color = Vec4{0.0}; },
            [](TextureUnitState& u) { u.divide_by_q = true; }};
}

void add_pass_edits(const RandomState& state, std::vector<Edit>& edits) {
    for (std::size_t p = 0; p < state.frame.passes.size(); ++p) {
        for (const auto& reset : pass_resets())
            edits.push_back([=](RandomState& s) { reset(s.frame.passes[p].state); });
        for (std::size_t u = 0; u < max_units; ++u) {
            if (!state.frame.passes[p].state.units[u]) continue;
            edits.push_back([=](RandomState& s) { s.frame.passes[p].state.units[u].reset(); });
            for (const auto& reset : unit_resets())
                edits.push_back([=](RandomState& s) { reset(*s.frame.passes[p].state.units[u]); });
        }
    }
}

/// Indices to a whole primitive of the kind.
std::size_t step_of(Primitive primitive) {
    if (primitive == Primitive::triangles) return 3;
    return primitive == Primitive::quads ? 4 : 2;
}

/// Halves, quarters, ... down to single primitives.
void add_index_edits(const RandomState& state, std::vector<Edit>& edits) {
    for (std::size_t m = 0; m < state.frame.meshes.size(); ++m) {
        const Mesh& mesh = state.frame.meshes[m];
        const std::size_t step = step_of(mesh.primitive), count = mesh.indices.size() / step;
        for (std::size_t length = count; length > 0; length /= 2)
            for (std::size_t first = 0; first + length <= count; first += length)
                edits.push_back([=](RandomState& s) {
                    auto& indices = s.frame.meshes[m].indices;
                    const auto begin = indices.begin() + static_cast<std::ptrdiff_t>(first * step);
                    indices.erase(begin, begin + static_cast<std::ptrdiff_t>(length * step));
                });
    }
}

/// Scene files want them where they are read.
bool reads_normals(const Frame& frame, std::size_t mesh) {
    for (const Pass& pass : frame.passes)
        if (pass.mesh == mesh && needs_normals(pass.state)) return true;
    return false;
}

void add_mesh_edits(const RandomState& state, std::vector<Edit>& edits) {
    for (std::size_t m = 0; m < state.frame.meshes.size(); ++m) {
        edits.push_back([=](RandomState& s) { s.frame.meshes[m].colors.clear(); });
        edits.push_back([=](RandomState& s) { s.frame.meshes[m].secondary_colors.clear(); });
        edits.push_back([=](RandomState& s) {
            if (!reads_normals(s.frame, m)) s.frame.meshes[m].normals.clear();
        });
        edits.push_back([=](RandomState& s) { s.frame.meshes[m].position_w.clear(); });
        for (std::size_t u = 0; u < max_units; ++u)
            edits.push_back([=](RandomState& s) { s.frame.meshes[m].texcoords[u].clear(); });
    }
}

/// To bytes: the scene file has no other way to say them all.
void cut_to_bytes(Texels& texels) {
    const auto* floats = std::get_if<std::vector<Rgba32f>>(&texels);
    if (floats != nullptr) texels = as_bytes(*floats);
}

void add_texture_edits(const RandomState& state, std::vector<Edit>& edits) {
    for (std::size_t t = 0; t < state.frame.textures.size(); ++t) {
        edits.push_back([=](RandomState& s) { s.frame.textures[t].mipmaps.clear(); });
        edits.push_back(
            [=](RandomState& s) { s.frame.textures[t].base_format = BaseFormat::rgba; });
        edits.push_back([=](RandomState& s) { cut_to_bytes(s.frame.textures[t].texels); });
    }
}

void add_target_edits(std::vector<Edit>& edits) {
    edits.insert(
        edits.end(),
        {[](RandomState& s) { s.options.threads = 1; },
         [](RandomState& s) { s.options.fuse = false; }, [](RandomState& s) { s.custom = {}; },
         [](RandomState& s) { s.frame.initial_color.reset(); },
         [](RandomState& s) { s.frame.clear_color = Vec4{0.0}; },
         [](RandomState& s) { s.frame.clear_depth = 1.0; },
         [](RandomState& s) { s.frame.depth_bits = 24; },
         [](RandomState& s) { s.frame.color_format = ColorFormat::rgba8888; }});
}

/// Every way to take something away, the largest first.
std::vector<Edit> edits_of(const RandomState& state) {
    std::vector<Edit> edits;
    for (std::size_t p = 0; p < state.frame.passes.size(); ++p)
        edits.push_back([=](RandomState& s) {
            s.frame.passes.erase(s.frame.passes.begin() + static_cast<std::ptrdiff_t>(p));
        });
    add_index_edits(state, edits);
    add_pass_edits(state, edits);
    add_target_edits(edits);
    add_mesh_edits(state, edits);
    add_texture_edits(state, edits);
    return edits;
}

/// The numbers that `used` holds, renumbered from 0 in ascending order.
using Renumbering = std::map<std::size_t, std::size_t>;

template <class T>
std::vector<T> kept(const std::vector<T>& values, const Renumbering& used) {
    std::vector<T> result;
    for (const auto& [old, fresh] : used)
        if (old < values.size()) result.push_back(values[old]);
    return result;
}

void number(Renumbering& used) {
    std::size_t next = 0;
    for (auto& [old, fresh] : used) fresh = next++;
}

void compact(Mesh& mesh) {
    Renumbering used;
    for (const std::uint32_t i : mesh.indices) used[i];
    if (used.empty()) used[0];
    number(used);
    for (std::uint32_t& i : mesh.indices) i = static_cast<std::uint32_t>(used[i]);
    mesh.positions = kept(mesh.positions, used);
    mesh.normals = kept(mesh.normals, used);
    mesh.colors = kept(mesh.colors, used);
    mesh.secondary_colors = kept(mesh.secondary_colors, used);
    mesh.position_w = kept(mesh.position_w, used);
    for (auto& set : mesh.texcoords) set = kept(set, used);
}

/// Tries every edit once. One that leaves fewer edits than before took something away, and its
/// number is another edit's now.
RandomState swept(RandomState state, const std::function<bool(const RandomState&)>& fails) {
    auto edits = edits_of(state);
    for (std::size_t i = 0; i < edits.size();) {
        RandomState smaller = state;
        edits[i](smaller);
        const std::size_t before = edits.size();
        if (fails(smaller)) {
            state = std::move(smaller);
            edits = edits_of(state);
        }
        if (edits.size() == before) ++i;
    }
    return state;
}

}  // namespace

Frame compacted(Frame frame) {
    Renumbering meshes, textures;
    for (const Pass& pass : frame.passes) {
        meshes[pass.mesh];
        for (const auto& unit : pass.state.units)
            if (unit && unit->texture) textures[*unit->texture];
    }
    number(meshes);
    number(textures);
    for (Pass& pass : frame.passes) {
        pass.mesh = meshes[pass.mesh];
        for (auto& unit : pass.state.units)
            if (unit && unit->texture) unit->texture = textures[*unit->texture];
    }
    frame.meshes = kept(frame.meshes, meshes);
    frame.textures = kept(frame.textures, textures);
    for (Mesh& mesh : frame.meshes) compact(mesh);
    return frame;
}

RandomState shrunk(RandomState state, const std::function<bool(const RandomState&)>& fails) {
    constexpr int sweeps = 3;  // what the last pass needed may be free to go once it is gone
    for (int i = 0; i < sweeps; ++i) state = swept(std::move(state), fails);
    RandomState compact = state;
    compact.frame = compacted(std::move(compact.frame));
    return fails(compact) ? compact : state;
}

}  // namespace twofold::test
