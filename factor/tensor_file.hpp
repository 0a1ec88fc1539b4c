#pragma once
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace twofold {

/// One array of binary32 values of a tensor file, in C order (last index fastest).
struct Tensor {
    std::vector<std::size_t> shape;
    std::vector<float> values;
};

/// The named fields of a tensor file, version 1.0, little-endian.
/// @param wanted fields to load; each must be there, of type f32, all finite; others are skipped
/// @throws Error(bad_file) naming the field; nothing is allocated for a field that does not lie
/// within the file
/// @source the files of rgl.epfl.ch and their loader's header tensor.h
std::map<std::string, Tensor> parse_tensors(std::span<const unsigned char> bytes,
                                            std::span<const std::string_view> wanted,
                                            std::string_view name);

}  // namespace twofold
