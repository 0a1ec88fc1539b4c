#pragma once
#include "bench/draw/entrants.hpp"

/// Figures that are not ratios: how cost grows, the first picture, memory.
namespace twofold::bench {

/// One point of a series.
struct Step {
    double units = 0;    ///< pixels or triangles
    double seconds = 0;  ///< of a frame
};

/// Cost against the amount of work, which should be a straight line.
struct Series {
    std::string work;
    std::string unit;  ///< "pixel" or "triangle"
    std::vector<Step> steps;

    /// Seconds for each unit more than the step before had; i from 1.
    double slope(std::size_t i) const;
};

std::vector<Series> measure_growth(const Settings& settings);

/// A figure that should be small.
struct Figure {
    std::string name, unit;
    double value = 0;
    Target most{};  ///< floor: must not be more; aim: should not be more
    std::string note{};
};

/// From process start to its end, with a picture of 64 x 64 drawn. With peers also llvmpipe's
/// processor time for its first picture.
std::vector<Figure> measure_first_picture(const Settings& settings);

/// Of a process that draws 200k triangles at 2048 x 2048.
std::vector<Figure> measure_memory(const Settings& settings);

}  // namespace twofold::bench
