#include "raster/pass.hpp"

#include "raster/transform.hpp"

namespace twofold {

namespace {

/// The incoming colour is written as it is.
bool replaces(const Blend& blend) {
    return blend.equation == BlendEquation::add && blend.source == BlendFactor::one &&
           blend.destination == BlendFactor::zero;
}

}  // namespace

PassState normalized(PassState state) {
    if (state.alpha_test && state.alpha_test->func == CompareFunc::always) state.alpha_test.reset();
    if (state.blend && replaces(*state.blend)) state.blend.reset();
    const bool depth_is_idle = state.depth_test && state.depth_test->func == CompareFunc::always &&
                               !state.depth_test->write;
    if (depth_is_idle) state.depth_test.reset();
    if (state.combiners) {
        state.color_sum = false;
        for (auto& unit : state.units)
            if (unit) unit->env = TexEnv{};
    }
    if (!needs_normals(state)) state.normalize = false;
    return state;
}

}  // namespace twofold
