#include <algorithm>
#include <catch2/catch.hpp>
#include <memory>
#include <vector>

#include "raster/fragment_ops.hpp"
#include "raster/lanes.hpp"
#include "tests/raster/random/dice.hpp"

using namespace twofold;

namespace {

constexpr std::array functions{CompareFunc::never,  CompareFunc::less,    CompareFunc::equal,
                               CompareFunc::lequal, CompareFunc::greater, CompareFunc::notequal,
                               CompareFunc::gequal, CompareFunc::always};

/// Shaded fragments in a tile whose depth has few values, so that equal ones meet.
struct Shaded {
    std::unique_ptr<lanes::BatchPlaces> places = std::make_unique<lanes::BatchPlaces>();
    std::vector<std::uint32_t> words;
    std::vector<std::uint32_t> depth;
    std::size_t size = 0;
};

Shaded random_fragments(test::Dice& dice, std::size_t size) {
    Shaded f;
    f.size = size;
    f.words.resize(lanes::batch_room);
    f.places->at.fill(0);
    f.places->z.fill(0.0);
    for (std::size_t k = 0; k < lanes::tile_pixels + lanes::widest; ++k)
        f.depth.push_back(static_cast<std::uint32_t>(dice.integer(0, 4)));
    int place = 0;
    for (std::size_t k = 0; k < size; ++k) {
        place += dice.integer(1, 60);
        f.places->at[k] = place;
        f.places->z[k] = dice.integer(0, 4);
        f.words[k] = static_cast<std::uint32_t>(dice.integer(126, 129)) << 24 |
                     static_cast<std::uint32_t>(k);
    }
    return f;
}

/// One fragment after the other, as the reference tests them.
Shaded tested(Shaded f, const lanes::LateTests& tests) {
    std::size_t kept = 0;
    for (std::size_t k = 0; k < f.size; ++k) {
        const auto z = static_cast<std::uint32_t>(f.places->z[k]);
        const auto at = static_cast<std::size_t>(f.places->at[k]);
        const auto alpha = static_cast<std::int32_t>(f.words[k] >> 24);
        if (!compare(tests.alpha, alpha, tests.alpha_reference)) continue;
        if (tests.depth.computed && !compare(tests.depth.func, z, f.depth[at])) continue;
        if (tests.depth.computed && tests.depth.write) f.depth[at] = z;
        f.places->at[kept] = f.places->at[k];
        f.words[kept++] = f.words[k];
    }
    f.size = kept;
    return f;
}

Shaded copy_of(const Shaded& f) {
    return {std::make_unique<lanes::BatchPlaces>(*f.places), f.words, f.depth, f.size};
}

}  // namespace

TEST_CASE("Vectors keep the fragments that pass the alpha and the depth test one by one",
          "[raster]") {
    test::Dice dice(46, 0);
    for (int k = 0; k < 400; ++k) {
        lanes::LateTests tests;
        tests.alpha = functions[static_cast<std::size_t>(dice.integer(0, 7))];
        tests.alpha_reference = 127;
        tests.depth.computed = k % 5 != 0;
        tests.depth.func = functions[static_cast<std::size_t>(k % 8)];
        tests.depth.write = k % 3 != 0;
        Shaded f = random_fragments(dice, static_cast<std::size_t>(dice.integer(0, 256)));
        const Shaded expected = tested(copy_of(f), tests);
        f.size = lanes::keep_survivors(tests, f.depth.data(), f.size, *f.places, f.words.data());
        REQUIRE(f.size == expected.size);
        CHECK(std::equal(f.words.begin(), f.words.begin() + static_cast<std::ptrdiff_t>(f.size),
                         expected.words.begin()));
        CHECK(std::equal(f.places->at.begin(),
                         f.places->at.begin() + static_cast<std::ptrdiff_t>(f.size),
                         expected.places->at.begin()));
        CHECK(std::equal(f.depth.begin(), f.depth.begin() + lanes::tile_pixels,
                         expected.depth.begin()));
    }
}

TEST_CASE("Of colours for one pixel the last stays", "[raster]") {
    test::Dice dice(46, 1);
    constexpr std::size_t stride = 3 * lanes::tile_edge;
    Shaded f = random_fragments(dice, 250);
    for (std::size_t k = 0; k < f.size; ++k)
        f.places->at[k] = k < 100 ? static_cast<std::int32_t>(k) : dice.integer(0, 300);
    std::vector<std::uint32_t> picture(stride * lanes::tile_edge), expected(picture.size());
    for (std::size_t k = 0; k < f.size; ++k) {
        const auto at = static_cast<std::size_t>(f.places->at[k]);
        expected[at / lanes::tile_edge * stride + at % lanes::tile_edge] = f.words[k];
    }
    lanes::write_colors(*f.places, f.words.data(), f.size, picture.data(), stride);
    CHECK(picture == expected);
}
