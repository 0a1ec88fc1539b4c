#include <fmt/format.h>

#include <array>

#include "texunit/byte_cursor.hpp"
#include "texunit/image_header.hpp"

namespace twofold {
namespace {

constexpr std::uint32_t deep_flag = 0x800, several_parts_flag = 0x1000;
constexpr std::size_t most_name_bytes = 255;

/// An attribute's type whose values all have one size. OpenEXR reads as many bytes whatever the
/// file says, and would then take what follows for something else than it was checked as.
struct FixedType {
    std::string_view name;
    std::size_t bytes;
};

constexpr std::array<FixedType, 24> fixed_types{
    {{"box2f", 16},      {"box2i", 16},   {"chromaticities", 32},
     {"compression", 1}, {"double", 8},   {"envmap", 1},
     {"float", 4},       {"int", 4},      {"keycode", 28},
     {"lineOrder", 1},   {"m33f", 36},    {"m33d", 72},
     {"m44f", 64},       {"m44d", 128},   {"rational", 8},
     {"tiledesc", 9},    {"v2f", 8},      {"v2d", 16},
     {"v2i", 8},         {"v3f", 12},     {"v3d", 24},
     {"v3i", 12},        {"timecode", 8}, {"deepImageState", 1}}};

void check_fixed_size(std::string_view type, const ByteCursor& at) {
    for (const FixedType& fixed : fixed_types)
        if (fixed.name == type && fixed.bytes != at.left())
            at.fail(fmt::format("an attribute of type {} with {} bytes, not {}", type, at.left(),
                                fixed.bytes));
}

/// Up to a NUL byte.
std::string read_name(ByteCursor& at) {
    std::string text;
    while (const auto c = at.value<std::uint8_t>()) {
        if (text.size() == most_name_bytes) at.fail("a name of more than 255 bytes");
        text.push_back(static_cast<char>(c));
    }
    return text;
}

/// xmin, ymin, xmax, ymax, both ends included.
void check_window(ByteCursor at) {
    std::array<std::int64_t, 4> edge{};
    for (std::int64_t& e : edge) e = at.value<std::int32_t>();
    check_picture_size(edge[2] - edge[0] + 1, edge[3] - edge[1] + 1, at.name());
}

void check_tiles(ByteCursor at) {
    const std::int64_t width = at.value<std::uint32_t>(), height = at.value<std::uint32_t>();
    if (width < 1 || width > max_picture_side || height < 1 || height > max_picture_side)
        at.fail(fmt::format("tiles of {} x {}", width, height));
}

/// Each channel is a name and 16 bytes; an empty name ends the list.
void check_channels(ByteCursor at) {
    int channels = 0;
    while (!read_name(at).empty()) {
        at.take(16);
        if (++channels > max_picture_channels)
            at.fail(fmt::format("more than {} channels", max_picture_channels));
    }
    if (at.left() != 0) at.fail("a list of channels that ends early");
}

void check_preview(ByteCursor at) {
    const std::uint64_t width = at.value<std::uint32_t>(), height = at.value<std::uint32_t>();
    if (width > at.left() || height > at.left() || 4 * width * height != at.left())
        at.fail(fmt::format("a preview of {} x {} pixels", width, height));
}

/// Attributes by which OpenEXR allocates. `at` sees this one alone.
void check_attribute(const std::string& name, const std::string& type, const ByteCursor& at) {
    check_fixed_size(type, at);
    if (name == "dataWindow" || name == "displayWindow") check_window(at);
    if (type == "tiledesc") check_tiles(at);
    if (type == "chlist") check_channels(at);
    if (type == "preview") check_preview(at);
    if (type == "idmanifest")
        at.fail("an attribute of type idmanifest, which a picture of colours has no use for");
}

/// @return whether there was one: an empty name ends a header
bool read_attribute(ByteCursor& at) {
    const std::string name = read_name(at);
    if (name.empty()) return false;
    const std::string type = read_name(at);
    const auto size = at.value<std::uint32_t>();
    const std::string place = fmt::format("{}: attribute '{}'", at.name(), printable(name));
    check_attribute(name, type, ByteCursor(at.take(size), place));
    return true;
}

}  // namespace

void check_openexr(std::span<const unsigned char> bytes, const std::string& name) {
    ByteCursor at(bytes, name);
    at.take(4);
    const auto flags = at.value<std::uint32_t>();
    if ((flags & deep_flag) != 0) at.fail("a deep image");
    bool more = true;
    while (more) {
        bool empty = true;
        while (read_attribute(at)) empty = false;
        // An empty header ends the list of several.
        more = (flags & several_parts_flag) != 0 && !empty;
    }
}

}  // namespace twofold
