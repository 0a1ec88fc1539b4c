#pragma once
#include <cstdint>
#include <span>
#include <string_view>

/// What hostile files are fed to: for each reader a function that takes a file's bytes. It returns
/// whether they were read, and throws what no input may lead to: anything but an Error, an error
/// without the file's name or not fit for a terminal, a result that does not keep its promises.
namespace twofold::hostile {

using Input = std::span<const unsigned char>;

bool scene(Input bytes);       ///< parse_scene, and back through scene_to_json
bool override(Input bytes);    ///< parse_scene with the input as a change path=value
bool study(Input bytes);       ///< parse_study
bool factor_set(Input bytes);  ///< parse_factor_set
bool obj(Input bytes);         ///< parse_obj
bool ply(Input bytes);         ///< parse_ply
bool merl(Input bytes);        ///< parse_merl
bool cornell(Input bytes);     ///< parse_cornell, and values between the samples
bool rgl(Input bytes);         ///< parse_rgl, and values
bool image(Input bytes);       ///< decode_float_image and decode_png

}  // namespace twofold::hostile
