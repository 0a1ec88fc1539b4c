#include "texunit/preset.hpp"

#include <fmt/format.h>

namespace twofold {
namespace {

using enum Mark;

constexpr std::string_view gl = "OpenGL 1.3";
constexpr std::string_view nv1x = "public NV1x vertex model (envytools)";
constexpr std::string_view project = "this project";
constexpr std::string_view nv2a = "as on NV2A captures";
constexpr std::string_view nv2a_measured = "captures of NV2A, pixel by pixel";

constexpr std::array<StageRule, 19> ideal64_rules{{
    {"vertex transform, texgen, texture matrix", "binary64, to nearest", chosen, project},
    {"vertex colour", "binary64, clamped to [0, 1]", spec, "OpenGL 1.3, 2.13.8"},
    {"snap grid", "12 fraction bits: exact coverage, finer than any figure can see", chosen,
     project},
    {"snap origin and bias", "origin 0, bias 1/8192 pixel: to nearest", chosen, project},
    {"fill rule", "pixel centre, top-left", chosen, "OpenGL 1.3, 3.5.1 leaves shared edges open"},
    {"colour iterator", "binary64", chosen, project},
    {"s, t, q iteration and division", "binary64, one division a coordinate", chosen, project},
    {"texel fetch", "stored value exactly (binary32 or k / (2^n - 1))", chosen, project},
    {"filter weights", "real: frac(u - 1/2)", spec, "OpenGL 1.3, 3.8.7"},
    {"bilinear filter", "binary64", spec, "OpenGL 1.3, equation 3.20"},
    {"trilinear filter", "binary64", spec, "OpenGL 1.3, 3.8.8"},
    {"register format", "binary64", chosen, project},
    {"MODULATE product", "binary64", spec, "OpenGL 1.3, table 3.22"},
    {"scale, bias, sum", "binary64, clamped after the scale", spec, "OpenGL 1.3, 3.8.12"},
    {"alpha test", "real comparison", chosen, project},
    {"depth", "binary64", chosen, project},
    {"blend", "binary64, clamped to [0, 1]", spec, "OpenGL 1.3, 4.1.7"},
    {"colour write", "binary64 buffer; floor(255 x + 1/2) for display", chosen, project},
    {"dither", "off", chosen, project},
}};

constexpr std::array<StageRule, 19> float32_rules{{
    {"vertex transform, texgen, texture matrix",
     "binary32, to nearest, one rounding an operation, dot products left to right", chosen,
     project},
    {"vertex colour", "binary32, clamped to [0, 1]", spec, "OpenGL 1.3, 2.13.8"},
    {"snap grid", "4 fraction bits", chosen, project},
    {"snap origin and bias", "origin 0, bias 1/32 pixel", chosen, project},
    {"fill rule", "pixel centre, top-left", chosen, "OpenGL 1.3, 3.5.1 leaves shared edges open"},
    {"colour iterator", "binary32", chosen, project},
    {"s, t, q iteration and division", "binary32, one division a coordinate", chosen, project},
    {"texel fetch", "binary32 of the stored value", chosen, project},
    {"filter weights", "binary32: frac(u - 1/2)", chosen, project},
    {"bilinear filter", "binary32, along s then along t", chosen, project},
    {"trilinear filter", "binary32, between the two filtered levels", chosen, project},
    {"register format", "binary32", chosen, project},
    {"MODULATE product", "binary32", chosen, project},
    {"scale, bias, sum", "binary32, clamped after the scale", spec, "OpenGL 1.3, 3.8.12"},
    {"alpha test", "binary32 comparison", chosen, project},
    {"depth", "16 or 24 bits, to nearest", chosen, project},
    {"blend", "binary32, clamped to [0, 1]", chosen, project},
    {"colour write", "binary32 buffer; floor(255 x + 1/2) for display", chosen, project},
    {"dither", "off", chosen, project},
}};

constexpr std::array<StageRule, 19> gl13_rules{{
    {"vertex transform, texgen, texture matrix", "binary64 (no precision demanded)", spec, gl},
    {"vertex colour", "byte, floor(255 x + 1/2)", spec, "OpenGL 1.3, 2.13.9"},
    {"snap grid", "8 fraction bits, as drivers have", chosen,
     "OpenGL 1.3, table 6 demands at least 4"},
    {"snap origin and bias", "origin 0, bias 1/512 pixel: to nearest", chosen, project},
    {"fill rule", "pixel centre, top-left", chosen, "OpenGL 1.3, 3.5.1 leaves shared edges open"},
    {"colour iterator", "binary64, not rounded", chosen, project},
    {"s, t, q iteration and division", "binary64, one division a coordinate", chosen, project},
    {"texel fetch", "n bits, k / (2^n - 1)", spec, "OpenGL 1.3, 3.8.1"},
    {"filter weights", "real: frac(u - 1/2)", spec, "OpenGL 1.3, 3.8.7"},
    {"bilinear filter", "binary64, not rounded", chosen, project},
    {"trilinear filter", "binary64, not rounded", chosen, project},
    {"register format", "binary64, clamped as the text says", spec, "OpenGL 1.3, 3.8.12"},
    {"MODULATE product", "binary64; one floor(255 x + 1/2) after the last unit", chosen, project},
    {"scale, bias, sum", "binary64, clamped after the scale", spec, "OpenGL 1.3, 3.8.12"},
    {"alpha test", "bytes, integer comparison", spec, "OpenGL 1.3, 4.1.4"},
    {"depth", "16 or 24 bits, to nearest", chosen, project},
    {"blend", "bytes, the whole sum rounded once", spec, "OpenGL 1.3, 4.1.7"},
    {"colour write", "8 bits a channel as is; 16-bit formats cut", spec, "OpenGL 1.3, 4.1.7"},
    {"dither", "off (OpenGL's initial state is on); 16-bit formats on demand: 4 x 4 Bayer", chosen,
     project},
}};

constexpr std::array<StageRule, 19> nv17_rules{{
    {"vertex transform, texgen, texture matrix",
     "binary32 patterns, cut; sums of up to 4 terms at once; reciprocals by table and two Newton "
     "steps",
     spec, nv1x},
    {"vertex colour", "byte from 13 fraction bits; r, g, b through 22 bits first", spec, nv1x},
    {"snap grid", "4 fraction bits, cut toward zero", spec, nv1x},
    {"snap origin and bias", "origin 0, bias 1/32 pixel", chosen, project},
    {"fill rule", "pixel centre, top-left", inferred, nv2a},
    {"colour iterator", "weights of 8 bits, cut; the second vertex takes the rest; halves up",
     chosen, nv2a},
    {"s, t, q iteration and division", "binary64, one division a coordinate", chosen, project},
    {"texel fetch", "to 8 bits by repeating the pattern", inferred, nv2a},
    {"filter weights", "floor(256 frac(u - 1/2))", chosen, nv2a},
    {"bilinear filter", "bytes, along s then along t, halves up each time", chosen, nv2a},
    {"trilinear filter", "bytes, of the two rounded results; 8 fraction bits of the level", chosen,
     nv2a},
    {"register format", "9-bit signed, 255 = 1.0", spec, "NV_register_combiners, issue list"},
    {"MODULATE product", "bytes, round(a b / 255)", chosen, nv2a},
    {"scale, bias, sum", "integers: -128, shifts for 2 and 4, half rounds up; clamped", inferred,
     nv2a},
    {"alpha test", "bytes, integer comparison", spec, "OpenGL 1.3, 4.1.4"},
    {"depth", "n = 16 or 24 bits, floor(z (2^n - 1))", inferred, nv2a},
    {"blend", "bytes, the whole sum rounded once", spec, "OpenGL 1.3, 4.1.7"},
    {"colour write", "8 bits a channel as is; 16-bit formats cut", spec, "OpenGL 1.3, 4.1.7"},
    {"dither", "off; 16-bit formats on demand: 4 x 4 Bayer", chosen, project},
}};

constexpr std::array<StageRule, 19> nv2x_rules{{
    {"vertex transform, texgen, texture matrix",
     "as nv17 with rounded reciprocal seeds; coordinates are not multiplied by 1/w", inferred,
     nv1x},
    {"vertex colour", "byte from 13 fraction bits", measured, nv2a_measured},
    {"snap grid", "4 fraction bits, cut toward zero", measured, nv2a_measured},
    {"snap origin and bias", "origin 0, bias 1/32 pixel", spec,
     "viewport offset 0.53125 = 1/2 + 1/32 of the console's tools"},
    {"fill rule", "pixel centre, top-left", spec, "public notes on NV2A (xemu, pbkitplusplus)"},
    {"colour iterator", "weights of 8 bits, cut; the second vertex takes the rest; halves up",
     measured, nv2a_measured},
    {"s, t, q iteration and division", "binary64, one division a coordinate: the same texel",
     measured, nv2a_measured},
    {"texel fetch", "to 8 bits by repeating the pattern", measured, nv2a_measured},
    {"filter weights", "floor(256 frac(u - 1/2)): at least 7 bits were seen, 8 fit", measured,
     nv2a_measured},
    {"bilinear filter", "bytes, along s then along t, halves up each time", measured,
     nv2a_measured},
    {"trilinear filter", "bytes, of the two rounded results; 8 fraction bits of the level",
     measured, nv2a_measured},
    {"register format", "9-bit signed, 255 = 1.0", measured, nv2a_measured},
    {"MODULATE product",
     "bytes, round(a b / 255): measured in the final combiner, chosen in the general ones", chosen,
     nv2a},
    {"scale, bias, sum", "integers: -128, shifts for 2 and 4, half rounds up; clamped", measured,
     nv2a_measured},
    {"alpha test", "bytes, integer comparison", measured, nv2a_measured},
    {"depth", "n = 16 or 24 bits, floor(z (2^n - 1))", spec, "public notes on NV2A (xemu)"},
    {"blend", "bytes, the whole sum rounded once", measured, nv2a_measured},
    {"colour write", "8 bits a channel as is; 16-bit formats cut", measured, nv2a_measured},
    {"dither", "off; 16-bit formats on demand: 4 x 4 Bayer", chosen, project},
}};

/// The coarse end of what each stage could be; no chip is meant.
constexpr std::array<StageRule, 19> coarse8_rules{{
    {"vertex transform, texgen, texture matrix", "binary32, to nearest", chosen, project},
    {"vertex colour", "byte, floor(255 x)", chosen, project},
    {"snap grid", "4 fraction bits, cut toward zero", chosen, project},
    {"snap origin and bias", "origin 0, bias 0", chosen, project},
    {"fill rule", "pixel centre, top-left", chosen, project},
    {"colour iterator", "binary64, then cut", chosen, project},
    {"s, t, q iteration and division", "binary64; u and v cut to 1/16 texel", chosen, project},
    {"texel fetch", "to 8 bits by zeros below", chosen, project},
    {"filter weights", "floor(16 frac(u - 1/2))", chosen, project},
    {"bilinear filter", "four weights at once, their sum 256; cut", chosen, project},
    {"trilinear filter", "off: the finer level", chosen, project},
    {"register format", "8-bit unsigned", chosen, project},
    {"MODULATE product", "bytes, a b >> 8", chosen, project},
    {"scale, bias, sum", "shifts, clamped", chosen, project},
    {"alpha test", "bytes, reference cut; integer comparison", chosen, project},
    {"depth", "16 bits, cut", chosen, project},
    {"blend", "bytes, floor(s f / 255) + floor(d g / 255), clamped", chosen, project},
    {"colour write", "8 bits a channel as is; 16-bit formats cut", spec, "OpenGL 1.3, 4.1.7"},
    {"dither", "off; 16-bit formats on demand: 4 x 4 Bayer", chosen, project},
}};

constexpr std::string_view set = "as set; initially as nv17";

constexpr std::array<StageRule, 19> custom_rules{{
    {"vertex transform, texgen, texture matrix", "as nv17", chosen, project},
    {"vertex colour", set, chosen, project},
    {"snap grid", set, chosen, project},
    {"snap origin and bias", set, chosen, project},
    {"fill rule", "pixel centre, top-left", chosen, project},
    {"colour iterator", "as nv17, at the width of the registers", chosen, project},
    {"s, t, q iteration and division", "binary64, one division a coordinate", chosen, project},
    {"texel fetch", set, chosen, project},
    {"filter weights", set, chosen, project},
    {"bilinear filter", set, chosen, project},
    {"trilinear filter", "weights and rounding of the bilinear filter", chosen, project},
    {"register format", set, chosen, project},
    {"MODULATE product", set, chosen, project},
    {"scale, bias, sum", "as nv17, at the width of the registers", chosen, project},
    {"alpha test", "bytes, integer comparison", chosen, project},
    {"depth", "n = 16 or 24 bits, floor(z (2^n - 1))", chosen, project},
    {"blend", "bytes, the whole sum rounded once", chosen, project},
    {"colour write", set, chosen, project},
    {"dither", "off; 16-bit formats on demand: 4 x 4 Bayer", chosen, project},
}};

struct PresetTable {
    std::string_view name;
    std::string_view purpose;
    int version;
    const std::array<StageRule, 19>& rules;
};

const PresetTable& table_of(Preset preset) {
    static constexpr std::array<PresetTable, 7> tables{{
        {"ideal64", "truth: every stage in binary64, float textures", 1, ideal64_rules},
        {"float32", "every stage in binary32, float textures: for 8-bit versus float studies", 1,
         float32_rules},
        {"gl13", "what the text of OpenGL 1.3 alone implies for an 8-bit renderer", 2, gl13_rules},
        {"nv2x", "the family of the GeForce3 and 4 Ti: closest to silicon that can be checked", 2,
         nv2x_rules},
        {"nv17", "the paper's card: a GeForce4 MX (NV17/NV18), stage by stage", 2, nv17_rules},
        {"coarse8", "the lower bracket: how bad 8 bits could be", 2, coarse8_rules},
        {"custom", "nv17 with widths and roundings set at run time, for studies of one stage", 3,
         custom_rules},
    }};
    static_assert(tables.size() == static_cast<std::size_t>(Preset::custom) + 1);
    return tables[static_cast<std::size_t>(preset)];
}

}  // namespace

std::string_view name_of(Preset preset) { return table_of(preset).name; }

std::string_view name_of(Mark mark) {
    static constexpr std::array<std::string_view, 4> names{"spec", "measured", "inferred",
                                                           "chosen"};
    return names[static_cast<std::size_t>(mark)];
}

std::optional<Preset> preset_named(std::string_view name) {
    for (const Preset p : all_presets)
        if (name_of(p) == name) return p;
    if (name_of(Preset::custom) == name) return Preset::custom;
    return std::nullopt;
}

std::string_view purpose_of(Preset preset) { return table_of(preset).purpose; }

int version_of(Preset preset) { return table_of(preset).version; }

std::span<const StageRule> stage_rules(Preset preset) { return table_of(preset).rules; }

MarkCounts count_marks(Preset preset) {
    MarkCounts counts;
    for (const StageRule& r : stage_rules(preset)) {
        if (r.mark == spec || r.mark == measured) ++counts.sourced;
        if (r.mark == inferred) ++counts.inferred;
        if (r.mark == chosen) ++counts.chosen;
    }
    return counts;
}

std::string exactness_sentence(Preset preset) {
    const MarkCounts n = count_marks(preset);
    return fmt::format("bit-exact to preset {} v{}: {} stages sourced, {} inferred, {} chosen",
                       name_of(preset), version_of(preset), n.sourced, n.inferred, n.chosen);
}

}  // namespace twofold
