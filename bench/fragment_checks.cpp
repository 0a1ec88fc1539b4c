#include <fmt/format.h>

#include "bench/check.hpp"
#include "bench/tables.hpp"

/// Alpha test, depth test, blending, colour mask, scissor.
namespace twofold::bench {
namespace {

constexpr std::array compare_names{"never",   "less",     "equal",  "lequal",
                                   "greater", "notequal", "gequal", "always"};
constexpr std::array equation_names{"add", "subtract", "reverse_subtract", "min", "max"};

PassState replacing_state() {
    PassState state;
    TexEnv env;
    env.mode = TexEnvMode::replace;
    state.units[0] = nearest_unit(0, env);
    return state;
}

/// All 256 alphas, each in a square of 4 x 4 pixels.
Frame alpha_frame(CompareFunc func, double reference) {
    Frame frame = empty_frame(table_size);
    std::vector<Rgba8> texels;
    for (int a = 0; a < 256; ++a)
        texels.push_back(
            {255, static_cast<std::uint8_t>(255 - a), 0, static_cast<std::uint8_t>(a)});
    frame.textures = {{16, 16, std::move(texels)}};
    frame.meshes = {squares(1, 6, true)};
    PassState state = replacing_state();
    state.alpha_test = AlphaTest{func, reference};
    frame.passes = {{state, 0}};
    return frame;
}

std::vector<Frame> alpha_frames(CompareFunc func) {
    std::vector<Frame> frames;
    for (const int k : {0, 1, 77, 127, 128, 200, 254, 255})
        frames.push_back(alpha_frame(func, k / 255.0));
    return frames;
}

/// No difference is allowed: alphas and references are whole bytes.
std::vector<Check> alpha_checks() {
    std::vector<Check> checks;
    for (std::size_t f = 0; f < compare_names.size(); ++f)
        checks.push_back({fmt::format("alpha test {}", compare_names[f]), {0, 0}, 0, [=] {
                              return alpha_frames(static_cast<CompareFunc>(f));
                          }});
    // A reference between two bytes: OpenGL rounds it to the framebuffer's bits before it compares.
    checks.push_back({"alpha test with reference 0.5", {0, 0}, 0, [] {
                          std::vector<Frame> frames;
                          for (std::size_t f = 0; f < compare_names.size(); ++f)
                              frames.push_back(alpha_frame(static_cast<CompareFunc>(f), 0.5));
                          return frames;
                      }});
    return checks;
}

/// Squares at 5 depths under squares at 5 depths; a third mesh shows what was written.
Frame depth_frame(CompareFunc func, bool write) {
    Frame frame = empty_frame(table_size);
    frame.meshes = {squares_at_depths(16, 7, 5), squares_at_depths(16, 9, 5),
                    squares_at_depths(16, 11, 5)};
    PassState state;
    state.depth_test = DepthTest{CompareFunc::always, true};
    frame.passes = {{state, 0}};
    state.depth_test = DepthTest{func, write};
    frame.passes.push_back({state, 1});
    state.depth_test = DepthTest{CompareFunc::less, true};
    frame.passes.push_back({state, 2});
    return frame;
}

/// No difference is allowed: the depths are constant within a square and far apart between them.
std::vector<Check> depth_checks() {
    std::vector<Check> checks;
    for (std::size_t f = 0; f < compare_names.size(); ++f)
        checks.push_back(
            {fmt::format("depth test {}", compare_names[f]), {0, 0}, 0, [=] {
                 const auto func = static_cast<CompareFunc>(f);
                 return std::vector<Frame>{depth_frame(func, true), depth_frame(func, false)};
             }});
    return checks;
}

/// Random source and destination colours, a constant of four different components.
Frame blend_frame(const Blend& blend) {
    Frame frame = empty_frame(table_size);
    frame.meshes = {squares(1, 12, true)};
    frame.textures = {random_texture(13, table_size)};
    frame.initial_color = {table_size, table_size, random_texels(14, table_size, table_size)};
    PassState state = replacing_state();
    state.blend = blend;
    state.blend->color = color_of({40, 255, 99, 170});
    frame.passes = {{state, 0}};
    return frame;
}

/// Every source factor with every destination factor but SRC_ALPHA_SATURATE, which is for sources.
std::vector<Frame> factor_pairs(BlendEquation equation) {
    std::vector<Frame> frames;
    constexpr std::size_t factors = 15;
    for (std::size_t s = 0; s < factors; ++s)
        for (std::size_t d = 0; d < factors; ++d) {
            const auto destination = static_cast<BlendFactor>(d);
            if (destination == BlendFactor::src_alpha_saturate) continue;
            frames.push_back(blend_frame({static_cast<BlendFactor>(s), destination, equation, {}}));
        }
    return frames;
}

/// One step: both round the sum once (a driver that rounds the two products apart may be a step
/// further). MIN and MAX round nothing.
std::vector<Check> blend_checks() {
    std::vector<Check> checks;
    for (std::size_t e = 0; e < equation_names.size(); ++e) {
        const auto equation = static_cast<BlendEquation>(e);
        const bool exact = equation >= BlendEquation::min;
        checks.push_back({fmt::format("blend {}", equation_names[e]), {exact ? 0 : 1, 0}, 0, [=] {
                              return exact
                                         ? std::vector<Frame>{blend_frame(
                                               {BlendFactor::zero, BlendFactor::one, equation, {}})}
                                         : factor_pairs(equation);
                          }});
    }
    return checks;
}

std::vector<Frame> mask_frames() {
    std::vector<Frame> frames;
    for (unsigned bits = 0; bits < 16; ++bits) {
        Frame frame = blend_frame({});
        frame.passes[0].state.blend.reset();
        for (std::size_t c = 0; c < 4; ++c)
            frame.passes[0].state.color_mask[c] = (bits >> c & 1U) != 0;
        frames.push_back(std::move(frame));
    }
    return frames;
}

std::vector<Frame> scissor_frames() {
    std::vector<Frame> frames;
    for (const Scissor scissor : {Scissor{3, 5, 20, 31}, Scissor{40, 50, 100, 100},
                                  Scissor{-5, -5, 12, 9}, Scissor{10, 10, 0, 0}}) {
        Frame frame = alpha_frame(CompareFunc::always, 0.0);
        frame.passes[0].state.scissor = scissor;
        frames.push_back(std::move(frame));
    }
    return frames;
}

}  // namespace

std::vector<Check> fragment_checks() {
    std::vector<Check> checks = alpha_checks();
    for (auto* more : {&depth_checks, &blend_checks})
        for (Check& check : more()) checks.push_back(std::move(check));
    checks.push_back({"colour mask", {0, 0}, 0, mask_frames});
    checks.push_back({"scissor", {0, 0}, 0, scissor_frames});
    return checks;
}

}  // namespace twofold::bench
