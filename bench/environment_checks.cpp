#include <fmt/format.h>

#include "bench/check.hpp"
#include "bench/tables.hpp"

/// Texture environments over tables of texel, primary, previous and constant colours.
namespace twofold::bench {
namespace {

constexpr std::array format_names{"alpha",     "luminance", "luminance_alpha",
                                  "intensity", "rgb",       "rgba"};
constexpr std::array mode_names{"replace", "modulate", "decal", "blend", "add"};
constexpr std::array function_names{"replace",     "modulate", "add",      "add_signed",
                                    "interpolate", "subtract", "dot3_rgb", "dot3_rgba"};

/// Unit 0 replaces by one random texture, unit 1 combines that with another: its previous, primary
/// and texture colours are independent. Each quarter of the picture has another constant colour,
/// black and white among them.
Frame table(const TexEnv& env, BaseFormat format) {
    Frame frame = empty_frame(table_size);
    frame.meshes = {squares(16, 1, true)};
    frame.textures = {random_texture(2, table_size), random_texture(3, table_size, format)};
    constexpr std::array<Rgba8, 4> constants{Rgba8{0, 0, 0, 0}, Rgba8{255, 255, 255, 255},
                                             Rgba8{51, 200, 128, 90}, Rgba8{230, 17, 101, 180}};
    constexpr int half = table_size / 2;
    for (int quarter = 0; quarter < 4; ++quarter) {
        PassState state;
        TexEnv replace;
        replace.mode = TexEnvMode::replace;
        state.units[0] = nearest_unit(0, replace);
        state.units[1] = nearest_unit(1, env);
        state.units[1]->env.color = color_of(constants[static_cast<std::size_t>(quarter)]);
        state.scissor = Scissor{half * (quarter % 2), half * (quarter / 2), half, half};
        frame.passes.push_back({state, 0});
    }
    return frame;
}

/// Argument number k of 16: every source with every operand.
CombineArgument argument(std::size_t k) {
    return {static_cast<CombineSource>(k % 4), static_cast<CombineOperand>(k / 4 % 4)};
}

/// Alpha takes no colour operands.
CombineArgument alpha_argument(std::size_t k) {
    return {static_cast<CombineSource>(k % 4), static_cast<CombineOperand>(2 + k / 4 % 2)};
}

/// Number k of 16: argument 0 runs through all, the others are shifted against it, and the scale
/// runs with it. Alpha, which has no dot product, takes another function each time.
TexEnv combine(CombineFunction function, std::size_t k) {
    TexEnv env;
    env.mode = TexEnvMode::combine;
    env.combine_rgb = function;
    env.combine_alpha = static_cast<CombineFunction>((static_cast<std::size_t>(function) + k) % 6);
    env.rgb = {argument(k), argument(k + 5), argument(k + 11)};
    env.alpha = {alpha_argument(k + 3), alpha_argument(k + 6), alpha_argument(k)};
    env.rgb_scale = 1 << k % 3;
    env.alpha_scale = 1 << (k + 1) % 3;
    return env;
}

std::vector<Frame> combine_frames(CombineFunction function, BaseFormat format) {
    std::vector<Frame> frames;
    for (std::size_t k = 0; k < 16; ++k) frames.push_back(table(combine(function, k), format));
    return frames;
}

/// DECAL is undefined but for RGB and RGBA.
bool defined(TexEnvMode mode, BaseFormat format) {
    return mode != TexEnvMode::decal || format >= BaseFormat::rgb;
}

/// One step: all values are whole bytes and both sides compute in floating point and round once at
/// the end, so that only exact halves may go either way.
Check mode_check(std::size_t mode, std::size_t format) {
    TexEnv env;
    env.mode = static_cast<TexEnvMode>(mode);
    const auto base = static_cast<BaseFormat>(format);
    return {fmt::format("env {}: {}", mode_names[mode], format_names[format]), {}, 0, [=] {
                return std::vector<Frame>{table(env, base)};
            }};
}

Check combine_check(std::size_t function, std::size_t format) {
    return {
        fmt::format("combine {}: {}", function_names[function], format_names[format]), {}, 0, [=] {
            return combine_frames(static_cast<CombineFunction>(function),
                                  static_cast<BaseFormat>(format));
        }};
}

}  // namespace

std::vector<Check> environment_checks() {
    std::vector<Check> checks;
    for (std::size_t m = 0; m < mode_names.size(); ++m)
        for (std::size_t f = 0; f < format_names.size(); ++f)
            if (defined(static_cast<TexEnvMode>(m), static_cast<BaseFormat>(f)))
                checks.push_back(mode_check(m, f));
    for (std::size_t c = 0; c < function_names.size(); ++c)
        for (std::size_t f = 0; f < format_names.size(); ++f) checks.push_back(combine_check(c, f));
    return checks;
}

}  // namespace twofold::bench
