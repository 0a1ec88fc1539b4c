#pragma once
#include <functional>
#include <vector>

namespace twofold::bench {

/// Seconds of one frame. Least processor time is the steadiest figure on a machine that other work
/// shares; wall time shows what threads gain.
struct FrameTimes {
    double cpu = 0.0;         ///< least, all threads
    double cpu_median = 0.0;  ///< 0 where it is not known
    double wall = 0.0;        ///< least
};

/// Draws for about `seconds` of wall time, but at least `frames` frames.
FrameTimes time_frames(const std::function<void()>& draw, double seconds, int frames);

/// Seconds of a steady clock.
double wall_seconds();

/// The middle value, of an even number the mean of the two. @param values not empty
double median(std::vector<double> values);

}  // namespace twofold::bench
