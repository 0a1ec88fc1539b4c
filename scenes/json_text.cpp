#include "scenes/json_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <set>
#include <vector>

#include "texunit/error.hpp"

namespace twofold::scene_io {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

[[noreturn]] void fail(std::string_view file, std::string_view where, std::string_view what) {
    throw Error(ExitCode::failure, where.empty() ? fmt::format("{}: {}", file, what)
                                                 : fmt::format("{}: {}: {}", file, where, what));
}

/// Follows the parser's events and knows the path of the field that is being read. The parser
/// itself keeps the last of two equal keys without a word, which would hide half of a scene.
class Watcher {
  public:
    explicit Watcher(std::string_view file) : file_(file) {}

    void see(json::parse_event_t event, const json& parsed) {
        using Event = json::parse_event_t;
        if (event == Event::key) return enter_key(parsed.get_ref<const std::string&>());
        if (event == Event::object_end || event == Event::array_end) return levels_.pop_back();
        if (!levels_.empty() && levels_.back().list) ++levels_.back().index;
        if (event != Event::value) open(event == Event::array_start);
    }

    /// Path of the value that the parser would report next.
    std::string next_path() const { return path(1); }

  private:
    struct Level {
        bool list = false;
        int index = -1;
        std::string key;
        std::set<std::string> seen;
    };

    void open(bool list) {
        if (levels_.size() == max_json_depth)
            fail(file_, path(0), fmt::format("nested deeper than {} levels", max_json_depth));
        levels_.push_back({.list = list, .index = -1, .key = {}, .seen = {}});
    }

    void enter_key(const std::string& key) {
        Level& level = levels_.back();
        level.key = key;
        if (!level.seen.insert(key).second) fail(file_, path(0), "is written twice");
    }

    std::string path(int ahead) const {
        std::string text;
        for (const Level& level : levels_) {
            const int index = level.index + (&level == &levels_.back() ? ahead : 0);
            if (!text.empty()) text += '.';
            text += level.list ? std::to_string(index) : printable(level.key);
        }
        return text;
    }

    std::string_view file_;
    std::vector<Level> levels_;
};

/// The library's text without its own prefix: "line 3, column 5: syntax error ...".
std::string syntax_message(std::string_view what) {
    const std::size_t line = what.find("line ");
    return printable(line == std::string_view::npos ? what : what.substr(line), 240);
}

void check_bytes(std::string_view text, std::string_view file) {
    if (text.size() > max_json_bytes)
        fail(file, "", fmt::format("is larger than {} bytes", max_json_bytes));
    // The library takes a NUL byte for the end of the input and would ignore what follows.
    const std::size_t nul = text.find('\0');
    if (nul == std::string_view::npos) return;
    const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<long>(nul), '\n');
    const std::size_t start = text.rfind('\n', nul);
    const std::size_t column = start == std::string_view::npos ? nul + 1 : nul - start;
    fail(file, "", fmt::format("line {}, column {}: a NUL byte", line, column));
}

std::vector<std::string> split_path(std::string_view path) {
    std::vector<std::string> parts;
    for (std::size_t start = 0; start <= path.size();) {
        const std::size_t end = std::min(path.find('.', start), path.size());
        parts.emplace_back(path.substr(start, end - start));
        start = end + 1;
    }
    return parts;
}

/// The element of the list `list` that `part` names.
json& element_at(json& list, const std::string& part, std::string_view path,
                 std::string_view file) {
    std::size_t index = 0;
    const char* const end = part.data() + part.size();
    const auto [stop, error] = std::from_chars(part.data(), end, index);
    if (error != std::errc{} || stop != end || index >= list.size())
        fail(file, path,
             fmt::format("override: '{}' is not an index of a list of {} elements", printable(part),
                         list.size()));
    return list[index];
}

json& child_at(json& parent, const std::string& part, std::string_view path,
               std::string_view file) {
    if (parent.is_array()) return element_at(parent, part, path, file);
    if (!parent.is_object() && !parent.is_null())
        fail(file, path, fmt::format("override: what holds '{}' is a plain value", part));
    return parent[part];
}

json override_value(const std::string& text, std::string_view path, std::string_view file) {
    if (json::accept(text)) return parse_json(text, fmt::format("{}: {}", file, path));
    try {
        static_cast<void>(json(text).dump());
    } catch (const json::type_error&) {
        fail(file, path, fmt::format("override: '{}' is not UTF-8", printable(text)));
    }
    return text;
}

std::string one_line(const ordered_json& value) {
    try {
        return value.dump();
    } catch (const ordered_json::type_error&) {
        throw Error(ExitCode::failure, "a scene cannot be written: a text in it is not UTF-8");
    }
}

bool is_plain_list(const ordered_json& value) {
    return value.is_array() && std::none_of(value.begin(), value.end(), [](const auto& element) {
               return element.is_structured();
           });
}

std::string plain_list(const ordered_json& list) {
    std::string text;
    for (const ordered_json& element : list) text += (text.empty() ? "" : ", ") + one_line(element);
    return fmt::format("[{}]", text);
}

std::string indented(const ordered_json& value, std::size_t depth) {
    if (!value.is_structured() || value.empty()) return one_line(value);
    if (is_plain_list(value)) return plain_list(value);
    const std::string margin(2 * depth + 2, ' ');
    std::string text;
    for (const auto& [key, child] : value.items()) {
        text += text.empty() ? "\n" : ",\n";
        text += margin + (value.is_object() ? one_line(key) + ": " : "");
        text += indented(child, depth + 1);
    }
    const std::string end = fmt::format("\n{:{}}", "", 2 * depth);
    return value.is_object() ? fmt::format("{{{}{}}}", text, end)
                             : fmt::format("[{}{}]", text, end);
}

}  // namespace

nlohmann::json parse_json(std::string_view text, std::string_view file) {
    check_bytes(text, file);
    Watcher watcher(file);
    const auto callback = [&](int, json::parse_event_t event, const json& parsed) {
        watcher.see(event, parsed);
        return true;
    };
    try {
        return json::parse(text, callback, true, true);
    } catch (const json::parse_error& error) {
        fail(file, "", syntax_message(error.what()));
    } catch (const json::out_of_range&) {
        fail(file, watcher.next_path(), "the number is too large for binary64");
    }
}

nlohmann::json with_override(nlohmann::json document, std::string_view change,
                             std::string_view file) {
    const std::size_t equals = change.find('=');
    if (equals == std::string_view::npos)
        fail(
            file, "",
            fmt::format("override '{}' is not of the form path.to.field=value", printable(change)));
    const std::string path = printable(change.substr(0, equals));
    json* place = &document;
    for (const std::string& part : split_path(change.substr(0, equals))) {
        if (part.empty())
            fail(file, "",
                 fmt::format("override '{}' has an empty name in its path", printable(change)));
        place = &child_at(*place, part, path, file);
    }
    *place = override_value(std::string(change.substr(equals + 1)), path, file);
    return document;
}

std::string to_text(const nlohmann::ordered_json& document) { return indented(document, 0) + "\n"; }

}  // namespace twofold::scene_io
