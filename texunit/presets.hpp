#pragma once
#include <utility>

#include "texunit/coarse8.hpp"
#include "texunit/custom.hpp"
#include "texunit/float32.hpp"
#include "texunit/gl13.hpp"
#include "texunit/ideal64.hpp"
#include "texunit/nv17.hpp"
#include "texunit/nv2x.hpp"

namespace twofold {

/// Calls `f` with a value of the numeric model that belongs to `preset`.
/// @param settings what `custom` computes with; the other presets do not look at it
/// @throws Error if the preset is `custom` and a setting is out of its range
template <class F>
decltype(auto) with_model(Preset preset, const CustomSettings& settings, F&& f) {
    switch (preset) {
        case Preset::ideal64:
            return std::forward<F>(f)(Ideal64{});
        case Preset::float32:
            return std::forward<F>(f)(Float32{});
        case Preset::gl13:
            return std::forward<F>(f)(Gl13{});
        case Preset::nv2x:
            return std::forward<F>(f)(Nv2x{});
        case Preset::nv17:
            return std::forward<F>(f)(Nv17{});
        case Preset::coarse8:
            return std::forward<F>(f)(Coarse8{});
        case Preset::custom:
            break;
    }
    return std::forward<F>(f)(Custom{settings});
}

/// The same with the initial settings of `custom`, which are nv17's.
template <class F>
decltype(auto) with_model(Preset preset, F&& f) {
    return with_model(preset, CustomSettings{}, std::forward<F>(f));
}

}  // namespace twofold
