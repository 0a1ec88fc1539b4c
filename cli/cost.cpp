#include "cli/cost.hpp"

#include <algorithm>
#include <ctime>

#include "raster/effects.hpp"
#include "raster/fast.hpp"

namespace twofold {
namespace {

/// Processor time of one frame: of as many as take 5 ms.
double seconds_of(const FastFrame& frame) {
    constexpr std::clock_t enough = CLOCKS_PER_SEC / 200;
    const std::clock_t start = std::clock();
    std::clock_t taken = 0;
    int frames = 0;
    do {
        frame.draw();
        ++frames;
        taken = std::clock() - start;
    } while (taken < enough);
    return static_cast<double>(taken) / CLOCKS_PER_SEC / frames;
}

/// @param values an odd number of them
double median(std::vector<double> values) {
    std::stable_sort(values.begin(), values.end());
    return values[values.size() / 2];
}

}  // namespace

FrameCost measure_cost(const Frame& frame, Preset preset, const CustomSettings& custom,
                       int rounds) {
    const std::vector<Effect> effects = effects_of(frame);
    const FastFrame whole = prepare_fast(frame, preset, custom);
    whole.draw();
    std::vector<double> seconds;
    FrameCost cost{0.0, {}};
    for (const Effect& effect : effects) {
        const FastFrame without = prepare_fast(effect.without, preset, custom);
        without.draw();
        std::vector<double> percents;
        for (int round = 0; round < rounds; ++round) {
            seconds.push_back(seconds_of(whole));
            percents.push_back(100.0 * (1.0 - seconds_of(without) / seconds.back()));
        }
        const auto [least, most] = std::minmax_element(percents.begin(), percents.end());
        cost.effects.push_back({effect.name, median(percents), *least, *most});
    }
    if (seconds.empty()) seconds.push_back(seconds_of(whole));
    cost.seconds = median(seconds);
    return cost;
}

}  // namespace twofold
