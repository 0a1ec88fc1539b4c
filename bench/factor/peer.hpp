#pragma once
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace twofold::bench {

/// Writes values as they lie in memory.
template <class T>
void dump(const std::filesystem::path& file, std::span<const T> values);

/// Binary64 values of a file that the peer wrote.
std::vector<double> read_doubles(const std::filesystem::path& file);

/// Where NumPy and SciPy are, and the folder of their inputs.
struct Peer {
    std::string python;
    std::filesystem::path folder;
};

/// Seconds that the peer needed for a work, or nothing where there is no NumPy and SciPy.
/// @throws Error(failure) if the peer fails otherwise
std::optional<double> peer_seconds(const Peer& peer, const std::string& work);

}  // namespace twofold::bench
