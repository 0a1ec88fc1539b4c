#pragma once
#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <vector>

/// The folder of measured files that TWOFOLD_DATA names. They are not part of the program: a test
/// of them says loudly that it is skipped where there is none.
inline std::optional<std::filesystem::path> data_folder() {
    const char* folder = std::getenv("TWOFOLD_DATA");
    if (folder != nullptr && *folder != '\0') return folder;
    WARN("skipped: TWOFOLD_DATA names no folder of measured files");
    return std::nullopt;
}

inline std::vector<unsigned char> bytes_of(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    REQUIRE(file);
    return {std::istreambuf_iterator<char>(file), {}};
}
