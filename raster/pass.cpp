#include "raster/pass.hpp"

#include "raster/color_format.hpp"
#include "raster/coverage.hpp"
#include "raster/transform.hpp"

namespace twofold {

namespace {

/// The incoming colour is written as it is.
bool replaces(const Blend& blend) {
    return blend.equation == BlendEquation::add && blend.source == BlendFactor::one &&
           blend.destination == BlendFactor::zero;
}

bool whole_picture(const PixelRectangle& r, const Frame& frame) {
    return r.x0 == 0 && r.y0 == 0 && r.x1 == frame.width && r.y1 == frame.height;
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

PassState normalized(const Frame& frame, const Pass& pass) {
    PassState state = normalized(pass.state);
    if (whole_picture(drawable_pixels(state, frame.width, frame.height), frame))
        state.scissor.reset();
    if (bits_of(frame.color_format).rgb == bits_of(ColorFormat::rgba8888).rgb) state.dither = false;
    return state;
}

}  // namespace twofold
