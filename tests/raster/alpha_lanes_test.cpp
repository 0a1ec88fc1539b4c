#include "raster/alpha_lanes.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "tests/raster/random/dice.hpp"

using namespace twofold;

namespace {

/// Alphas of cells: 0, 1, or 2 for neither, in patches of 8 x 8 cells.
struct Cells {
    int columns, rows, cell_bits;
    std::vector<int> alpha;
    std::vector<std::uint32_t> count;

    int at(int x, int y) const { return alpha[static_cast<std::size_t>(y * columns + x)]; }
};

Cells random_cells(test::Dice& dice, int columns, int rows, int cell_bits) {
    Cells cells{columns, rows, cell_bits, {}, {}};
    std::vector<int> patch;
    for (int k = 0; k < 64 * 64; ++k) patch.push_back(dice.integer(0, 2));
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < columns; ++x)
            cells.alpha.push_back(patch[static_cast<std::size_t>(y / 8 * 64 + x / 8)]);
    for (int y = 0; y <= rows; ++y)
        for (int x = 0; x <= columns; ++x) {
            std::uint32_t sum = 0;
            for (int j = 0; j < y; ++j)
                for (int i = 0; i < x; ++i)
                    sum += cells.at(i, j) == 0 ? 1u : (cells.at(i, j) == 1 ? 1u << 16 : 0u);
            cells.count.push_back(sum);
        }
    return cells;
}

struct Box {
    float low, high;
};

/// 1 if all texels within 3/4 of the corners' box are in cells of alpha 0, 2 if in cells of
/// alpha 1.
int expected(const Cells& cells, Box u, Box v) {
    const auto cell = [&](float place, int count) {
        const int texel = static_cast<int>(std::floor(place));
        const int last = (count << cells.cell_bits) - 1;
        return (texel < 0 ? 0 : (texel > last ? last : texel)) >> cells.cell_bits;
    };
    bool zero = true, one = true;
    for (int y = cell(v.low - 0.75f, cells.rows); y <= cell(v.high + 0.75f, cells.rows); ++y)
        for (int x = cell(u.low - 0.75f, cells.columns); x <= cell(u.high + 0.75f, cells.columns);
             ++x) {
            zero = zero && cells.at(x, y) == 0;
            one = one && cells.at(x, y) == 1;
        }
    return zero ? 1 : (one ? 2 : 0);
}

}  // namespace

TEST_CASE("Alphas of triangles are known where all cells they can read agree", "[raster]") {
    test::Dice dice(7, 0);
    const Cells cells = random_cells(dice, 48, 32, 2);
    const std::size_t vertices = 300, triangles = 1003, stride = 5;
    std::vector<float> u, v;
    // Quarters of a texel: the margin for rounding decides nothing.
    const auto place = [&](int texels) {
        return 0.25f * static_cast<float>(dice.integer(0, texels * 4 + 80)) - 9.875f;
    };
    std::vector<std::uint32_t> list;
    for (std::size_t k = 0; k < vertices; ++k) {
        // Vertices that follow one another lie together.
        const bool near = k % 3 != 0;
        u.push_back(near ? u.back() + 0.25f * static_cast<float>(dice.integer(0, 19)) : place(192));
        v.push_back(near ? v.back() + 0.25f * static_cast<float>(dice.integer(0, 19)) : place(128));
    }
    for (std::size_t k = 0; k < triangles; ++k) {
        const auto first = static_cast<std::uint32_t>(3 * dice.index(vertices / 3));
        list.insert(list.end(), {first, first + 1, first + 2, 99u, 99u});
    }
    std::vector<std::uint8_t> known(triangles + 16);
    lanes::find_alphas({192, 128, 2, 48, cells.count.data()}, {u.data(), v.data()},
                       {list.data(), stride, triangles}, known.data());
    std::array<int, 3> seen{};
    int wrong = 0;
    for (std::size_t k = 0; k < triangles; ++k) {
        const auto box = [&](const std::vector<float>& values) {
            const float a = values[list[stride * k]], b = values[list[stride * k + 1]];
            const float c = values[list[stride * k + 2]];
            return Box{std::min({a, b, c}), std::max({a, b, c})};
        };
        wrong += known[k] != expected(cells, box(u), box(v));
        ++seen[known[k]];
    }
    CHECK(wrong == 0);
    CHECK(seen[0] > 100);
    CHECK(seen[1] > 50);
    CHECK(seen[2] > 50);
}

TEST_CASE("A place that is not finite reads inside the grid", "[raster]") {
    test::Dice dice(8, 0);
    const Cells cells = random_cells(dice, 4, 4, 0);
    const float infinite = std::numeric_limits<float>::infinity();
    const std::vector<float> u{infinite, -infinite, std::nanf("")}, v = u;
    const std::vector<std::uint32_t> list{0, 1, 2, 2, 2, 2, 0, 0, 0};
    std::vector<std::uint8_t> known(3 + 16);
    lanes::find_alphas({4, 4, 0, 4, cells.count.data()}, {u.data(), v.data()}, {list.data(), 3, 3},
                       known.data());
    for (std::size_t k = 0; k < 3; ++k) CHECK(known[k] <= 2);
}
