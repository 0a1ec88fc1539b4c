#pragma once
#include <array>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "raster/pass.hpp"
#include "tests/evidence/texel_rules.hpp"

/// What a description of a capture says, as values: everything that was drawn, and which pixels of
/// the capture are to be compared.
namespace twofold::evidence {

/// The texture is a surface's memory, read in the texture's own format.
struct SurfaceView {
    std::string surface;
};

/// One picture for each mipmap level, or a surface's memory.
using TextureSource = std::variant<std::vector<TexelRule>, SurfaceView>;

struct TextureDescription {
    int width = 0, height = 0;
    TextureFormat format = TextureFormat::argb8888;
    bool swap_red_and_blue = false;
    TextureSource source;
};

struct SurfaceDescription {
    int width = 0, height = 0;
    ColorFormat format = ColorFormat::rgba8888;
    TexelRule initial;
};

/// A pass without its mesh, with textures still by name; an empty name is a unit that is off.
struct StateDescription {
    PassState pass;
    std::array<std::string, max_units> textures;
};

/// Primitives drawn with one state; window positions still hold depth in depth-buffer units.
struct DrawCommand {
    std::string state;
    Mesh mesh;
};

/// Memory written directly, past the pipeline.
struct FillCommand {
    TexelRule texels;
};

struct Command {
    std::string target;
    std::variant<DrawCommand, FillCommand> what;
};

struct Rectangle {
    int x = 0, y = 0, width = 0, height = 0;
};

/// The pixels in `include` but not in `exclude`, and the channels r, g, b, a of them.
struct CompareRegion {
    std::vector<Rectangle> include, exclude;
    std::array<bool, 4> channels{true, true, true, true};
};

/// What an independent renderer got from the same description.
struct Expectation {
    bool reproduced = true;
    int pixels_compared = 0;
    int pixels_drawn = 0;
    int pixels_wrong = 0;
    int max_difference = 0;
    std::vector<std::pair<int, int>> deviating_pixels;  ///< x, y
};

/// The target's name that means the framebuffer.
inline constexpr const char* framebuffer_name = "framebuffer";

struct Description {
    std::string id;       ///< SUITE/TEST
    std::string capture;  ///< path of the PNG below the pack's folder
    int depth_bits = 24;
    double depth_clear = 1.0;
    std::map<std::string, TextureDescription> textures;
    std::map<std::string, SurfaceDescription> surfaces;  ///< the framebuffer among them
    std::map<std::string, StateDescription> states;
    std::vector<Command> commands;  ///< in order
    CompareRegion region;
    std::optional<Expectation> expectation;
};

/// The description that a JSON text holds. Every field is checked: one that is not known, is
/// missing or has a value that means nothing is an error.
/// @param file name for error texts
/// @throws Error naming file, field and value
Description parse_description(std::string_view text, std::string_view file);

}  // namespace twofold::evidence
