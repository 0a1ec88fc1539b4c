#include "scenes/json_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "scenes/json_text.hpp"
#include "texunit/error.hpp"

namespace twofold::scene_io {
namespace {

/// Levenshtein distance; both are at most as long as `printable` lets them be.
std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t replaced = diagonal + (a[i] == b[j] ? 0U : 1U);
            diagonal = row[j + 1];
            row[j + 1] = std::min({row[j] + 1, row[j + 1] + 1, replaced});
        }
    }
    return row.back();
}

bool contains(Range range, double value) {
    const bool above = range.low_excluded ? value > range.low : value >= range.low;
    const bool below = range.high_excluded ? value < range.high : value <= range.high;
    return above && below;
}

std::string text_of(Range range) {
    std::string text = fmt::format("{}..{}", range.low, range.high);
    if (range.low_excluded && range.high_excluded)
        return text + fmt::format(" ({} and {} excluded)", range.low, range.high);
    if (range.low_excluded) return text + fmt::format(" ({} excluded)", range.low);
    if (range.high_excluded) return text + fmt::format(" ({} excluded)", range.high);
    return text;
}

std::string listed(std::initializer_list<std::string_view> names) {
    return fmt::format("{}", fmt::join(names, ", "));
}

/// Names that a scene's author chooses become parts of paths in error texts and of file names.
bool is_plain_name(std::string_view name) {
    return !name.empty() && name.size() <= 60 && std::all_of(name.begin(), name.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               c == '_' || c == '-';
    });
}

std::string joined(const std::string& path, std::string_view name) {
    return path.empty() ? printable(name) : path + "." + printable(name);
}

}  // namespace

std::string did_you_mean(std::string_view wrong, const std::vector<std::string_view>& known) {
    if (known.empty()) return "";
    const std::string name = printable(wrong);
    std::vector<std::size_t> distances;
    for (const std::string_view other : known) distances.push_back(edit_distance(name, other));
    const auto nearest = std::min_element(distances.begin(), distances.end()) - distances.begin();
    return fmt::format("; did you mean '{}'?", known[static_cast<std::size_t>(nearest)]);
}

void JsonValue::fail(std::string_view what) const {
    throw Error(ExitCode::failure, path_.empty() ? fmt::format("{}: {}", file_, what)
                                                 : fmt::format("{}: {}: {}", file_, path_, what));
}

void JsonValue::fail_name(std::string_view what, std::string_view name,
                          const std::vector<std::string_view>& known) const {
    fail(fmt::format("{} '{}'{}", what, printable(name), did_you_mean(name, known)));
}

std::string JsonValue::shown() const {
    if (json_->is_string())
        return fmt::format("'{}'", printable(json_->get_ref<const std::string&>()));
    if (json_->is_array()) return "a list";
    if (json_->is_object()) return "an object";
    return json_->dump();
}

double JsonValue::number(Range range) const {
    if (!json_->is_number()) fail(shown() + " is not a number");
    const double value = json_->get<double>();
    if (!contains(range, value)) fail(shown() + " is not in " + text_of(range));
    return value;
}

int JsonValue::integer(int low, int high) const {
    const double value =
        number({.low = static_cast<double>(low), .high = static_cast<double>(high)});
    if (value != std::floor(value)) fail(shown() + " is not a whole number");
    return static_cast<int>(value);
}

bool JsonValue::boolean() const {
    if (!json_->is_boolean()) fail(shown() + " is neither true nor false");
    return json_->get<bool>();
}

std::string JsonValue::text() const {
    if (!json_->is_string()) fail(shown() + " is not a text");
    return json_->get<std::string>();
}

std::vector<JsonValue> JsonValue::elements(std::size_t least, std::size_t most) const {
    if (!json_->is_array()) fail(shown() + " is not a list");
    const std::size_t count = json_->size();
    if (count < least || count > most)
        fail(least == most ? fmt::format("has {} elements, not {}", count, least)
                           : fmt::format("has {} elements, not {}..{}", count, least, most));
    std::vector<JsonValue> result;
    result.reserve(count);
    for (std::size_t i = 0; i < count; ++i)
        result.emplace_back((*json_)[i], file_, joined(path_, std::to_string(i)));
    return result;
}

std::vector<double> JsonValue::numbers(std::size_t least, std::size_t most, Range range) const {
    std::vector<double> result;
    for (const JsonValue& element : elements(least, most)) result.push_back(element.number(range));
    return result;
}

Vec3 JsonValue::vec3(Range range) const {
    const std::vector<double> v = numbers(3, 3, range);
    return {v[0], v[1], v[2]};
}

Rgb JsonValue::rgb(Range range) const {
    if (json_->is_array()) return vec3(range);
    if (!json_->is_number()) fail(shown() + " is neither [r, g, b] nor one number");
    return Rgb(number(range));
}

Vec4 JsonValue::vec4(Range range) const {
    const std::vector<double> v = numbers(4, 4, range);
    return {v[0], v[1], v[2], v[3]};
}

Mat4 JsonValue::mat4() const {
    // Far beyond any use, yet products of a dozen such numbers stay finite.
    const std::vector<double> rows = numbers(16, 16, {.low = -1e9, .high = 1e9});
    Mat4 matrix;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            matrix[column][row] = rows[static_cast<std::size_t>(4 * row + column)];
    return matrix;
}

std::optional<JsonValue> JsonValue::member(std::string_view key) const {
    const auto found = json_->find(key);
    if (found == json_->end()) return std::nullopt;
    return JsonValue(*found, file_, joined(path_, key));
}

std::vector<std::string> JsonValue::keys() const {
    std::vector<std::string> result;
    for (const auto& [key, member] : json_->items()) result.push_back(key);
    return result;
}

std::vector<std::pair<std::string, JsonValue>> JsonValue::named_members(std::size_t most) const {
    if (!json_->is_object()) fail(shown() + " is not an object");
    if (json_->size() > most) fail(fmt::format("has {} members, not 0..{}", json_->size(), most));
    std::vector<std::pair<std::string, JsonValue>> result;
    for (const auto& [key, member] : json_->items()) {
        if (!is_plain_name(key))
            fail(fmt::format("the name '{}' is not made of 1 to 60 letters, digits, _ and -",
                             printable(key)));
        result.emplace_back(key, JsonValue(member, file_, joined(path_, key)));
    }
    return result;
}

JsonObject::JsonObject(JsonValue value, std::initializer_list<std::string_view> known)
    : value_(std::move(value)), known_(known) {
    if (!value_.is_object()) value_.fail(value_.shown() + " is not an object");
    for (const std::string& key : value_.keys())
        if (std::find(known_.begin(), known_.end(), key) == known_.end())
            value_.member(key)->fail("unknown field" + did_you_mean(key, known_));
}

std::optional<JsonValue> JsonObject::enabled(std::string_view name) const {
    auto field = find(name);
    return field && field->is_null() ? std::nullopt : field;
}

JsonValue JsonObject::at(std::string_view name) const {
    if (const auto field = find(name)) return *field;
    value_.fail(fmt::format("the field '{}' is missing", name));
}

std::string_view JsonObject::one_of(std::initializer_list<std::string_view> names) const {
    std::string_view chosen;
    for (const std::string_view name : names) {
        if (!find(name)) continue;
        if (!chosen.empty())
            value_.fail(fmt::format("has both '{}' and '{}', needs one", chosen, name));
        chosen = name;
    }
    if (chosen.empty()) value_.fail("needs one of: " + listed(names));
    return chosen;
}

double JsonObject::number(std::string_view name, Range range, double absent) const {
    const auto field = find(name);
    return field ? field->number(range) : absent;
}

int JsonObject::integer(std::string_view name, int low, int high, int absent) const {
    const auto field = find(name);
    return field ? field->integer(low, high) : absent;
}

bool JsonObject::boolean(std::string_view name, bool absent) const {
    const auto field = find(name);
    return field ? field->boolean() : absent;
}

std::string JsonObject::text(std::string_view name, const std::string& absent) const {
    const auto field = find(name);
    return field ? field->text() : absent;
}

Vec3 JsonObject::vec3(std::string_view name, Range range, Vec3 absent) const {
    const auto field = find(name);
    return field ? field->vec3(range) : absent;
}

Rgb JsonObject::rgb(std::string_view name, Range range, Rgb absent) const {
    const auto field = find(name);
    return field ? field->rgb(range) : absent;
}

Vec4 JsonObject::vec4(std::string_view name, Range range, Vec4 absent) const {
    const auto field = find(name);
    return field ? field->vec4(range) : absent;
}

}  // namespace twofold::scene_io
