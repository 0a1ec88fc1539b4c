#include "factor/bilinear_fit.hpp"

#include <Eigen/Dense>
#include <catch2/catch.hpp>
#include <cmath>

#include "factor/separable.hpp"
#include "factor_cases.hpp"
#include "texunit/random.hpp"

using namespace twofold;

namespace {

Eigen::MatrixXd random_matrix(int rows, int columns) {
    Eigen::MatrixXd m(rows, columns);
    for (int i = 0; i < rows; ++i)
        for (int j = 0; j < columns; ++j)
            m(i, j) = random_unit(7, static_cast<std::uint64_t>(i * columns + j)) /
                      (1.0 + 0.5 * std::abs(i - j));
    return m;
}

/// Every entry of a matrix as a sample that touches one unknown of each side.
struct WholeMatrix {
    BilinearSide first, second;
    Vector values, weight;

    explicit WholeMatrix(const Eigen::MatrixXd& m)
        : first(side(m, true)),
          second(side(m, false)),
          weight(static_cast<std::size_t>(m.size()), 1.0) {
        for (int i = 0; i < m.rows(); ++i)
            for (int j = 0; j < m.cols(); ++j) values.push_back(m(i, j));
    }

    static BilinearSide side(const Eigen::MatrixXd& m, bool rows) {
        RowBuilder builder, none;
        for (int i = 0; i < m.rows(); ++i)
            for (int j = 0; j < m.cols(); ++j)
                builder.add(std::array{MatrixEntry{static_cast<std::uint32_t>(rows ? i : j), 1.0}});
        const auto count = static_cast<std::size_t>(rows ? m.rows() : m.cols());
        return {builder.build(count), none.build(count)};
    }

    BilinearProblem problem() const { return {first, second, values, weight}; }
};

}  // namespace

TEST_CASE("on a whole matrix the signed sum is Eigen's SVD, truncated") {
    const Eigen::MatrixXd m = random_matrix(14, 11);
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(m, Eigen::ComputeThinU | Eigen::ComputeThinV);
    const WholeMatrix whole(m);
    for (const std::size_t terms : {1U, 2U, 3U, 4U}) {
        const SignedSum sum = fit_signed_sum(whole.problem(), terms, 100, 1);
        double left = 0.0;
        for (int k = static_cast<int>(terms); k < 11; ++k)
            left += svd.singularValues()(k) * svd.singularValues()(k);
        CAPTURE(terms, sum.objective.size());
        CHECK(sum.objective.back() == Approx(std::sqrt(left / 154.0)).epsilon(0.01));
        CHECK(sum.objective.back() >= std::sqrt(left / 154.0) * (1.0 - 1e-9));
        for (std::size_t j = 0; j < terms; ++j) {
            CHECK(norm(sum.first[j]) ==
                  Approx(svd.singularValues()(static_cast<int>(j))).epsilon(0.03));
            for (std::size_t k = 0; k < terms; ++k) {
                CHECK(dot(sum.second[j], sum.second[k]) == Approx(j == k ? 1.0 : 0.0).margin(1e-9));
                if (j != k) CHECK(dot(sum.first[j], sum.first[k]) == Approx(0.0).margin(1e-9));
            }
        }
    }
}

TEST_CASE("a matrix of rank 2 is recovered by 2 signed products, also where entries are missing") {
    const Eigen::MatrixXd a = random_matrix(20, 2), b = random_matrix(16, 2);
    const Eigen::MatrixXd m = a * Eigen::Vector2d(1.0, -0.7).asDiagonal() * b.transpose();
    WholeMatrix part(m);
    for (std::size_t i = 0; i < part.weight.size(); ++i)
        part.weight[i] = random_unit(3, i) < 0.75 ? 1.0 : 0.0;
    const SignedSum sum = fit_signed_sum(part.problem(), 2, 100, 1);
    CHECK(sum.objective.back() < 1e-3 * sum.objective[0]);
    double worst = 0.0;
    for (std::size_t i = 0; i < 20; ++i)
        for (std::size_t k = 0; k < 16; ++k) {
            const double value =
                sum.first[0][i] * sum.second[0][k] + sum.first[1][i] * sum.second[1][k];
            worst = std::max(worst, std::abs(value - m(static_cast<int>(i), static_cast<int>(k))));
        }
    CHECK(worst < 0.01 * m.cwiseAbs().maxCoeff());
}

TEST_CASE("columns are made orthogonal without changing the sum, the longest first") {
    TermVectors first{{1.0, 2.0, 3.0}, {0.5, -1.0, 4.0}}, second{{2.0, 1.0}, {-1.0, 5.0}};
    const TermVectors u = first, v = second;
    make_orthogonal(first, second);
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t k = 0; k < 2; ++k)
            CHECK(first[0][i] * second[0][k] + first[1][i] * second[1][k] ==
                  Approx(u[0][i] * v[0][k] + u[1][i] * v[1][k]));
    CHECK(dot(first[0], first[1]) == Approx(0.0).margin(1e-12));
    CHECK(norm(first[0]) > norm(first[1]));
    CHECK(second[0][0] + second[0][1] >= 0.0);
}

TEST_CASE("normalised decomposition of a separable matrix is exact in every norm") {
    const Eigen::VectorXd a = random_matrix(9, 1), b = random_matrix(7, 1);
    const WholeMatrix whole(a * b.transpose());
    const double mean = b.mean(), root = std::sqrt(b.squaredNorm() / 7.0), largest = b.maxCoeff();
    for (const auto& [norm, of_b] :
         {std::pair{RowNorm::one, mean}, {RowNorm::two, root}, {RowNorm::max, largest}}) {
        const auto d =
            decompose(whole.first.footprint, whole.second.footprint, whole.values, norm, 1);
        for (int i = 0; i < 9; ++i)
            CHECK(d.first[static_cast<std::size_t>(i)] == Approx(a(i) * of_b));
        for (int k = 0; k < 7; ++k)
            CHECK(d.second[static_cast<std::size_t>(k)] == Approx(b(k) / of_b));
    }
}

TEST_CASE("the positive parts of signed products add up to them with their signs") {
    const MapShape shape{4, 0.875};
    SignedSum sum;
    for (std::size_t j = 0; j < 2; ++j) {
        Vector u, v;
        for (std::size_t k = 0; k < shape.texels(); ++k) {
            u.push_back(2.0 * random_unit(j, k) - 1.0);
            v.push_back(2.0 * random_unit(j + 5, k) - 0.7);
        }
        sum.first.push_back(u);
        sum.second.push_back(v);
    }
    const auto parts = positive_parts(sum, {shape, shape});
    REQUIRE(parts.size() == 8);
    for (std::uint32_t x = 0; x < shape.texels(); x += 3) {
        if (!is_opaque(texel_at(x, shape), shape)) continue;
        PairFootprint at{
            {{x, x, x, x}, {1.0, 0.0, 0.0, 0.0}}, {{5, 5, 5, 5}, {1.0, 0.0, 0.0, 0.0}}, 1.0};
        double value = 0.0;
        for (const ChannelProduct& part : parts) value += product_at(part, at);
        CHECK(value ==
              Approx(sum.first[0][x] * sum.second[0][5] + sum.first[1][x] * sum.second[1][5])
                  .margin(1e-9));
    }
}

TEST_CASE("J signed products recover a lighting function that is a sum of J", "[long]") {
    const auto radiance = [](const SurfaceView& at) {
        const Vec3 r = pi_2(at);
        return Rgb(1.0 + 0.6 * at.n.x * r.y + 0.3 * at.n.z * (r.x * r.x - 0.4));
    };
    const LightingSamples fit = cases::samples_of_function(10000, 1, radiance);
    const LightingSamples held = cases::samples_of_function(4000, 2, radiance);
    FactorSettings settings;
    settings.model = Model::svd;
    settings.map_size = 16;
    settings.smoothness = 0.03;
    settings.rounds = 10;
    std::vector<double> errors;
    for (const int terms : {1, 2, 3}) {
        settings.terms = terms;
        errors.push_back(factor_separable({fit, held}, settings, 2.0, 2).fit[0].relative_rms);
    }
    CAPTURE(errors);
    CHECK(errors[0] > 0.1);
    CHECK(errors[1] < 0.7 * errors[0]);
    CHECK(errors[2] < 0.01);
}

TEST_CASE("signed sums and normalised decomposition have the same bits at 1 and 7 threads") {
    const LightingSamples fit = cases::samples_of({}, 4000, 1);
    for (const Model model : {Model::svd, Model::nd}) {
        FactorSettings settings;
        settings.model = model;
        settings.map_size = 8;
        settings.terms = 2;
        const FactoredLighting one = factor_separable({fit, {}}, settings, 2.0, 1);
        const FactoredLighting many = factor_separable({fit, {}}, settings, 2.0, 7);
        CHECK(one.fit[0].relative_rms == many.fit[0].relative_rms);
        CHECK(one.fit[0].psnr == many.fit[0].psnr);
        REQUIRE(one.terms.size() == many.terms.size());
        for (std::size_t k = 0; k < one.terms.size(); ++k) CHECK(one.terms[k].c == many.terms[k].c);
    }
}

TEST_CASE("headroom is what the sum of the added parts needs above white") {
    const MapShape shape{4, 0.875};
    const ChannelProduct one = product_of(white_channel(shape), white_channel(shape));
    ChannelProduct off = one;
    off.subtract = true;
    off.scale = 1.2;
    const auto part = [](const ChannelProduct& product) {
        return std::array{product, product, product};
    };
    const auto pairs = footprints_of(surface_views(50, 1), shape);
    // 1 + 1 - 1.2: drawn in this order it is 1 - 1.2 without room, and .8 with a doubling pass.
    const auto parts = drawn_parts({part(one), part(off), part(one)}, 1.0);
    REQUIRE(parts.size() == 3);
    CHECK(parts[2][0].subtract);
    CHECK(clamped_share(std::array{one, one, off}, pairs, 1.0, 0) == 1.0);
    CHECK(clamped_share(std::array{one, one, off}, pairs, 1.0, 1) == 0.0);
    CHECK(headroom(parts, pairs, 1.0) == 1);
    CHECK(headroom(drawn_parts({part(one)}, 1.0), pairs, 1.0) == 0);
    ChannelProduct faint = one;
    faint.scale = 0.4 / 255.0;
    CHECK(drawn_parts({part(one), part(faint)}, 1.0).size() == 1);
}
