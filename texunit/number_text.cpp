#include "texunit/number_text.hpp"

#include <locale.h>
#include <stdlib.h>

#include <algorithm>
#include <charconv>
#include <string>

namespace twofold {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::string_view without_sign(std::string_view text) {
    if (text.starts_with('+') || text.starts_with('-')) text.remove_prefix(1);
    return text;
}

std::size_t count_digits(std::string_view text) {
    return static_cast<std::size_t>(std::find_if_not(text.begin(), text.end(), is_digit) -
                                    text.begin());
}

/// What remains of `text` after a mantissa such as 1, 1., .5 or 1.5; nothing if there is no digit.
std::optional<std::string_view> after_mantissa(std::string_view text) {
    const std::size_t whole = count_digits(text);
    text.remove_prefix(whole);
    if (!text.starts_with('.')) return whole > 0 ? std::optional(text) : std::nullopt;
    text.remove_prefix(1);
    const std::size_t fraction = count_digits(text);
    return whole + fraction > 0 ? std::optional(text.substr(fraction)) : std::nullopt;
}

bool is_exponent(std::string_view text) {
    if (!text.starts_with('e') && !text.starts_with('E')) return false;
    const std::string_view digits = without_sign(text.substr(1));
    return !digits.empty() && count_digits(digits) == digits.size();
}

bool is_decimal_number(std::string_view text) {
    const auto rest = after_mantissa(without_sign(text));
    return rest && (rest->empty() || is_exponent(*rest));
}

/// strtod() follows the process's locale, which a program that embeds this library may have
/// changed.
double to_double(const std::string& digits) {
    static const locale_t c_locale = newlocale(LC_ALL_MASK, "C", locale_t{});
    return strtod_l(digits.c_str(), nullptr, c_locale);
}

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

}  // namespace

std::optional<double> parse_real(std::string_view text) {
    if (!is_decimal_number(text)) return std::nullopt;
    return to_double(std::string(text));
}

std::optional<long long> parse_integer(std::string_view text) {
    if (text.starts_with('+')) {
        text.remove_prefix(1);
        if (text.starts_with('-')) return std::nullopt;
    }
    long long value = 0;
    const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool whole = status == std::errc() && end == text.data() + text.size();
    return whole ? std::optional(value) : std::nullopt;
}

std::string_view take_word(std::string_view& text) {
    const auto* start = std::find_if_not(text.begin(), text.end(), is_blank);
    const auto* end = std::find_if(start, text.end(), is_blank);
    const auto length = static_cast<std::size_t>(end - start);
    const std::string_view word =
        text.substr(static_cast<std::size_t>(start - text.begin()), length);
    text.remove_prefix(static_cast<std::size_t>(end - text.begin()));
    return word;
}

std::string_view take_line(std::string_view& text) {
    const std::size_t length = std::min(text.find_first_of("\r\n"), text.size());
    const std::string_view line = text.substr(0, length);
    text.remove_prefix(length);
    if (text.starts_with("\r\n")) text.remove_prefix(1);
    if (!text.empty()) text.remove_prefix(1);
    return line;
}

}  // namespace twofold
