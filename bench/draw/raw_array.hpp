#pragma once
#include <fmt/format.h>

#include <bit>
#include <cstring>
#include <filesystem>
#include <vector>

#include "texunit/atomic_file.hpp"
#include "texunit/error.hpp"

namespace twofold::bench {

static_assert(std::endian::native == std::endian::little, "arrays are read as they lie");

/// The elements of a raw little-endian file.
/// @throws Error(bad_file) naming the file if it does not hold exactly `count` of them
template <class T>
std::vector<T> read_array(const std::filesystem::path& file, std::size_t count) {
    const std::size_t wanted = count * sizeof(T);
    const auto bytes = read_file(file, wanted);
    if (bytes.size() != wanted)
        throw Error(ExitCode::bad_file,
                    fmt::format("{}: {} bytes, not {}", file.string(), bytes.size(), wanted));
    std::vector<T> values(count);
    std::memcpy(values.data(), bytes.data(), wanted);
    return values;
}

}  // namespace twofold::bench
