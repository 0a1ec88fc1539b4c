#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// Text for pages that need nothing but themselves.
namespace twofold {

/// `text` for an element or an attribute in either quotes.
std::string html_text(const std::string& text);

/// JSON for a script element. Inside one, only '<' can begin something that is not data
/// ("</script", "<!--"). Bytes that are not UTF-8, as file names may hold, become U+FFFD.
std::string script_data(const nlohmann::ordered_json& json);

/// A PNG file as a data URL; null if there is none.
nlohmann::ordered_json image_source(const std::vector<unsigned char>& png);

using PageParts = std::vector<std::pair<std::string_view, std::string>>;

/// Fills the page's {{markers}} in one go from front to back, so that a part which happens to
/// contain a marker stays as it is.
std::string filled(std::string_view page, const PageParts& parts);

}  // namespace twofold
