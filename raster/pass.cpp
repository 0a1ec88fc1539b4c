#include "raster/pass.hpp"

#include "raster/transform.hpp"

namespace twofold {

PassState normalized(PassState state) {
    if (state.alpha_test && state.alpha_test->func == CompareFunc::always) state.alpha_test.reset();
    if (state.blend && *state.blend == Blend{}) state.blend.reset();
    const bool depth_is_idle = state.depth_test && state.depth_test->func == CompareFunc::always &&
                               !state.depth_test->write;
    if (depth_is_idle) state.depth_test.reset();
    if (!needs_normals(state)) state.normalize = false;
    return state;
}

}  // namespace twofold
