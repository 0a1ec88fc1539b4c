// A hash of everything that texunit, raster and factor compute: platform_hashes [THREADS]
//
// One line a hash: name, value. tests/platforms/hashes.txt pins the output; it changes only with a
// preset's or a method's version.
#include <cstdlib>
#include <exception>

#include "tests/platforms/named_hash.hpp"
#include "texunit/self_check.hpp"

int main(int argc, char** argv) try {
    using namespace twofold::platforms;
    const int threads = argc > 1 ? std::atoi(argv[1]) : 1;
    const std::string defects = twofold::floating_point_defects();
    if (!defects.empty()) {
        fmt::print(stderr, "platform_hashes: {}\n", defects);
        return 6;
    }
    Hashes all;
    for (const auto& of : {number_hashes, function_hashes, vertex_hashes, direction_hashes,
                           channel_hashes, environment_hashes, combiner_hashes, texture_hashes,
                           lookup_hashes, fragment_hashes, triangle_hashes})
        append(all, of());
    for (const auto& of : {frame_hashes, light_hashes, system_hashes, map_hashes})
        append(all, of(threads));
    for (const NamedHash& hash : all) fmt::print("{} {:016x}\n", hash.name, hash.value);
    return 0;
} catch (const std::exception& e) {
    fmt::print(stderr, "platform_hashes: {}\n", e.what());
    return 2;
}
