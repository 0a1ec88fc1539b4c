#pragma once
#include <filesystem>
#include <span>
#include <string>

#include "factor/brdf.hpp"

/// Measured materials from their files.
namespace twofold {

/// The material with its model if it is measured, else as it is.
/// @param directory where the file's path starts
/// @throws Error naming the file that cannot be used
Brdf loaded(const Brdf& brdf, const std::filesystem::path& directory, int threads);

/// SHA-256 in lower-case hexadecimal. @source FIPS 180-4, by OpenSSL
std::string sha256_of(std::span<const unsigned char> bytes);

/// The name that a list of known files has for a sum and size, or nothing. Lines are `sha256 bytes
/// name`; others are passed over.
std::string known_name(std::string_view list, std::string_view sha256, std::size_t bytes);

/// A list of this name beside a MERL file is what the file is held against.
inline constexpr std::string_view known_list = "merl_sha256_size.txt";

}  // namespace twofold
