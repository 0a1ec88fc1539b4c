#include "scenes/ply_header.hpp"

#include <fmt/format.h>

#include <map>

#include "texunit/error.hpp"
#include "texunit/number_text.hpp"

namespace twofold::ply {
namespace {

Type parse_type(std::string_view word, const std::string& name) {
    static const std::map<std::string_view, Type> types{{"char", {Kind::signed_integer, 1}},
                                                        {"int8", {Kind::signed_integer, 1}},
                                                        {"uchar", {Kind::unsigned_integer, 1}},
                                                        {"uint8", {Kind::unsigned_integer, 1}},
                                                        {"short", {Kind::signed_integer, 2}},
                                                        {"int16", {Kind::signed_integer, 2}},
                                                        {"ushort", {Kind::unsigned_integer, 2}},
                                                        {"uint16", {Kind::unsigned_integer, 2}},
                                                        {"int", {Kind::signed_integer, 4}},
                                                        {"int32", {Kind::signed_integer, 4}},
                                                        {"uint", {Kind::unsigned_integer, 4}},
                                                        {"uint32", {Kind::unsigned_integer, 4}},
                                                        {"float", {Kind::real, 4}},
                                                        {"float32", {Kind::real, 4}},
                                                        {"double", {Kind::real, 8}},
                                                        {"float64", {Kind::real, 8}}};
    const auto found = types.find(word);
    if (found == types.end()) fail(name, fmt::format("unknown PLY type '{}'", printable(word, 40)));
    return found->second;
}

bool parse_format(std::string_view line, const std::string& name) {
    const std::string_view format = take_word(line);
    if (format != "ascii" && format != "binary_little_endian")
        fail(name, fmt::format("PLY format '{}'; readable are ascii and binary_little_endian",
                               printable(format, 40)));
    return format != "ascii";
}

Element parse_element(std::string_view line, const std::string& name) {
    const std::string_view element = take_word(line);
    const auto count = parse_integer(take_word(line));
    if (!count || *count < 0)
        fail(name, fmt::format("element '{}' without a count", printable(element)));
    return {std::string(element), static_cast<std::size_t>(*count), {}};
}

Property parse_property(std::string_view line, const std::string& name) {
    const std::string_view first = take_word(line);
    if (first != "list") return {std::string(take_word(line)), parse_type(first, name), {}};
    const Type count = parse_type(take_word(line), name);
    const Type type = parse_type(take_word(line), name);
    return {std::string(take_word(line)), type, count};
}

void add_line(Header& header, std::string_view keyword, std::string_view rest,
              const std::string& name) {
    if (keyword == "format") {
        header.binary = parse_format(rest, name);
    } else if (keyword == "element") {
        header.elements.push_back(parse_element(rest, name));
    } else if (keyword == "property") {
        if (header.elements.empty()) fail(name, "a PLY property before any element");
        header.elements.back().properties.push_back(parse_property(rest, name));
    } else if (!keyword.empty() && keyword != "comment" && keyword != "obj_info") {
        fail(name, fmt::format("unknown PLY header line '{}'", printable(keyword, 40)));
    }
}

}  // namespace

void fail(const std::string& name, const std::string& what) {
    throw Error(ExitCode::bad_file, name + ": " + what);
}

Header parse_header(std::string_view text, const std::string& name) {
    Header header;
    if (take_line(text) != "ply") fail(name, "not a PLY file");
    while (!text.empty()) {
        std::string_view line = take_line(text);
        const std::string_view keyword = take_word(line);
        if (keyword == "end_header") {
            header.data = text;
            return header;
        }
        add_line(header, keyword, line, name);
    }
    fail(name, "truncated: the PLY header has no end");
}

}  // namespace twofold::ply
