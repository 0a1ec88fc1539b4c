#include "scenes/factor_set.hpp"

#include <fmt/format.h>

#include "scenes/assets.hpp"
#include "scenes/texture_images.hpp"
#include "texunit/atomic_file.hpp"
#include "texunit/error.hpp"
#include "texunit/image_file.hpp"
#include "texunit/number_text.hpp"

namespace twofold {
namespace {

constexpr std::size_t max_text_bytes = 4096;

[[noreturn]] void fail(const std::string& file, int line, std::string_view what) {
    throw Error(ExitCode::bad_file, fmt::format("{}: line {}: {}", file, line, what));
}

Rgb read_alpha(std::string_view line, const std::string& file) {
    Rgb alpha;
    for (int c = 0; c < 3; ++c) {
        const auto number = parse_real(take_word(line));
        if (!number || !(*number >= 0.0 && *number <= 1e6))
            fail(file, 3, "three constants of 0 to 1e6 are wanted");
        alpha[c] = *number;
    }
    return alpha;
}

std::size_t texture_count(FactorSet::Kind kind) {
    if (kind == FactorSet::Kind::highlight) return 1;
    return kind == FactorSet::Kind::product ? 2 : 3;
}

}  // namespace

FactorSet parse_factor_set(std::string_view text, const std::string& file) {
    FactorSet set;
    set.name = printable(take_line(text));
    std::string_view kind_line = take_line(text);
    const auto kind = parse_integer(take_word(kind_line));
    if (!kind || *kind < 0 || *kind > 2) fail(file, 2, "the kind is none of 0, 1 and 2");
    set.kind = static_cast<FactorSet::Kind>(*kind);
    set.alpha = read_alpha(take_line(text), file);
    return set;
}

FactorSet read_factor_set(const std::filesystem::path& path) {
    FactorSet set = parse_factor_set(read_text_file(path, max_text_bytes), path.string());
    for (std::size_t i = 0; i < texture_count(set.kind); ++i) {
        const std::string name = fmt::format("{}_{}.png", path.stem().string(), i);
        set.textures.push_back(texture_of(read_png(path.parent_path() / name)));
    }
    return set;
}

}  // namespace twofold
