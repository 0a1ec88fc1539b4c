#include "texunit/ordered_sum.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "texunit/parallel.hpp"
#include "texunit/random.hpp"

namespace {

using namespace twofold;

double reciprocal(std::size_t i) { return 1.0 / static_cast<double>(i + 1); }

/// The rule as docs/exactness.md writes it, level by level and without cleverness.
double as_written(const std::vector<double>& p) {
    std::vector<double> level;
    for (std::size_t first = 0; first < p.size(); first += 256) {
        double lane[8] = {};
        for (std::size_t i = first; i < p.size() && i < first + 256; ++i) lane[i & 7] += p[i];
        level.push_back(((lane[0] + lane[1]) + (lane[2] + lane[3])) +
                        ((lane[4] + lane[5]) + (lane[6] + lane[7])));
    }
    while (level.size() > 1) {
        std::vector<double> above;
        for (std::size_t j = 0; j + 1 < level.size(); j += 2) {
            above.push_back(level[j] + level[j + 1]);
        }
        if (level.size() % 2 == 1) above.push_back(level.back());
        level = above;
    }
    return level.empty() ? 0.0 : level[0];
}

std::vector<double> mixed_terms(std::size_t n) {
    std::vector<double> terms(n);
    for (std::size_t i = 0; i < n; ++i) {
        terms[i] = (random_unit(5, i) - 0.5) * std::ldexp(1.0, static_cast<int>(i % 40));
    }
    return terms;
}

/// The sum with the blocks shared out to threads and the tree done by one.
double by_threads(const std::vector<double>& p, int threads) {
    std::vector<double> blocks((p.size() + sum_block - 1) / sum_block);
    parallel_for(blocks.size(), threads, [&](std::size_t k) {
        const std::size_t left = p.size() - k * sum_block;
        blocks[k] = ordered_block_sum(&p[k * sum_block], left < sum_block ? left : sum_block);
    });
    return tree_sum(blocks);
}

}  // namespace

TEST_CASE("sums of reciprocals have the published bits", "[ordered_sum]") {
    CHECK(ordered_sum(9, reciprocal) == 0x1.6a1ba1ba1ba1cp+1);
    CHECK(ordered_sum(256, reciprocal) == 0x1.87f544932e3e5p+2);
    CHECK(ordered_sum(257, reciprocal) == 0x1.883504d2ee7e1p+2);
    CHECK(ordered_sum(1000, reciprocal) == 0x1.df11f45f4e61ap+2);
    CHECK(ordered_sum(65537, reciprocal) == 0x1.755cecebf0aa9p+3);
    CHECK(ordered_sum(100000, reciprocal) == 0x1.82e27a22f3fb1p+3);
}

TEST_CASE("an empty sum and a sum of negative zeros are +0", "[ordered_sum]") {
    const auto negative_zero = [](std::size_t) { return -0.0; };
    CHECK_FALSE(std::signbit(ordered_sum(0, negative_zero)));
    CHECK_FALSE(std::signbit(ordered_sum(3, negative_zero)));
    CHECK_FALSE(std::signbit(tree_sum({})));
}

TEST_CASE("the sum of any number of terms follows the rule as it is written", "[ordered_sum]") {
    std::size_t different = 0;
    for (std::size_t n = 0; n < 9000; n += n < 600 ? 1 : 61) {
        const std::vector<double> terms = mixed_terms(n);
        const double sum = ordered_sum(n, [&](std::size_t i) { return terms[i]; });
        if (sum != as_written(terms)) ++different;
    }
    CHECK(different == 0);
}

TEST_CASE("a sum does not depend on the number of threads", "[ordered_sum]") {
    const std::vector<double> terms = mixed_terms(100003);
    const int threads = GENERATE(1, 2, 3, 7);
    CHECK(by_threads(terms, threads) == as_written(terms));
}
