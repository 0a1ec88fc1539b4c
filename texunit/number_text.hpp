#pragma once
#include <optional>
#include <string_view>

/// Numbers and words of text files, read the same whatever the process's locale is.
namespace twofold {

/// The decimal number that `text` is as a whole, correctly rounded: an optional sign, digits with
/// at most one point, an optional exponent. "nan", "inf", hexadecimal, a comma and anything after
/// the number give nothing; 1e999 gives infinity, which the caller's range check meets.
std::optional<double> parse_real(std::string_view text);

/// The whole number that `text` is, with an optional sign; nothing if it does not fit.
std::optional<long long> parse_integer(std::string_view text);

/// The next word of `text` (ends at a blank, tab or line end); `text` is left behind it. Empty at
/// the end.
std::string_view take_word(std::string_view& text);

/// The next line of `text` without its end (LF, CR LF or CR); `text` is left behind it.
std::string_view take_line(std::string_view& text);

}  // namespace twofold
