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

/// Least value, median and quartiles of repeated measurements.
struct Spread {
    double least = 0.0, median = 0.0, low = 0.0, high = 0.0;
};

/// @param values at least one
Spread spread_of(std::vector<double> values);

/// How often frames are drawn to be timed.
struct TimingRule {
    double seconds = 0.4;  ///< rounds go on until the frame alone has taken so long
    int least_rounds = 15;
    int most_rounds = 25;
    double long_frame = 1.0;  ///< a frame that takes longer, seconds, has three rounds
};

/// A frame that is timed in turn with others.
class TimedFrame {
  public:
    /// Draws it once, which warms up; of a long frame this is the first round.
    TimedFrame(std::function<void()> draw, const TimingRule& rule);

    /// One round more: a frame shorter than some milliseconds is drawn several times.
    void measure();

    /// Whether the rule asks for another round.
    bool wants_more() const;

    int rounds() const { return static_cast<int>(wall_.size()); }
    Spread processor() const { return spread_of(processor_); }  ///< seconds a frame
    Spread wall() const { return spread_of(wall_); }            ///< seconds a frame

  private:
    void keep(const Seconds& s, int frames);

    std::function<void()> draw_;
    TimingRule rule_;
    bool long_ = false;
    int repeats_ = 1;     ///< draws a measurement
    double spent_ = 0.0;  ///< wall time of all measurements
    std::vector<double> processor_, wall_;
};

/// Rounds of the common frame and then each frame that wants more, until none does. What slows the
/// machine for a while slows a round of all, and not all rounds of one.
void time_in_turn(const std::vector<TimedFrame*>& frames, TimedFrame& common);

}  // namespace twofold
