#include "bench/draw/timing.hpp"

#include <time.h>

#include <algorithm>

namespace twofold::bench {
namespace {

double seconds_of(clockid_t clock) {
    timespec t{};
    clock_gettime(clock, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

double cpu_seconds() { return seconds_of(CLOCK_PROCESS_CPUTIME_ID); }

}  // namespace

double wall_seconds() { return seconds_of(CLOCK_MONOTONIC); }

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const std::size_t half = values.size() / 2;
    return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

FrameTimes time_frames(const std::function<void()>& draw, double seconds, int frames) {
    std::vector<double> cpu, wall;
    const double start = wall_seconds();
    while (static_cast<int>(cpu.size()) < frames || wall_seconds() - start < seconds) {
        const double wall_before = wall_seconds(), cpu_before = cpu_seconds();
        draw();
        cpu.push_back(cpu_seconds() - cpu_before);
        wall.push_back(wall_seconds() - wall_before);
    }
    return {*std::min_element(cpu.begin(), cpu.end()), median(cpu),
            *std::min_element(wall.begin(), wall.end())};
}

}  // namespace twofold::bench
