#include "tests/platforms/preset_input.hpp"
#include "tests/raster/random/random_parts.hpp"
#include "texunit/combiner.hpp"

namespace twofold::platforms {
namespace {

template <NumericModel M>
Hashes mapping_hashes(const M& m) {
    Hashes hashes;
    for (int mapping = 0; mapping < 8; ++mapping)
        hashes.push_back(hash_over(preset_name("combiner", m, fmt::format("mapping-{}", mapping)),
                                   256, [&](std::size_t i) {
                                       return mapped(m, static_cast<CombinerMapping>(mapping),
                                                     signed_channel(m, i, 1));
                                   }));
    return hashes;
}

template <NumericModel M>
CombinerInputs<M> inputs(const M& m, std::size_t i) {
    return {color(m, i, 1),
            color(m, i, 5),
            color(m, i, 9),
            {color(m, i, 13), color(m, i, 17), color(m, i, 21), color(m, i, 25)}};
}

/// Programs of the random states' kind, as many stages as the chip has.
template <NumericModel M>
Hashes program_hashes(const M& m) {
    Hashes hashes;
    for (std::uint64_t number = 0; number < 8; ++number) {
        test::Dice dice(3, number);
        const auto program = bind_combiners(m, test::random_combiners(dice, m.combiner_stages));
        hashes.push_back(
            hash_over(preset_name("combiner", m, fmt::format("program-{}", number)), 32,
                      [&](std::size_t i) { return run_combiners(m, program, inputs(m, i)); }));
    }
    return hashes;
}

}  // namespace

Hashes combiner_hashes() {
    return over_presets([](const auto& m) {
        Hashes hashes = mapping_hashes(m);
        append(hashes, program_hashes(m));
        return hashes;
    });
}

}  // namespace twofold::platforms
