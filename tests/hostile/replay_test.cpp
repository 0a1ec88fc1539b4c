#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <string>

#include "tests/fuzz/readers.hpp"
#include "texunit/atomic_file.hpp"

using namespace twofold;
using Bytes = std::vector<unsigned char>;

namespace {

constexpr std::size_t max_bytes = std::size_t{1} << 20;
/// Longer files are not cut at every length, to keep the test short.
constexpr std::size_t most_cuts = 400;

struct Target {
    const char* folder;
    bool (*read)(hostile::Input);
};

const std::vector<Target> targets{
    {"scene", hostile::scene}, {"override", hostile::override}, {"study", hostile::study},
    {"obj", hostile::obj},     {"ply", hostile::ply},           {"factor_set", hostile::factor_set},
    {"merl", hostile::merl},   {"cornell", hostile::cornell},   {"rgl", hostile::rgl},
    {"hdr", hostile::image},   {"exr", hostile::image},         {"pnm", hostile::image},
    {"png", hostile::image}};

std::vector<std::filesystem::path> corpus_of(const Target& target) {
    const auto folder = std::filesystem::path(TWOFOLD_SOURCE_DIR) / "tests/fuzz/corpus";
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder / target.folder))
        files.push_back(entry.path());
    return files;
}

}  // namespace

TEST_CASE("every file of the fuzz corpus is read or refused as promised", "[hostile]") {
    for (const Target& target : targets) {
        int read = 0, refused = 0;
        for (const auto& file : corpus_of(target)) {
            CAPTURE(file);
            bool done = false;
            CHECK_NOTHROW(done = target.read(read_file(file, max_bytes)));
            ++(done ? read : refused);
        }
        CAPTURE(target.folder, refused);
        // A MERL file that is read has 35 MB.
        CHECK(read + (target.read == hostile::merl ? 1 : 0) > 0);
    }
}

TEST_CASE("a file of the corpus cut at any length is read or refused as promised",
          "[hostile][long]") {
    for (const Target& target : targets)
        for (const auto& file : corpus_of(target)) {
            const Bytes whole = read_file(file, max_bytes);
            for (std::size_t length = 0; length < std::min(whole.size(), most_cuts); ++length) {
                CAPTURE(file, length);
                // A copy of just this length, so that a checker of memory sees its end.
                const Bytes part(whole.data(), whole.data() + length);
                REQUIRE_NOTHROW(target.read(part));
            }
        }
}

TEST_CASE("every reader keeps its promises with every other reader's files", "[hostile]") {
    for (const Target& target : targets)
        for (const Target& other : targets)
            for (const auto& file : corpus_of(other)) {
                CAPTURE(target.folder, file);
                REQUIRE_NOTHROW(target.read(read_file(file, max_bytes)));
            }
}
