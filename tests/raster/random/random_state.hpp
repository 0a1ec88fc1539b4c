#pragma once
#include "raster/fast.hpp"
#include "tests/raster/random/dice.hpp"

/// Random frames for the proof that every way of drawing gives the reference's bytes.
namespace twofold::test {

/// Everything that a picture depends on, and how the fast pipeline is asked to draw it.
struct RandomState {
    Preset preset = Preset::nv17;
    CustomSettings custom;
    FastOptions options;
    Frame frame;
};

/// State number `number` of the sequence `seed`. The preset is number mod 7, so any 7 neighbours
/// show all; the threads (1, 2, 7) and fusing go round in turn as well. About half of the states
/// are several passes over one mesh as the paper draws them, some with one pass a little different;
/// the others are made of anything.
RandomState random_state(std::uint64_t seed, std::uint64_t number);

/// The same, with mipmaps in all textures that can have them and units that choose among levels.
RandomState random_state_with_levels(std::uint64_t seed, std::uint64_t number);

}  // namespace twofold::test
