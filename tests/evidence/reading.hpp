#pragma once
#include "scenes/json_reader.hpp"
#include "tests/evidence/description.hpp"

/// The parts of a description, each read by a file of its own. All throw Error naming file, field
/// and value.
namespace twofold::evidence {

using scene_io::JsonObject;
using scene_io::JsonValue;
using scene_io::Named;

/// [r, g, b, a] in bytes.
Rgba8 read_color(const JsonValue& value);

/// The same as numbers in [0, 1].
Vec4 read_color_as_reals(const JsonValue& value);

/// Some of the letters of "rgba", in that order.
std::array<bool, 4> read_channels(const JsonValue& value);

TexelRule read_texel_rule(const JsonValue& value);

TextureDescription read_texture(const JsonValue& value);

SurfaceDescription read_surface(const JsonValue& value);

RegisterCombiners read_combiners(const JsonValue& value);

/// @param depth_bits of the framebuffer; projections give depth in steps of its depth buffer
StateDescription read_state(const JsonValue& value, int depth_bits);

Command read_command(const JsonValue& value);

CompareRegion read_region(const JsonValue& value);

Expectation read_expectation(const JsonValue& value);

}  // namespace twofold::evidence
