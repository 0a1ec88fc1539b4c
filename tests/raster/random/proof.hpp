#pragma once
#include <filesystem>
#include <functional>
#include <optional>

#include "tests/raster/random/mismatch.hpp"
#include "tests/raster/random/random_state.hpp"

namespace twofold::test {

/// A way to draw a state.
using Renderer = std::function<Framebuffer(const RandomState&)>;

Framebuffer by_reference(const RandomState& state);
Framebuffer by_fast(const RandomState& state);

/// What the fast pipeline makes of a state's passes: how often its own code is proved at all.
struct FastShare {
    std::size_t by_vectors = 0;  ///< passes whose fragments vectors shade
    std::size_t joined = 0;      ///< passes that share an earlier one's geometry
};

FastShare fast_share(const RandomState& state);

/// How the second way differs from the first, which may both throw, but only the same words.
std::optional<PictureMismatch> difference(const RandomState& state, const Renderer& expected,
                                          const Renderer& found);

/// A state that the fast pipeline draws otherwise than the reference, in words: seed, number,
/// preset, options, the first pixel. The state and a shrunk one are written into `folder` as
/// scenes.
std::string failure_report(std::uint64_t seed, std::uint64_t number, const RandomState& state,
                           const PictureMismatch& mismatch, const Renderer& found,
                           const std::filesystem::path& folder);

}  // namespace twofold::test
