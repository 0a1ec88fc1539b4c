#include "factor/view_table.hpp"

#include <catch2/catch.hpp>

using namespace twofold;

TEST_CASE("knots of g stand at squares, and weights between them sum to 1 and are linear") {
    constexpr int knots = 24;
    for (int k = 0; k < knots; ++k) {
        const double at = (k / 23.0) * (k / 23.0);
        const ViewFootprint f = view_footprint(at, knots);
        const auto knot = static_cast<std::uint32_t>(k);
        CHECK((f.index[0] == knot ? f.weight[0] : f.weight[1]) == Approx(1.0).margin(1e-9));
    }
    for (double c = 0.0; c <= 1.0; c += 0.003) {
        const ViewFootprint f = view_footprint(c, knots);
        const auto place = [](std::uint32_t k) { return (k / 23.0) * (k / 23.0); };
        CHECK(f.weight[0] + f.weight[1] == Approx(1.0).epsilon(1e-15));
        CHECK(f.weight[0] * place(f.index[0]) + f.weight[1] * place(f.index[1]) ==
              Approx(c).margin(1e-14));
    }
}

TEST_CASE("g is held at its ends, and 1 without a table") {
    const std::vector<double> table{3.0, 2.0, 1.0};
    CHECK(view_value(std::span(table), -1.0) == 3.0);
    CHECK(view_value(std::span(table), 0.25) == 2.0);
    CHECK(view_value(std::span(table), 2.0) == 1.0);
    CHECK(view_value(std::span<const double>{}, 0.3) == 1.0);
    CHECK(view_value(std::span<const Rgb>{}, 0.3) == Rgb(1.0));
}
