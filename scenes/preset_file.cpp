#include <fmt/format.h>

#include <algorithm>

#include "scenes/scene_names.hpp"
#include "scenes/scene_parts.hpp"

/// Numeric presets and the settings of the one that has some.
namespace twofold::scene_io {
namespace {

std::vector<std::string_view> preset_names() {
    std::vector<std::string_view> names;
    for (const Preset preset : all_presets) names.push_back(name_of(preset));
    names.push_back(name_of(Preset::custom));
    return names;
}

Preset read_preset(const JsonValue& value) {
    const auto preset = preset_named(value.text());
    if (!preset) value.fail_name("no preset named", value.text(), preset_names());
    return *preset;
}

int read_framebuffer_bits(const JsonObject& fields, int absent) {
    const auto value = fields.find("framebuffer_bits");
    if (!value) return absent;
    const int bits = value->integer(0, 8);
    if (bits > 0 && bits < 4) value->fail(fmt::format("{} is not 0 or 4 to 8", bits));
    return bits;
}

}  // namespace

std::vector<Preset> read_presets(const JsonValue& value) {
    std::vector<Preset> presets;
    for (const JsonValue& element : value.elements(1, all_presets.size() + 1)) {
        const Preset preset = read_preset(element);
        if (std::find(presets.begin(), presets.end(), preset) != presets.end())
            element.fail(element.shown() + " is named twice");
        presets.push_back(preset);
    }
    return presets;
}

CustomSettings read_custom(const JsonValue& value) {
    const JsonObject fields(
        value, {"filter_weight_bits", "filter_rounding", "product_rounding", "texel_bits",
                "register_bits", "vertex_color", "snap_bits", "snap_bias", "framebuffer_bits"});
    const CustomSettings absent;
    return {
        .filter_weight_bits =
            fields.integer("filter_weight_bits", 1, 16, absent.filter_weight_bits),
        .filter_rounding =
            fields.enumerator("filter_rounding", filter_rounding_names, absent.filter_rounding),
        .product_rounding =
            fields.enumerator("product_rounding", product_rounding_names, absent.product_rounding),
        .texel_bits = fields.integer("texel_bits", 4, 16, absent.texel_bits),
        .register_bits = fields.integer("register_bits", 8, 24, absent.register_bits),
        .vertex_color = fields.enumerator("vertex_color", vertex_color_names, absent.vertex_color),
        .snap_bits = fields.integer("snap_bits", 0, 12, absent.snap_bits),
        .snap_bias = fields.number("snap_bias", {.low = -1.0, .high = 1.0}, absent.snap_bias),
        .framebuffer_bits = read_framebuffer_bits(fields, absent.framebuffer_bits)};
}

}  // namespace twofold::scene_io
