#include "study/page_text.hpp"

namespace twofold {
namespace {

using Json = nlohmann::ordered_json;

std::string base64(const std::vector<unsigned char>& bytes) {
    constexpr std::string_view digits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t present = std::min<std::size_t>(3, bytes.size() - i);
        unsigned group = 0;
        for (std::size_t k = 0; k < 3; ++k) group = group << 8 | (k < present ? bytes[i + k] : 0u);
        for (std::size_t k = 0; k < 4; ++k) {
            text += k <= present ? digits[group >> (18 - 6 * k) & 63u] : '=';
        }
    }
    return text;
}

std::string replace_all(std::string text, char what, std::string_view by) {
    for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size()) {
        text.replace(at, 1, by);
    }
    return text;
}

}  // namespace

Json image_source(const std::vector<unsigned char>& png) {
    return png.empty() ? Json() : Json("data:image/png;base64," + base64(png));
}

std::string script_data(const Json& json) {
    return replace_all(json.dump(-1, ' ', false, Json::error_handler_t::replace), '<', "\\u003c");
}

std::string html_text(const std::string& text) {
    return replace_all(
        replace_all(replace_all(replace_all(text, '&', "&amp;"), '<', "&lt;"), '"', "&quot;"), '\'',
        "&#39;");
}

std::string filled(std::string_view page, const PageParts& parts) {
    std::string result;
    while (true) {
        const std::size_t open = page.find("{{"), close = page.find("}}", open);
        if (open == std::string_view::npos || close == std::string_view::npos) break;
        const std::string_view name = page.substr(open + 2, close - open - 2);
        result += page.substr(0, open);
        for (const auto& [key, text] : parts) result += key == name ? text : std::string();
        page.remove_prefix(close + 2);
    }
    return result += page;
}

}  // namespace twofold
