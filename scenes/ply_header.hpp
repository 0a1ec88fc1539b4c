#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// The header of a PLY file: what its data section holds.
namespace twofold::ply {

enum class Kind { signed_integer, unsigned_integer, real };

struct Type {
    Kind kind;
    std::size_t bytes;
};

struct Property {
    std::string name;
    Type type;
    std::optional<Type> count;  ///< of the number in front of a list; nothing for a single value
};

struct Element {
    std::string name;
    std::size_t count;
    std::vector<Property> properties;
};

struct Header {
    bool binary = false;
    std::vector<Element> elements;
    std::string_view data;  ///< what follows the line end_header
};

/// The header of the file `text`, which must outlive it.
/// @throws Error(bad_file) that begins with `name`.
Header parse_header(std::string_view text, const std::string& name);

/// @throws Error(bad_file) with the text "NAME: WHAT", always.
[[noreturn]] void fail(const std::string& name, const std::string& what);

}  // namespace twofold::ply
