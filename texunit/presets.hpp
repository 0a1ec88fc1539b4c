#pragma once
#include <utility>

#include "texunit/float32.hpp"
#include "texunit/gl13.hpp"
#include "texunit/ideal64.hpp"
#include "texunit/nv17.hpp"

namespace twofold {

/// Calls `f` with a value of the numeric model that belongs to `preset`.
template <class F>
decltype(auto) with_model(Preset preset, F&& f) {
    switch (preset) {
        case Preset::ideal64:
            return std::forward<F>(f)(Ideal64{});
        case Preset::float32:
            return std::forward<F>(f)(Float32{});
        case Preset::gl13:
            return std::forward<F>(f)(Gl13{});
        case Preset::nv17:
            break;
    }
    return std::forward<F>(f)(Nv17{});
}

}  // namespace twofold
