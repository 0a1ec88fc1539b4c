#include "bench/factor/peer.hpp"

#include <fmt/format.h>
#include <stdio.h>
#include <sys/wait.h>

#include <cstdint>
#include <fstream>

#include "texunit/error.hpp"

namespace twofold::bench {

template <class T>
void dump(const std::filesystem::path& file, std::span<const T> values) {
    std::ofstream out(file, std::ios::binary);
    out.write(reinterpret_cast<const char*>(values.data()),
              static_cast<std::streamsize>(values.size_bytes()));
    if (!out) throw Error(ExitCode::bad_file, file.string() + ": cannot be written");
}

template void dump(const std::filesystem::path&, std::span<const double>);
template void dump(const std::filesystem::path&, std::span<const std::uint32_t>);
template void dump(const std::filesystem::path&, std::span<const std::uint64_t>);

std::vector<double> read_doubles(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::vector<double> values(std::filesystem::file_size(file) / sizeof(double));
    in.read(reinterpret_cast<char*>(values.data()),
            static_cast<std::streamsize>(values.size() * sizeof(double)));
    return values;
}

std::optional<double> peer_seconds(const Peer& peer, const std::string& work) {
    const std::string command =
        fmt::format("{} {} {} {}", peer.python, TWOFOLD_FACTOR_PEERS, peer.folder.string(), work);
    FILE* pipe = ::popen(command.c_str(), "r");
    if (pipe == nullptr) return std::nullopt;
    double seconds = 0.0;
    const int read = ::fscanf(pipe, "%lf", &seconds);
    const int status = ::pclose(pipe);
    if (WIFEXITED(status) && WEXITSTATUS(status) == 77) return std::nullopt;
    if (status != 0 || read != 1)
        throw Error(ExitCode::failure, "bench_factor: the peer failed at " + work);
    return seconds;
}

}  // namespace twofold::bench
