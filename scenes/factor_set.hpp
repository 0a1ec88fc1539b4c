#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "texunit/linear.hpp"
#include "texunit/texture.hpp"

namespace twofold {

/// A BRDF's factors as the University of Waterloo's Computer Graphics Lab published them: 8-bit
/// textures over one paraboloid (guard 7/8, normal in the centre) and a constant for each channel.
/// f ~ alpha p(l) q(h) p(v), and a highlight s(h) to add.
/// @source McCool, Ang & Ahmad 2001; the files of libsh's shmedia
struct FactorSet {
    /// What the set holds, by the number in its file.
    enum class Kind { product, product_and_highlight, highlight };

    std::string name;
    Kind kind = Kind::product;
    Rgb alpha{0.0};
    std::vector<Texture> textures;  ///< p, q; p, q, s; or s
};

/// The text of a set, without textures: name, kind 0 to 2, three constants, a number without known
/// meaning; a line each.
/// @throws Error(bad_file) naming `file` and the line
FactorSet parse_factor_set(std::string_view text, const std::string& file);

/// A set with the textures beside its text file NAME.txt: NAME_0.png and so on.
/// @throws Error(bad_file) naming the file that cannot be used
FactorSet read_factor_set(const std::filesystem::path& path);

}  // namespace twofold
