#pragma once
#include <filesystem>
#include <string>
#include <string_view>

#include "bench/draw/timing.hpp"
#include "texunit/texture.hpp"

/// The programs `peer_gl` (Mesa's drivers) and `limit` (the inner loop by hand), which are no part
/// of this tree. What they print is described beside them.
namespace twofold::bench {

/// One drawing of peer_gl.
struct PeerDrawing {
    std::string driver;   ///< llvmpipe or softpipe
    std::string drawing;  ///< its --variant
    int squares = 0;      ///< n for the sphere of 12 n^2 triangles; 0: the quad
    int size = 0;         ///< of the picture, in pixels along an edge
    int threads = 1;      ///< 1: in the calling thread
};

/// What peer_gl says of a run.
struct PeerTimes {
    FrameTimes frame;
    double first_cpu = 0.0;  ///< seconds: context, uploads, code generation and the first frame
};

/// @throws Error(bad_file) if the program fails, prints something else or draws with another driver
PeerTimes time_peer(const std::filesystem::path& programs, const PeerDrawing& drawing,
                    double seconds);

/// Writes peer_gl's inputs to `folder` and gives its picture, filtered in float, rows top down.
ByteImage dump_inputs(const std::filesystem::path& programs, const PeerDrawing& drawing,
                      const std::filesystem::path& folder);

/// Seconds per pixel of limit's best kernel for two textures in perspective.
/// @throws Error(bad_file) if the program fails, as it does without AVX-512
double time_limit(const std::filesystem::path& programs, double seconds);

/// The same from what the program printed: the least ns/px of a checked kernel for
/// perspective coordinates at 1024 x 1024.
double best_kernel(std::string_view printed);

}  // namespace twofold::bench
