#include "raster/effects.hpp"

#include <functional>
#include <utility>

namespace twofold {
namespace {

using Removal = std::pair<std::string, std::function<void(PassState&)>>;

/// How to leave out what a state has besides its units.
std::vector<Removal> removals_of_pass() {
    return {{"normalize", [](PassState& s) { s.normalize = false; }},
            {"cull", [](PassState& s) { s.cull = CullFace::none; }},
            {"scissor", [](PassState& s) { s.scissor.reset(); }},
            {"perspective correction", [](PassState& s) { s.perspective_correction = false; }},
            {"smooth colours", [](PassState& s) { s.shade_model = ShadeModel::flat; }},
            {"register combiners", [](PassState& s) { s.combiners.reset(); }},
            {"colour sum", [](PassState& s) { s.color_sum = false; }},
            {"fog", [](PassState& s) { s.fog.reset(); }},
            {"alpha test", [](PassState& s) { s.alpha_test.reset(); }},
            {"depth test", [](PassState& s) { s.depth_test.reset(); }},
            {"blend", [](PassState& s) { s.blend.reset(); }},
            {"dither", [](PassState& s) { s.dither = false; }},
            {"colour mask", [](PassState& s) { s.color_mask = PassState{}.color_mask; }}};
}

void filter_by_nearest(TextureUnitState& unit) {
    unit.min_filter = unit.mag_filter = Filter::nearest;
    unit.mip_filter = MipFilter::off;
}

std::vector<Removal> removals_of_unit(std::size_t u) {
    const auto of_unit = [u](const std::string& name, auto remove) {
        return Removal{name + " " + std::to_string(u), [u, remove](PassState& s) {
                           if (s.units[u]) remove(*s.units[u]);
                       }};
    };
    return {{"texture unit " + std::to_string(u), [u](PassState& s) { s.units[u].reset(); }},
            of_unit("texgen", [](TextureUnitState& unit) { unit.texgen = {}; }),
            of_unit("texture matrix", [](TextureUnitState& unit) { unit.matrix = Mat4{1.0}; }),
            of_unit("filter", filter_by_nearest),
            of_unit("environment", [](TextureUnitState& unit) { unit.env = {}; })};
}

std::vector<Removal> removals() {
    std::vector<Removal> all = removals_of_pass();
    for (std::size_t u = 0; u < max_units; ++u)
        for (Removal& removal : removals_of_unit(u)) all.push_back(std::move(removal));
    return all;
}

}  // namespace

std::vector<Effect> effects_of(const Frame& frame) {
    std::vector<Effect> effects;
    for (const auto& [name, remove] : removals()) {
        Frame without = frame;
        bool is_on = false;
        for (Pass& pass : without.passes) {
            const PassState before = normalized(frame, pass);
            remove(pass.state);
            is_on = is_on || normalized(frame, pass) != before;
        }
        if (is_on) effects.push_back({name, std::move(without)});
    }
    return effects;
}

}  // namespace twofold
