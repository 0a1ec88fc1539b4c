#pragma once
#include <functional>
#include <string>
#include <vector>

#include "bench/picture_comparison.hpp"
#include "raster/reference.hpp"

/// What is compared with OpenGL, as values; mesa_compare draws and judges them.
namespace twofold::bench {

/// The OpenGL driver at hand.
struct Driver {
    std::string name;       ///< "softpipe", "llvmpipe" or the first word of another's
    bool filters_in_float;  ///< not with weights of 8 bits
};

/// How far two pictures may be apart.
struct Bound {
    int steps = 1;             ///< of any compared pixel
    std::size_t coverage = 0;  ///< pixels drawn in one of the two only
};

/// Frames that are drawn by both, one row of the report for each preset.
struct Check {
    std::string name;
    Bound bound;
    int filter_slack = 0;  ///< further steps for a driver that filters with weights of 8 bits
    std::function<std::vector<Frame>()> frames;
    /// Pixels of a frame whose colour may differ by anything; none: all are compared.
    std::function<std::vector<bool>(const Frame&)> left_out = {};
    std::vector<Preset> presets{Preset::gl13, Preset::float32};
    std::string driver = {};  ///< the only one that can answer; empty: every driver can
};

/// A row of the report.
struct Row {
    std::string name;
    Preset preset;
    PictureComparison result;
    Bound bound;
    std::string reason;  ///< why the driver may exceed the check's own bound; usually empty

    bool passed() const { return result.coverage <= bound.coverage && result.worst <= bound.steps; }
};

std::vector<Check> four_pass_checks();
std::vector<Check> environment_checks();
std::vector<Check> lookup_checks();
std::vector<Check> fragment_checks();
std::vector<Check> primitive_checks();

}  // namespace twofold::bench
