#pragma once
#include <functional>
#include <vector>

namespace twofold {

/// Processor and wall time of something, seconds.
struct Seconds {
    double processor = 0.0;  ///< of all threads of the process
    double wall = 0.0;
};

/// What `work` takes, once.
Seconds seconds_of(const std::function<void()>& work);

/// Median and quartiles of repeated measurements.
struct Spread {
    double median = 0.0, low = 0.0, high = 0.0;
};

/// @param values at least one
Spread spread_of(std::vector<double> values);

/// How often frames are drawn to be timed.
struct TimingRule {
    double seconds = 0.4;  ///< rounds go on until the frames alone have taken so long
    int least_rounds = 5;
    int most_rounds = 25;
    double long_frame = 1.0;  ///< a frame that takes longer, seconds, is drawn once
};

/// Times of one frame, and of the study's common frame that was drawn in turn with it.
struct FrameTimes {
    int rounds = 0;
    Spread processor, wall;   ///< seconds a frame
    Spread anchor_processor;  ///< of the common frame
    double ratio = 0.0;       ///< median over the rounds of processor time over the common frame's:
                              ///< what slows both, cancels
};

/// Draws both in turn, the first of a round being the second of the next. Frames shorter than some
/// milliseconds are drawn several times a measurement.
FrameTimes time_frames(const std::function<void()>& draw, const std::function<void()>& anchor,
                       const TimingRule& rule);

}  // namespace twofold
