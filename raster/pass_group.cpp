#include "raster/pass_group.hpp"

#include <algorithm>

namespace twofold {
namespace {

/// The state that decides where vertices go and what colours they wear.
bool same_vertices(const PassState& a, const PassState& b) {
    return a.color == b.color && a.normalize == b.normalize && a.fog == b.fog &&
           a.shade_model == b.shade_model && a.provoking_vertex == b.provoking_vertex;
}

bool same_place(const PassState& a, const PassState& b) {
    return a.modelview == b.modelview && a.projection == b.projection && a.viewport == b.viewport &&
           a.window_space == b.window_space &&
           a.perspective_correction == b.perspective_correction && a.cull == b.cull;
}

std::vector<CoordinateSet> sets_of(const PassState& state) {
    std::vector<CoordinateSet> sets;
    for (std::size_t u = 0; u < max_units; ++u)
        if (const auto& unit = state.units[u]) sets.push_back({u, unit->texgen, unit->matrix});
    return sets;
}

/// Adds the pass unless the group would need more coordinate sets than there are units.
bool add(PassGroup& group, std::size_t pass, const PassState& state) {
    auto sets = group.sets;
    std::array<std::size_t, max_units> set_of{};
    for (const CoordinateSet& set : sets_of(state)) {
        const auto known = std::find(sets.begin(), sets.end(), set);
        set_of[set.unit] = static_cast<std::size_t>(known - sets.begin());
        if (known == sets.end()) sets.push_back(set);
    }
    if (sets.size() > max_units) return false;
    group.sets = std::move(sets);
    group.passes.push_back(pass);
    group.set_of.push_back(set_of);
    return true;
}

}  // namespace

std::string why_not_fused(const Pass& first, const Pass& second) {
    const PassState a = normalized(first.state), b = normalized(second.state);
    if (first.mesh != second.mesh) return "another mesh";
    if (!same_place(a, b)) return "other matrices, viewport or culling";
    if (!same_vertices(a, b)) return "other vertex colours, normalisation, fog or shade model";
    return {};
}

std::vector<PassGroup> group_passes(const Frame& frame, bool fuse) {
    std::vector<PassGroup> groups;
    for (std::size_t k = 0; k < frame.passes.size(); ++k) {
        const PassState state = normalized(frame.passes[k].state);
        std::string apart = k == 0 ? "" : "fusing is off";
        if (fuse && k > 0) apart = why_not_fused(frame.passes[k - 1], frame.passes[k]);
        if (k > 0 && apart.empty()) {
            if (add(groups.back(), k, state)) continue;
            apart = "more different texture coordinates than there are units";
        }
        groups.emplace_back().apart = apart;
        add(groups.back(), k, state);
    }
    return groups;
}

}  // namespace twofold
