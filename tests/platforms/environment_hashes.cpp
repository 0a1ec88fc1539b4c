#include "tests/platforms/preset_input.hpp"
#include "texunit/tex_env.hpp"

namespace twofold::platforms {
namespace {

constexpr std::size_t items = 64;

template <NumericModel M>
NamedHash env_hash(const M& m, const std::string& what, const TexEnv& env, BaseFormat format) {
    const auto constant = constant_color(m, Vec4{0.3, 0.7, 0.2, 0.9});
    return hash_over(preset_name("tex-env", m, what), items, [&](std::size_t i) {
        return apply_tex_env(m, env, constant, format, color(m, i, 1), color(m, i, 5),
                             color(m, i, 9));
    });
}

template <NumericModel M>
Hashes mode_hashes(const M& m) {
    constexpr std::array modes{"replace", "modulate", "decal", "blend", "add"};
    Hashes hashes;
    for (std::size_t mode = 0; mode < modes.size(); ++mode)
        for (int format = 0; format < 6; ++format) {
            TexEnv env;
            env.mode = static_cast<TexEnvMode>(mode);
            hashes.push_back(env_hash(m, fmt::format("{}-of-format-{}", modes[mode], format), env,
                                      static_cast<BaseFormat>(format)));
        }
    return hashes;
}

template <NumericModel M>
Hashes combine_hashes(const M& m) {
    Hashes hashes;
    for (int function = 0; function < 8; ++function)
        for (const int scale : {1, 2, 4}) {
            TexEnv env;
            env.mode = TexEnvMode::combine;
            env.combine_rgb = static_cast<CombineFunction>(function);
            env.combine_alpha = static_cast<CombineFunction>(function % 6);
            env.rgb_scale = env.alpha_scale = scale;
            env.rgb[1].operand = static_cast<CombineOperand>(function % 4);
            hashes.push_back(env_hash(m, fmt::format("combine-{}-times-{}", function, scale), env,
                                      BaseFormat::rgba));
        }
    return hashes;
}

}  // namespace

Hashes environment_hashes() {
    return over_presets([](const auto& m) {
        Hashes hashes = mode_hashes(m);
        append(hashes, combine_hashes(m));
        return hashes;
    });
}

}  // namespace twofold::platforms
