#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "texunit/texture.hpp"

namespace twofold::bench {

/// A pixel, x and y from the top left, and what the two drew there.
struct PixelPair {
    int x = 0, y = 0;
    Rgba8 ours, theirs;
};

/// How two pictures of one frame differ, summed over any number of frames. A step is one of 255 of
/// the worst channel.
struct PictureComparison {
    std::size_t pixels = 0;
    std::size_t coverage = 0;  ///< drawn in one of the pictures only; their colours do not count
    std::size_t left_out = 0;  ///< along seams, where they may differ by anything
    std::array<std::size_t, 6> steps{};  ///< pixels by step: 0, 1, 2, 3, 4, more
    int worst = 0;
    PixelPair worst_pixel{};  ///< the first with that step

    std::size_t compared() const { return pixels - coverage - left_out; }
    /// Share of the compared pixels that are equal in all channels.
    double equal_share() const;
};

/// Adds what differs between `ours` and `theirs` to `sum`.
/// @param background  the clear colour: what still has it counts as not drawn
/// @param left_out    one per pixel, or empty
void compare_pictures(const ByteImage& ours, const ByteImage& theirs, Rgba8 background,
                      const std::vector<bool>& left_out, PictureComparison& sum);

}  // namespace twofold::bench
