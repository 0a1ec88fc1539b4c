#pragma once
#include <cstdint>

#include "raster/pass.hpp"

/// Pieces of the frames that are compared.
namespace twofold::bench {

/// Of the pictures that show a table of values, in pixels.
inline constexpr int table_size = 64;

/// A colour that no table draws, so that undrawn pixels are told by it.
inline constexpr Rgba8 key_color{1, 2, 3, 4};

/// A picture of size x size without passes, cleared to key_color.
Frame empty_frame(int size);

/// The colour of four bytes.
Vec4 color_of(Rgba8 bytes);

/// A colour of whole bytes, so that rounding it to 8 bits changes nothing. Half of the components
/// are 0 or 255, where clamps and identities show.
Rgba8 random_bytes(std::uint64_t seed, std::uint64_t index);

/// width x height colours of random_bytes().
std::vector<Rgba8> random_texels(std::uint64_t seed, int width, int height);
Texture random_texture(std::uint64_t seed, int size, BaseFormat format = BaseFormat::rgba);

/// Red along s, green along t, blue and alpha along both, `rise` steps a texel: what an error of
/// the coordinate is worth stays small.
Texture smooth_texture(int size, int rise);

/// The whole picture as n x n squares of two triangles each, no vertex shared, s and t from 0 at
/// the lower left to 1 at the upper right.
/// @param shared_color  whether a square's four vertices have the same random colour
Mesh squares(int n, std::uint64_t seed, bool shared_color);

/// `squares` with one random depth of `levels` for each square.
Mesh squares_at_depths(int n, std::uint64_t seed, int levels);

/// A unit that reads texture `index` at the nearest texel.
TextureUnitState nearest_unit(std::size_t index, const TexEnv& env);

}  // namespace twofold::bench
