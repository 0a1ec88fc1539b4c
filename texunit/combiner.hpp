#pragma once
#include <vector>

#include "texunit/numeric_model.hpp"

/// The register combiners: general stages, then the final one.
/// @source NV_register_combiners specification, 3.8.12
namespace twofold {

/// What the registers hold before the first stage. A texture holds what its base format keeps; fog
/// is the fog colour, with the fog factor as its alpha.
template <NumericModel M>
struct CombinerInputs {
    Color<typename M::Channel> primary, secondary, fog;
    std::array<Color<typename M::Channel>, max_units> texture;
};

/// constant_color0 and constant_color1 in the preset's channels.
template <NumericModel M>
using CombinerConstants = std::array<Color<typename M::Channel>, 2>;

/// The state with its constants converted, once for all fragments.
template <NumericModel M>
struct BoundCombiners {
    struct Stage {
        CombinerPortion rgb, alpha;
        CombinerConstants<M> constants;
    };
    std::vector<Stage> stages;
    FinalCombiner final_stage;
    CombinerConstants<M> final_constants;
};

template <NumericModel M>
BoundCombiners<M> bind_combiners(const M& m, const RegisterCombiners& state) {
    const auto constants = [&m](const auto& stage) {
        return CombinerConstants<M>{constant_color(m, stage.constant_color0),
                                    constant_color(m, stage.constant_color1)};
    };
    BoundCombiners<M> bound{{}, state.final_stage, constants(state.final_stage)};
    bound.stages.reserve(state.stages.size());
    for (const CombinerStage& s : state.stages)
        bound.stages.push_back({s.rgb, s.alpha, constants(s)});
    return bound;
}

/// The registers of one fragment, by CombinerRegister.
template <NumericModel M>
class CombinerRegisters {
  public:
    using Value = Color<typename M::Channel>;

    /// Spare0 starts with texture 0's alpha; the other spare components, which the specification
    /// leaves open, with 0.
    explicit CombinerRegisters(const CombinerInputs<M>& in) {
        values_.fill(Value{});
        (*this)[CombinerRegister::primary_color] = in.primary;
        (*this)[CombinerRegister::secondary_color] = in.secondary;
        (*this)[CombinerRegister::fog] = in.fog;
        for (std::size_t u = 0; u < max_units; ++u)
            values_[static_cast<std::size_t>(CombinerRegister::texture0) + u] = in.texture[u];
        (*this)[CombinerRegister::spare0][3] = in.texture[0][3];
    }

    Value& operator[](CombinerRegister r) { return values_[static_cast<std::size_t>(r)]; }
    const Value& operator[](CombinerRegister r) const {
        return values_[static_cast<std::size_t>(r)];
    }

    void set_constants(const CombinerConstants<M>& c) {
        (*this)[CombinerRegister::constant_color0] = c[0];
        (*this)[CombinerRegister::constant_color1] = c[1];
    }

  private:
    std::array<Value, static_cast<std::size_t>(CombinerRegister::e_times_f) + 1> values_;
};

/// @source NV_register_combiners, table of input mappings
template <NumericModel M>
typename M::Channel mapped(const M& m, CombinerMapping mapping, typename M::Channel e) {
    constexpr typename M::Channel zero{0};
    switch (mapping) {
        case CombinerMapping::unsigned_identity:
            break;
        case CombinerMapping::unsigned_invert:
            return m.invert(e);
        case CombinerMapping::expand_normal:
            return m.expand_normal(e);
        case CombinerMapping::expand_negate:
            return m.negate(m.expand_normal(e));
        case CombinerMapping::half_bias_normal:
            return m.half_bias(e);
        case CombinerMapping::half_bias_negate:
            return m.negate(m.half_bias(e));
        case CombinerMapping::signed_identity:
            return e;
        case CombinerMapping::signed_negate:
            return m.negate(e);
    }
    return e > zero ? e : zero;
}

/// One input: channels 0 to 2 for the RGB portion, 3 for the alpha portion. There one bit chooses
/// alpha or blue, so that `rgb` means blue.
template <NumericModel M>
Color<typename M::Channel> read_input(const M& m, const CombinerInput& input,
                                      const CombinerRegisters<M>& registers) {
    Color<typename M::Channel> e = registers[input.source];
    if (input.component == CombinerComponent::alpha) e = {e[3], e[3], e[3], e[3]};
    if (input.component == CombinerComponent::blue) e = {e[2], e[2], e[2], e[2]};
    if (input.component == CombinerComponent::rgb) e[3] = e[2];
    for (auto& channel : e) channel = mapped(m, input.mapping, channel);
    return e;
}

/// The channels a portion computes: 0 to 2 or 3 alone.
struct PortionChannels {
    std::size_t first, end;
};

/// What a portion of a general stage makes of its inputs, before it is stored.
template <NumericModel M>
struct PortionResult {
    Color<typename M::Channel> ab, cd, sum;
};

/// What MUX selects by spare0's alpha: its highest bit, or on NV2x its lowest.
template <NumericModel M>
bool mux_takes_ab(const M& m, const CombinerPortion& portion, typename M::Channel spare0_alpha) {
    if (portion.mux_by_lowest_bit) return (m.to_unorm8(m.finish(spare0_alpha)) & 1) == 0;
    return m.add(spare0_alpha, spare0_alpha) < m.one();
}

/// AB and CD (products or dot products), and AB + CD rounded once or, with mux, one of the two.
template <NumericModel M>
PortionResult<M> evaluate(const M& m, const CombinerPortion& portion, PortionChannels channels,
                          const CombinerRegisters<M>& registers) {
    const auto a = read_input(m, portion.input[0], registers);
    const auto b = read_input(m, portion.input[1], registers);
    const auto c = read_input(m, portion.input[2], registers);
    const auto d = read_input(m, portion.input[3], registers);
    const bool takes_ab = mux_takes_ab(m, portion, registers[CombinerRegister::spare0][3]);
    const auto stored = [&](typename M::Channel x) {
        return m.scale_and_bias(x, portion.scale, portion.bias_by_negative_one_half);
    };
    PortionResult<M> r{};
    for (std::size_t k = channels.first; k < channels.end; ++k) {
        const auto ab = portion.ab_dot_product ? m.dot(a, b) : m.product(a[k], b[k]);
        const auto cd = portion.cd_dot_product ? m.dot(c, d) : m.product(c[k], d[k]);
        r.ab[k] = stored(ab);
        r.cd[k] = stored(cd);
        r.sum[k] =
            stored(portion.mux ? (takes_ab ? ab : cd) : m.sum_of_products(a[k], b[k], c[k], d[k]));
    }
    return r;
}

/// Writes one output; @param blue_to_alpha copies blue into the register's alpha too
template <NumericModel M>
void store(const std::optional<CombinerRegister>& output, const Color<typename M::Channel>& value,
           PortionChannels channels, bool blue_to_alpha, CombinerRegisters<M>& registers) {
    if (!output) return;
    for (std::size_t k = channels.first; k < channels.end; ++k) registers[*output][k] = value[k];
    if (blue_to_alpha) registers[*output][3] = value[2];
}

template <NumericModel M>
void store(const CombinerPortion& portion, const PortionResult<M>& result, PortionChannels channels,
           CombinerRegisters<M>& registers) {
    store<M>(portion.ab_output, result.ab, channels, portion.ab_blue_to_alpha, registers);
    store<M>(portion.cd_output, result.cd, channels, portion.cd_blue_to_alpha, registers);
    store<M>(portion.sum_output, result.sum, channels, false, registers);
}

/// Both portions read the registers as the stage before left them.
template <NumericModel M>
void run_general_stage(const M& m, const typename BoundCombiners<M>::Stage& stage,
                       CombinerRegisters<M>& registers) {
    constexpr PortionChannels rgb{0, 3}, alpha{3, 4};
    registers.set_constants(stage.constants);
    const PortionResult<M> rgb_result = evaluate(m, stage.rgb, rgb, registers);
    const PortionResult<M> alpha_result = evaluate(m, stage.alpha, alpha, registers);
    store(stage.rgb, rgb_result, rgb, registers);
    store(stage.alpha, alpha_result, alpha, registers);
}

/// Spare0 + secondary colour, each from 0 up: as much as 2, or 1 with COLOR_SUM_CLAMP.
template <NumericModel M>
Color<typename M::Channel> spare0_plus_secondary(const M& m, const FinalCombiner& state,
                                                 const CombinerRegisters<M>& registers) {
    const auto& spare0 = registers[CombinerRegister::spare0];
    const auto& secondary = registers[CombinerRegister::secondary_color];
    Color<typename M::Channel> sum{};
    for (std::size_t k = 0; k < 3; ++k) {
        const auto r = state.invert_spare0 ? m.invert(spare0[k]) : m.clamp_unsigned(spare0[k]);
        const auto v =
            state.invert_secondary ? m.invert(secondary[k]) : m.clamp_unsigned(secondary[k]);
        sum[k] = m.add(r, v);
        if (state.clamp_sum) sum[k] = m.clamp_unsigned(sum[k]);
    }
    return sum;
}

template <NumericModel M>
Color<typename M::Channel> run_final_stage(const M& m, const BoundCombiners<M>& state,
                                           CombinerRegisters<M>& registers) {
    const FinalCombiner& f = state.final_stage;
    registers.set_constants(state.final_constants);
    const auto e = read_input(m, f.e, registers), other = read_input(m, f.f, registers);
    for (std::size_t k = 0; k < 3; ++k)
        registers[CombinerRegister::e_times_f][k] = m.product(e[k], other[k]);
    registers[CombinerRegister::spare0_plus_secondary_color] =
        spare0_plus_secondary(m, f, registers);

    const auto a = read_input(m, f.a, registers), b = read_input(m, f.b, registers);
    const auto c = read_input(m, f.c, registers), d = read_input(m, f.d, registers);
    Color<typename M::Channel> result{};
    for (std::size_t k = 0; k < 3; ++k) {
        const auto mixed = m.sum_of_products(a[k], b[k], m.invert(a[k]), c[k]);
        result[k] = m.clamp_unsigned(m.add(mixed, d[k]));
    }
    result[3] = m.clamp_unsigned(read_input(m, f.g, registers)[3]);
    return result;
}

/// The colour of one fragment, each component in [0, 1].
template <NumericModel M>
Color<typename M::Channel> run_combiners(const M& m, const BoundCombiners<M>& state,
                                         const CombinerInputs<M>& in) {
    CombinerRegisters<M> registers(in);
    for (const auto& stage : state.stages) run_general_stage(m, stage, registers);
    return run_final_stage(m, state, registers);
}

/// The same for state that was not bound: converts its constants anew.
template <NumericModel M>
Color<typename M::Channel> run_combiners(const M& m, const RegisterCombiners& state,
                                         const CombinerInputs<M>& in) {
    return run_combiners(m, bind_combiners(m, state), in);
}

}  // namespace twofold
