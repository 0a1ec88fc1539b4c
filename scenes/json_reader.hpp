#pragma once
#include <initializer_list>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "scenes/named.hpp"
#include "texunit/linear.hpp"

/// Reading of checked values from JSON. Every error is an Error whose text names the file, the path
/// of the field and its value, and for a wrong name the nearest known one.
namespace twofold::scene_io {

/// The numbers that a field takes, both ends included unless said otherwise.
struct Range {
    double low;
    double high;
    bool low_excluded = false;
    bool high_excluded = false;
};

inline constexpr Range any_number{std::numeric_limits<double>::lowest(),
                                  std::numeric_limits<double>::max()};

/// "; did you mean 'NAME'?" with the name nearest to `wrong` in edit distance, the first of equals.
std::string did_you_mean(std::string_view wrong, const std::vector<std::string_view>& known);

/// A value and its place in the file.
class JsonValue {
  public:
    /// @param json must outlive the reader, as must `file`
    JsonValue(const nlohmann::json& json, std::string_view file, std::string path)
        : json_(&json), file_(file), path_(std::move(path)) {}

    /// @throws Error "FILE: PATH: WHAT"
    [[noreturn]] void fail(std::string_view what) const;

    bool is_null() const { return json_->is_null(); }
    bool is_object() const { return json_->is_object(); }
    bool is_list() const { return json_->is_array(); }
    bool is_number() const { return json_->is_number(); }
    bool is_text() const { return json_->is_string(); }

    /// The value as error texts show it.
    std::string shown() const;
    /// The value as JSON on one line.
    std::string dump() const { return json_->dump(); }

    double number(Range range) const;
    int integer(int low, int high) const;
    bool boolean() const;
    std::string text() const;
    Vec3 vec3(Range range) const;
    /// [r, g, b], or one number for all three.
    Rgb rgb(Range range) const;
    Vec4 vec4(Range range) const;
    /// 16 numbers, row by row as one writes a matrix.
    Mat4 mat4() const;
    /// A list of `least` to `most` numbers.
    std::vector<double> numbers(std::size_t least, std::size_t most, Range range) const;
    /// The elements of a list of `least` to `most`.
    std::vector<JsonValue> elements(std::size_t least, std::size_t most) const;
    /// The members of an object whose keys the scene's author chose.
    std::vector<std::pair<std::string, JsonValue>> named_members(std::size_t most) const;
    /// The member `key`, if there.
    std::optional<JsonValue> member(std::string_view key) const;
    /// All keys of an object.
    std::vector<std::string> keys() const;

    template <class E, std::size_t N>
    E enumerator(const std::array<Named<E>, N>& names) const {
        const std::string name = text();
        for (const Named<E>& entry : names)
            if (entry.name == name) return entry.value;
        fail_name("unknown value", name, names_of(names));
    }

    /// @throws Error "... 'NAME' is WHAT; did you mean ...?"
    [[noreturn]] void fail_name(std::string_view what, std::string_view name,
                                const std::vector<std::string_view>& known) const;

  private:
    const nlohmann::json* json_;
    std::string_view file_;
    std::string path_;
};

/// An object with a fixed set of fields. Fields are read with the value that they have when absent.
class JsonObject {
  public:
    /// @throws Error if `value` is not an object or has a field that is not in `known`
    JsonObject(JsonValue value, std::initializer_list<std::string_view> known);

    /// The field, if there.
    std::optional<JsonValue> find(std::string_view name) const { return value_.member(name); }
    /// The field, if there and not null: null switches off what can be off.
    std::optional<JsonValue> enabled(std::string_view name) const;
    /// The field, which must be there.
    JsonValue at(std::string_view name) const;
    /// The one of `names` that is there.
    std::string_view one_of(std::initializer_list<std::string_view> names) const;

    double number(std::string_view name, Range range, double absent) const;
    int integer(std::string_view name, int low, int high, int absent) const;
    bool boolean(std::string_view name, bool absent) const;
    std::string text(std::string_view name, const std::string& absent) const;
    Vec3 vec3(std::string_view name, Range range, Vec3 absent) const;
    Rgb rgb(std::string_view name, Range range, Rgb absent) const;
    Vec4 vec4(std::string_view name, Range range, Vec4 absent) const;

    template <class E, std::size_t N>
    E enumerator(std::string_view name, const std::array<Named<E>, N>& names, E absent) const {
        const auto field = find(name);
        return field ? field->enumerator(names) : absent;
    }

    const JsonValue& value() const { return value_; }

  private:
    JsonValue value_;
    std::vector<std::string_view> known_;
};

}  // namespace twofold::scene_io
