#include "scenes/material_samples.hpp"

#include <algorithm>
#include <array>
#include <bit>

#include "factor/directions.hpp"
#include "factor/lighting.hpp"

namespace twofold {
namespace {

/// Fewer lights are summed as they are.
constexpr std::size_t least_clustered_lights = 256;

/// Samples that are held at a time before they are placed: 4.5 MiB.
constexpr int batch_size = 1 << 16;

/// An integer of the same order.
std::uint64_t key_of(double x) {
    const auto bits = std::bit_cast<std::uint64_t>(x);
    return bits >> 63 != 0 ? ~bits : bits | std::uint64_t{1} << 63;
}

double value_of(std::uint64_t key) {
    return std::bit_cast<double>(key >> 63 != 0 ? key & ~(std::uint64_t{1} << 63) : ~key);
}

/// How many of the values whose keys begin with `start`, all bits from `shift` + 16 on, go on with
/// each 16 bits.
std::vector<std::size_t> counted_digits(const std::vector<double>& values, std::uint64_t start,
                                        int shift) {
    std::vector<std::size_t> count(std::size_t{1} << 16);
    for (const double value : values) {
        const std::uint64_t key = key_of(value) >> shift;
        if (key >> 16 == start) ++count[key & 0xffff];
    }
    return count;
}

/// The value that `rank` others precede in order, found digit by digit: sorting would need the room
/// of the values again.
double at_rank(const std::vector<double>& values, std::size_t rank) {
    std::uint64_t key = 0;
    for (int shift = 48; shift >= 0; shift -= 16) {
        const std::vector<std::size_t> count = counted_digits(values, key, shift);
        std::size_t digit = 0;
        while (rank >= count[digit]) rank -= count[digit++];
        key = key << 16 | digit;
    }
    return value_of(key);
}

void append_largest(std::vector<double>& to, const MaterialSamples& samples) {
    for (const Rgb& radiance : samples.fit.radiance) to.push_back(max_component(radiance));
}

void append_largest(std::vector<double>& to, const FitSamples& samples) {
    const auto& [red, green, blue] = samples.radiance();
    for (std::size_t i = 0; i < red.size(); ++i)
        to.push_back(max_component({red[i], green[i], blue[i]}));
}

std::size_t count_of(const MaterialSamples& samples) { return samples.fit.radiance.size(); }
std::size_t count_of(const FitSamples& samples) { return samples.radiance()[0].size(); }

template <class Samples>
double white_of(const WhitePoint& white, const std::map<std::string, Samples>& materials) {
    if (white.radiance) return *white.radiance;
    std::size_t count = 0;
    for (const auto& [name, samples] : materials) count += count_of(samples);
    if (count == 0) return 1.0;
    std::vector<double> largest;
    largest.reserve(count);
    for (const auto& [name, samples] : materials) append_largest(largest, samples);
    const double rank = white.percentile / 100.0 * static_cast<double>(count - 1);
    const double value = at_rank(largest, static_cast<std::size_t>(rank));
    return value > 0.0 ? value : 1.0;
}

}  // namespace

MaterialSampler::MaterialSampler(const Brdf& brdf, const DistantLights& lights,
                                 const FactorSettings& settings, int threads)
    : brdf_(brdf), lights_(lights), settings_(settings), threads_(threads) {
    if (settings.lighting_sum != LightingSum::full && lights.size() > least_clustered_lights)
        clustered_.emplace(brdf, lights, settings.lighting_tolerance, threads);
}

LightingSamples MaterialSampler::samples(std::uint64_t sequence, int first, int count) const {
    LightingSamples samples{surface_views(count, sequence, first), {}};
    samples.radiance = clustered_ ? clustered_->radiance(samples.at, threads_)
                                  : outgoing_radiance(brdf_, lights_, samples.at, threads_);
    return samples;
}

LightingSamples MaterialSampler::fitted(int first, int count) const {
    return samples(fit_sequence, first, count);
}

LightingSamples MaterialSampler::held_out() const {
    return samples(held_out_sequence, 0, settings_.held_out);
}

FitSamples MaterialSampler::placed() const {
    FitSamples placed(settings_, static_cast<std::size_t>(settings_.samples));
    for (int first = 0; first < settings_.samples; first += batch_size)
        placed.add(fitted(first, std::min(batch_size, settings_.samples - first)), threads_);
    return placed;
}

std::optional<ClusterReport> MaterialSampler::report() const {
    return clustered_ ? std::optional(clustered_->report()) : std::nullopt;
}

double white_radiance(const WhitePoint& white,
                      const std::map<std::string, MaterialSamples>& samples) {
    return white_of(white, samples);
}

double white_radiance(const WhitePoint& white, const std::map<std::string, FitSamples>& samples) {
    return white_of(white, samples);
}

}  // namespace twofold
