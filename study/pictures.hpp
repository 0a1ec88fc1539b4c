#pragma once
#include <string>

#include "factor/factorize.hpp"
#include "raster/framebuffer.hpp"
#include "texunit/texture.hpp"

/// Framebuffers and textures as pictures for files, and their hashes.
namespace twofold {

/// FNV-1a of width, height, 4 and the bytes r g b a, rows from the top, as 16 hexadecimal digits.
std::string hash_of(const Framebuffer& picture);

/// FNV-1a of the 8-bit images of a factor's two faces.
std::string hash_of(const FactorMap& map);

/// FNV-1a of a texture as byte_image() shows it.
std::string hash_of(const Texture& texture);

/// FNV-1a of a term's t1: of its map, or of its values at the vertices.
std::string hash_of_t1(const ProductTerm& term);

ByteImage byte_image(const Framebuffer& picture);
FloatImage float_image(const Framebuffer& picture);

/// A texture image, rows bottom up, as a picture, rows top down; real texels are shown rounded to
/// bytes.
ByteImage byte_image(const Texture& texture);
FloatImage float_image(const Texture& texture);

}  // namespace twofold
