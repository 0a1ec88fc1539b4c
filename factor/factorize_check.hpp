#pragma once
#include "factor/samples.hpp"
#include "factor/settings.hpp"

namespace twofold {

/// Refuses what factorize() cannot work with.
/// @throws Error that names the argument or the setting and its value
void check_arguments(const LightingSamples& fit, const LightingSamples& held_out,
                     const FactorSettings& settings, double white);
void check_samples(const LightingSamples& samples, const char* name);
void check_white(double white);

/// The settings, if each is in its range.
const FactorSettings& checked(const FactorSettings& settings);

}  // namespace twofold
