#include "study/sweep/timing.hpp"

#include <time.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace twofold {
namespace {

/// What one measurement takes at least, so that the clock's own cost does not show.
constexpr double least_measurement = 0.008;

double processor_now() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// A frame and what was measured of it.
struct Measured {
    const std::function<void()>& draw;
    Seconds first;    ///< of the first time, which also warms up
    int repeats = 1;  ///< draws a measurement
    std::vector<double> processor{}, wall{};

    explicit Measured(const std::function<void()>& frame) : draw(frame), first(seconds_of(frame)) {
        const double wanted = std::ceil(least_measurement / std::max(first.processor, 1e-5));
        repeats = std::max(1, static_cast<int>(wanted));
    }
    void keep(const Seconds& s, int frames) {
        processor.push_back(s.processor / frames);
        wall.push_back(s.wall / frames);
    }
    void measure() {
        const Seconds s = seconds_of([&] {
            for (int i = 0; i < repeats; ++i) draw();
        });
        keep(s, repeats);
    }
    int rounds() const { return static_cast<int>(wall.size()); }
};

FrameTimes summary_of(const Measured& own, const Measured& common) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < own.processor.size(); ++i)
        ratios.push_back(own.processor[i] / common.processor[i]);
    return {own.rounds(), spread_of(own.processor), spread_of(own.wall),
            spread_of(common.processor), spread_of(ratios).median};
}

}  // namespace

Seconds seconds_of(const std::function<void()>& work) {
    const auto wall = std::chrono::steady_clock::now();
    const double processor = processor_now();
    work();
    const double taken = processor_now() - processor;
    return {taken, std::chrono::duration<double>(std::chrono::steady_clock::now() - wall).count()};
}

Spread spread_of(std::vector<double> values) {
    std::stable_sort(values.begin(), values.end());
    const auto at = [&](std::size_t quarter) { return values[quarter * (values.size() - 1) / 4]; };
    return {at(2), at(1), at(3)};
}

FrameTimes time_frames(const std::function<void()>& draw, const std::function<void()>& anchor,
                       const TimingRule& rule) {
    Measured own(draw), common(anchor);
    if (own.first.wall > rule.long_frame) {
        own.keep(own.first, 1);
        common.measure();
        return summary_of(own, common);
    }
    double spent = 0.0;
    while (own.rounds() < rule.most_rounds &&
           (spent < rule.seconds || own.rounds() < rule.least_rounds)) {
        const bool own_first = own.rounds() % 2 == 0;
        (own_first ? own : common).measure();
        (own_first ? common : own).measure();
        spent += own.wall.back() * own.repeats;
    }
    return summary_of(own, common);
}

}  // namespace twofold
