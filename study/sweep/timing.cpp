#include "study/sweep/timing.hpp"

#include <time.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace twofold {
namespace {

/// What one measurement takes at least, so that the clock's own cost does not show.
constexpr double least_measurement = 0.008;

constexpr int rounds_of_long_frame = 3;

double processor_now() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
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
    return {at(0), at(2), at(1), at(3)};
}

TimedFrame::TimedFrame(std::function<void()> draw, const TimingRule& rule)
    : draw_(std::move(draw)), rule_(rule) {
    const Seconds first = seconds_of(draw_);
    long_ = first.wall > rule.long_frame;
    if (long_) keep(first, 1);
    const double wanted = std::ceil(least_measurement / std::max(first.processor, 1e-5));
    repeats_ = std::max(1, static_cast<int>(wanted));
}

void TimedFrame::keep(const Seconds& s, int frames) {
    processor_.push_back(s.processor / frames);
    wall_.push_back(s.wall / frames);
    spent_ += s.wall;
}

void TimedFrame::measure() {
    const Seconds s = seconds_of([&] {
        for (int i = 0; i < repeats_; ++i) draw_();
    });
    keep(s, repeats_);
}

bool TimedFrame::wants_more() const {
    if (long_) return rounds() < std::min(rounds_of_long_frame, rule_.most_rounds);
    return rounds() < rule_.most_rounds &&
           (spent_ < rule_.seconds || rounds() < rule_.least_rounds);
}

void time_in_turn(const std::vector<TimedFrame*>& frames, TimedFrame& common) {
    std::vector<TimedFrame*> wanting = frames;
    const auto done = [](const TimedFrame* frame) { return !frame->wants_more(); };
    while (true) {
        wanting.erase(std::remove_if(wanting.begin(), wanting.end(), done), wanting.end());
        if (wanting.empty()) return;
        common.measure();
        for (TimedFrame* frame : wanting) frame->measure();
    }
}

}  // namespace twofold
