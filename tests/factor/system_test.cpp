#include "factor/system.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "factor/vector_arithmetic.hpp"
#include "factor_cases.hpp"
#include "texunit/error.hpp"

using namespace twofold;

namespace {

FactorSettings small_settings() {
    FactorSettings settings;
    settings.map_size = 8;
    return settings;
}

/// (1; -1): the scale that t1 may give to t2.
Vector gauge(std::size_t unknowns) {
    Vector z(unknowns, 1.0);
    for (std::size_t j = unknowns / 2; j < unknowns; ++j) z[j] = -1.0;
    return z;
}

ChannelRows treat(const std::vector<double>& radiance, FactorSettings settings, double white) {
    const LogRows rows = log_rows(surface_views(static_cast<int>(radiance.size()), 1), settings);
    return channel_rows(rows, radiance, settings, white);
}

}  // namespace

TEST_CASE("a sample row holds the weights of the normal, then those of the reflected view") {
    const std::vector<SurfaceView> at = surface_views(50, 1);
    const LogRows rows = log_rows(at, small_settings());
    REQUIRE(rows.samples == 50);
    for (std::size_t i = 0; i < rows.samples; ++i) {
        const TexelFootprint n = footprint_of(at[i].n, rows.shape);
        const TexelFootprint r = footprint_of(pi_2(at[i]), rows.shape);
        const RowEntries row = rows.matrix.row(i);
        REQUIRE(row.size() == 8);
        // Either fraction is rounded to 2^-16.
        for (std::size_t k = 0; k < 4; ++k) {
            CHECK(row[k].column == n.index[k]);
            CHECK(row[k].value == Approx(n.weight[k]).margin(0x1p-16));
            CHECK(row[4 + k].column == rows.shape.texels() + r.index[k]);
            CHECK(row[4 + k].value == Approx(r.weight[k]).margin(0x1p-16));
        }
        // The weights are exact, so that their sums are too.
        CHECK(row[0].value + row[1].value + row[2].value + row[3].value == 1.0);
        CHECK(row[4].value + row[5].value + row[6].value + row[7].value == 1.0);
    }
}

TEST_CASE("F07 moving a factor from one map to the other changes no row", "[hard][F07]") {
    const LogRows rows = log_rows(surface_views(500, 1), small_settings());
    CHECK(largest_magnitude(rows.matrix.multiply(gauge(rows.matrix.columns()), 1)) < 1e-14);
}

TEST_CASE("smoothness rows compare a texel with the mean of its neighbours in the face") {
    FactorSettings settings = small_settings();
    settings.seam = 0.0;
    settings.smoothness = 2.0;
    const LogRows rows = log_rows(surface_views(512, 1), settings);
    REQUIRE(rows.matrix.rows() == 512 + 256);
    const double scale = 2.0 * std::sqrt(512.0 / 128.0);
    const auto corner = rows.matrix.row(512);
    REQUIRE(corner.size() == 3);
    CHECK(corner[0].value == scale);
    CHECK(corner[1].value == -scale / 2.0);
    const auto inner = rows.matrix.row(512 + 9);
    REQUIRE(inner.size() == 5);
    CHECK(inner[0].column == 9);
    CHECK(inner[1].column == 8);
    CHECK(inner[2].column == 10);
    CHECK(inner[3].column == 1);
    CHECK(inner[4].column == 17);
    CHECK(inner[4].value == -scale / 4.0);
}

TEST_CASE("T01 seam rows tie each texel beyond the rim to the other face", "[hard][T01]") {
    FactorSettings settings = small_settings();
    settings.seam = 0.3;
    const LogRows rows = log_rows(surface_views(512, 1), settings);
    const double scale = 0.3 * std::sqrt(512.0 / 128.0);
    const std::size_t first_seam = rows.samples + rows.matrix.columns();
    REQUIRE(rows.matrix.rows() > first_seam);
    for (std::size_t i = first_seam; i < rows.matrix.rows(); ++i) {
        const auto row = rows.matrix.row(i);
        const std::size_t own = row[0].column % rows.shape.texels();
        const MapTexel texel = texel_at(own, rows.shape);
        CHECK(row[0].value == Approx(scale));
        CHECK_FALSE(within_face(texel, rows.shape));
        for (std::size_t k = 1; k < 5; ++k) {
            CHECK(texel_at(row[k].column % rows.shape.texels(), rows.shape).face != texel.face);
        }
    }
}

TEST_CASE("on a cube every texel has four neighbours, and seam rows join edges pair by pair") {
    FactorSettings settings = small_settings();
    settings.map_form = MapForm::cube;
    settings.smoothness = 1.0;
    settings.seam = 0.3;
    const LogRows rows = log_rows(surface_views(512, 1), settings);
    const std::size_t texels = rows.shape.texels();
    REQUIRE(rows.matrix.columns() == 2 * texels);
    for (std::size_t i = rows.samples; i < rows.samples + 2 * texels; ++i)
        REQUIRE(rows.matrix.row(i).size() == 5);
    // 12 edges of 8 texels, seen from both sides, in two maps.
    CHECK(rows.matrix.rows() == rows.samples + 2 * texels + 2 * 2 * 12 * 8);
    for (std::size_t i = rows.samples + 2 * texels; i < rows.matrix.rows(); ++i) {
        const auto row = rows.matrix.row(i);
        REQUIRE(row.size() == 2);
        CHECK(row[0].value == -row[1].value);
        CHECK(texel_at(row[0].column % texels, rows.shape).face !=
              texel_at(row[1].column % texels, rows.shape).face);
    }
}

TEST_CASE("F01 zero radiance is raised to the floor and counted", "[hard][F01]") {
    std::vector<double> radiance(1000, 2.0);
    radiance[17] = 0.0;
    const ChannelRows rows = treat(radiance, small_settings(), 10.0);
    CHECK(rows.treated.zero == 1);
    CHECK(rows.treated.used == 1000);
    CHECK(rows.mean == Approx(2.0 * 0.999));
    CHECK(rows.right_side[17] == Approx(std::log(1e-3 * rows.mean)));
    CHECK(rows.right_side[18] == Approx(std::log(2.0)));

    std::vector<double> all_but_one(1000, 0.0);
    all_but_one[3] = 5.0;
    const ChannelRows lonely = treat(all_but_one, small_settings(), 10.0);
    CHECK(lonely.treated.zero == 999);
    CHECK(all_finite(lonely.right_side));
}

TEST_CASE("F02 negative radiance is raised to the floor, counted and never in the mean",
          "[hard][F02]") {
    std::vector<double> radiance(100, 1.0);
    radiance[0] = -1e-30;
    radiance[1] = -0.0;
    radiance[2] = -3894.0;
    const ChannelRows rows = treat(radiance, small_settings(), 10.0);
    CHECK(rows.treated.negative == 2);
    CHECK(rows.treated.zero == 1);
    CHECK(rows.mean == Approx(0.97));
    for (const std::size_t i : {0U, 1U, 2U}) {
        CHECK(rows.right_side[i] == Approx(std::log(1e-3 * rows.mean)));
    }
}

TEST_CASE("non-finite radiance is left out and counted") {
    std::vector<double> radiance(100, 1.0);
    radiance[5] = std::numeric_limits<double>::quiet_NaN();
    radiance[6] = std::numeric_limits<double>::infinity();
    const ChannelRows rows = treat(radiance, small_settings(), 10.0);
    CHECK(rows.treated.non_finite == 2);
    CHECK(rows.treated.used == 98);
    CHECK(rows.mean == 1.0);
    CHECK(rows.weight[5] == 0.0);
    CHECK(rows.weight[6] == 0.0);
    CHECK(rows.weight[7] == 1.0);
    CHECK_THROWS_AS(treat({std::numeric_limits<double>::quiet_NaN()}, small_settings(), 1.0),
                    Error);
}

TEST_CASE("radiance above the cap is lowered to it before the mean is taken") {
    std::vector<double> radiance(100, 1.0);
    radiance[0] = 1e6;
    const ChannelRows rows = treat(radiance, small_settings(), 2.0);
    CHECK(rows.treated.capped == 1);
    CHECK(rows.mean == Approx(1.07));
    CHECK(rows.right_side[0] == Approx(std::log(8.0)));

    FactorSettings uncapped = small_settings();
    uncapped.cap = 0.0;
    CHECK(treat(radiance, uncapped, 2.0).right_side[0] == Approx(std::log(1e6)));
}

TEST_CASE("row weights are a power of radiance over its mean, 1 for the rows of the regulariser") {
    std::vector<double> radiance(100, 1.0);
    radiance[0] = 16.0;
    FactorSettings settings = small_settings();
    settings.row_weight = 0.5;
    settings.cap = 0.0;
    const ChannelRows rows = treat(radiance, settings, 1.0);
    CHECK(rows.weight[0] == Approx(std::sqrt(16.0 / 1.15)));
    CHECK(rows.weight.back() == 1.0);
}

TEST_CASE("F11 an all black channel takes no logarithm", "[hard][F11]") {
    const ChannelRows rows = treat(std::vector<double>(100, 0.0), small_settings(), 1.0);
    CHECK(rows.black());
    CHECK(rows.treated.zero == 100);
    CHECK(largest_magnitude(rows.right_side) == 0.0);
}

TEST_CASE("column scaling makes every column of the weighted system a unit vector") {
    const cases::Phong phong;
    const FactorSettings settings = small_settings();
    const LightingSamples samples = cases::samples_of(phong, 2000, 1);
    const LogRows left = log_rows(samples.at, settings);
    std::vector<double> radiance;
    for (const Rgb& rgb : samples.radiance) radiance.push_back(rgb.x);
    const ChannelRows right = channel_rows(left, radiance, settings, 1.0);
    const WeightedSystem system(left, right, settings, 1);
    for (std::size_t j = 0; j < left.matrix.columns(); j += 5) {
        Vector unit(left.matrix.columns(), 0.0);
        unit[j] = 1.0;
        CHECK(norm(system.apply(unit)) == Approx(1.0).epsilon(1e-12));
    }
    const Vector x = gauge(left.matrix.columns());
    CHECK(largest_magnitude(minus(system.unknowns(system.scaled_unknowns(x)), x)) < 1e-15);
    // What the products with the transpose give has no part along the gauge.
    const Vector g = system.apply_transpose(system.right_side());
    CHECK(std::fabs(dot(g, system.scaled_unknowns(x))) < 1e-11 * norm(g));
}

TEST_CASE("F07 balancing gives both maps one mean and keeps their sums", "[hard][F07]") {
    const SparseMatrix rows(4, {0, 2, 4, 6},
                            {{0, 1.0}, {2, 1.0}, {1, 1.0}, {3, 1.0}, {0, 1.0}, {3, 1.0}});
    const Gauge gauge(rows, Vector(3, 1.0), {0, 2, 4});
    CHECK(gauge.components() == 1);
    CHECK(gauge.balanced({1.0, 3.0, 10.0, 14.0}) == Vector{6.0, 8.0, 5.0, 9.0});
}
