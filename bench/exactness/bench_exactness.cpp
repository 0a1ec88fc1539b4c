// What exactness costs: each work with a rule and without, in turn, as the ratio of their processor
// times: bench_exactness [--markdown FILE]
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string_view>

#include "bench/draw/report.hpp"
#include "bench/draw/timing.hpp"
#include "bench/exactness/free_sum.hpp"
#include "bench/exactness/work.hpp"
#include "factor/vector_arithmetic.hpp"
#include "texunit/atomic_file.hpp"
#include "texunit/error.hpp"
#include "texunit/exact_math.hpp"
#include "texunit/random.hpp"

namespace {

using namespace twofold;

std::vector<double> numbers(std::size_t n, std::uint64_t seed, double low, double high) {
    std::vector<double> values(n);
    for (std::size_t i = 0; i < n; ++i) values[i] = low + (high - low) * random_unit(seed, i);
    return values;
}

template <class Function>
price::Work loop(const char* name, const std::vector<double>& x, const Function& f) {
    return {name, [x, f, y = std::vector<double>(x.size())]() mutable {
                for (std::size_t i = 0; i < x.size(); ++i) y[i] = f(x[i]);
            }};
}

std::vector<price::Pair> contraction() {
    std::vector<price::Work> exact = twofold_exact::works(), fused = twofold_fused::works();
    std::vector<price::Pair> pairs;
    for (std::size_t i = 0; i < exact.size(); ++i)
        pairs.push_back({"contraction off, against on", exact[i], fused[i]});
    return pairs;
}

std::vector<price::Pair> own_functions() {
    constexpr const char* rule = "own functions, against libm's";
    const auto e = numbers(4096, 1, -20.0, 5.0), l = numbers(4096, 1, 1e-4, 4.0);
    const auto p = numbers(4096, 1, 0.3, 1.0), s = numbers(4096, 1, -6.4, 6.4);
    const auto a = numbers(4096, 1, -1.0, 1.0);
    return {
        {rule, loop("exp", e, exact::exp), loop("", e, [](double x) { return std::exp(x); })},
        {rule, loop("log", l, exact::log), loop("", l, [](double x) { return std::log(x); })},
        {rule, loop("pow", p, [](double x) { return exact::pow(x, 20.5); }),
         loop("", p, [](double x) { return std::pow(x, 20.5); })},
        {rule, loop("sin", s, exact::sin), loop("", s, [](double x) { return std::sin(x); })},
        {rule, loop("cos", s, exact::cos), loop("", s, [](double x) { return std::cos(x); })},
        {rule, loop("acos", a, exact::acos), loop("", a, [](double x) { return std::acos(x); })}};
}

/// Enough sums that a call takes some microseconds.
template <class Sum>
price::Work sums(const std::string& name, std::size_t n, const Sum& sum) {
    return {name, [a = numbers(n, 1, -1.0, 1.0), b = numbers(n, 2, -1.0, 1.0), sum,
                   kept = 0.0]() mutable {
                for (std::size_t k = 0; k < 1 + 4096 / a.size(); ++k) kept += sum(a, b);
                if (kept == 0x1p-1000) std::cout << "";  // the sums are wanted
            }};
}

std::vector<price::Pair> fixed_order() {
    const auto free = [](const std::vector<double>& a, const std::vector<double>& b) {
        return price::free_sum(a.data(), b.data(), a.size());
    };
    const auto sequential = [](const std::vector<double>& a, const std::vector<double>& b) {
        return price::sequential_sum(a.data(), b.data(), a.size());
    };
    std::vector<price::Pair> pairs;
    for (const std::size_t n : {100u, 1000u, 100000u, 4000000u}) {
        const price::Work ordered =
            sums(fmt::format("dot product of {}", n), n,
                 [](const Vector& a, const Vector& b) { return dot(a, b); });
        pairs.push_back({"fixed order, against any", ordered, sums("", n, free)});
        pairs.push_back({"fixed order, against left to right", ordered, sums("", n, sequential)});
    }
    return pairs;
}

/// The proportions of several rounds, in each of which both run.
std::vector<double> ratios(const price::Pair& pair) {
    std::vector<double> all;
    for (int round = 0; round < 7; ++round) {
        const double with = bench::time_frames(pair.with.run, 0.05, 3).cpu;
        all.push_back(with / bench::time_frames(pair.without.run, 0.05, 3).cpu);
    }
    return all;
}

std::string row_of(const price::Pair& pair) {
    const std::vector<double> all = ratios(pair);
    const auto [least, most] = std::minmax_element(all.begin(), all.end());
    return fmt::format("| {} | {} | {:.2f} | {:.2f}-{:.2f} |\n", pair.rule, pair.with.name,
                       bench::median(all), *least, *most);
}

void run(const std::string& markdown) {
    std::string table = "| rule | work | time with / without | spread |\n|---|---|---|---|\n";
    for (const auto& pairs : {contraction(), own_functions(), fixed_order()})
        for (const price::Pair& pair : pairs) {
            const std::string row = row_of(pair);
            std::cout << row << std::flush;
            table += row;
        }
    if (markdown.empty()) return;
    const std::string document = read_text_file(markdown, 1 << 20);
    write_file_atomically(markdown,
                          bench::with_table(document, table, markdown, "bench_exactness"));
}

}  // namespace

int main(int argc, char** argv) try {
    const bool has_file = argc == 3 && std::string_view(argv[1]) == "--markdown";
    if (argc != 1 && !has_file) {
        std::cerr << "usage: bench_exactness [--markdown FILE]\n";
        return 2;
    }
    run(has_file ? argv[2] : "");
    return 0;
} catch (const std::exception& e) {
    std::cerr << "bench_exactness: " << e.what() << "\n";
    return 2;
}
