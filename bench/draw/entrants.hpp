#pragma once
#include <optional>

#include "bench/draw/inputs.hpp"
#include "bench/draw/works.hpp"
#include "bench/picture_comparison.hpp"

/// Makes the contestants of a work: inputs, frames, pictures that were looked at before anything is
/// timed.
namespace twofold::bench {

namespace fs = std::filesystem;

struct Settings {
    std::optional<fs::path> peers;  ///< folder of their programs
    fs::path scratch;               ///< an empty folder for dumps
    fs::path self;                  ///< this program, which is its own child
    double seconds = 0.3;           ///< that a contestant draws in a round
    int rounds = 5;
    bool baseline = false;  ///< plain x86-64 too
};

/// Where inputs come from: a dump, or without one made_inputs.
struct Source {
    std::string drawing;
    int squares = 0;
    int size = 0;
    fs::path dump{};
};

Inputs load(const Source& source);

/// The arguments that tell a child to draw `source`; main.cpp reads them.
std::vector<std::string> child_command(const Settings& settings, const Source& source,
                                       Preset preset, double seconds);

/// How our picture differs from the peer's, where either is drawn.
struct PictureCheck {
    std::string work, ours, peer;
    PictureComparison difference;

    /// Whether it is the same picture up to rounding: no more than one pixel in 1000 is off by more
    /// than 4 steps (the seams between the four passes), one in 5000 drawn by one side only.
    bool passed() const;
};

struct PreparedWork {
    Contest contest;
    std::vector<PictureCheck> pictures;  ///< none without peers
};

/// Inputs of `drawing`, dumped by the peer where there is one; its picture too.
struct SourceAndPicture {
    Source source;
    std::optional<ByteImage> picture;
};

SourceAndPicture make_source(const Settings& settings, const std::string& drawing, int squares,
                             int size);

PreparedWork prepare(const Settings& settings, const Work& work);

/// A contestant that draws with the fast pipeline, and keeps the frame alive.
Contestant fast_contestant(const std::string& name, std::shared_ptr<const Frame> frame,
                           Preset preset, FastOptions options, double seconds);

/// Pixels that are not background.
double covered_pixels(const std::vector<Rgba8>& pixels);

}  // namespace twofold::bench
