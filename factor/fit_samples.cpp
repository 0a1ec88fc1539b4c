#include "factor/fit_samples.hpp"

#include <fmt/format.h>

#include <utility>

#include "factor/factorize_check.hpp"
#include "factor/row_order.hpp"
#include "texunit/error.hpp"
#include "texunit/parallel.hpp"

namespace twofold {

FitSamples::FitSamples(const FactorSettings& settings, std::size_t count)
    : settings_(checked(settings)), count_(count), regulariser_(regulariser_of(settings, count)) {
    at_.reserve(count, settings.view_knots);
    for (Vector& channel : radiance_) channel.reserve(count + regulariser_.rows());
}

void FitSamples::add(const LightingSamples& batch, int threads) {
    check_samples(batch, "fit");
    if (at_.size() + batch.at.size() > count_)
        throw Error(ExitCode::failure, fmt::format("factor: more than {} samples", count_));
    at_.append(batch.at, shape_of(settings_), settings_.view_knots, threads);
    for (const Rgb& radiance : batch.radiance)
        for (int c = 0; c < 3; ++c) radiance_[static_cast<std::size_t>(c)].push_back(radiance[c]);
    while (at_.size() - ordered_ >= ordered_rows) order_to(ordered_ + ordered_rows, threads);
}

void FitSamples::order_to(std::size_t end, int threads) {
    const auto order = order_of_rows(at_, ordered_, end - ordered_, shape_of(settings_));
    parallel_for(radiance_.size() + 1, threads, [&](std::size_t k) {
        if (k < radiance_.size())
            put_in_order(radiance_[k], ordered_, order);
        else
            put_in_order(at_, ordered_, order);
    });
    ordered_ = end;
}

FitSamples::Parts FitSamples::parts(int threads) && {
    if (at_.size() < count_)
        throw Error(ExitCode::failure, fmt::format("factor: {} of {} samples", at_.size(), count_));
    order_to(count_, threads);
    return {log_rows(std::move(at_), std::move(regulariser_), settings_), std::move(radiance_)};
}

}  // namespace twofold
