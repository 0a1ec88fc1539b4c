#include "tests/platforms/named_hash.hpp"
#include "texunit/exact_math.hpp"
#include "texunit/mipmap.hpp"

namespace twofold::platforms {
namespace {

constexpr std::size_t arguments = 128;

/// 2^e, e in -1022..1023.
double power_of_two(int e) {
    return exact::detail::power_of_two(static_cast<std::uint64_t>(e + 1023));
}

template <class Function>
NamedHash over(const std::string& name, double low, double high, const Function& f) {
    return hash_over(name, arguments, [&](std::size_t i) { return f(real(i, 1, low, high)); });
}

/// A hash for each binade of either sign.
template <class Function>
Hashes over_binades(const char* name, int first, int last, const Function& f) {
    Hashes hashes;
    for (int e = first; e <= last; ++e) {
        const double low = power_of_two(e), high = 2.0 * low;
        hashes.push_back(over(fmt::format("{}/+2^{}", name, e), low, high, f));
        hashes.push_back(over(fmt::format("{}/-2^{}", name, e), -high, -low, f));
    }
    return hashes;
}

Hashes logarithm_hashes() {
    Hashes hashes;
    for (int e = -1020; e <= 1020; e += 60)
        hashes.push_back(
            over(fmt::format("log/2^{}", e), power_of_two(e), power_of_two(e + 1), exact::log));
    for (int e = -20; e < 0; e += 2) {
        const double d = power_of_two(e);
        hashes.push_back(over(fmt::format("log/1+-2^{}", e), 1.0 - d, 1.0 + d, exact::log));
        hashes.push_back(over(fmt::format("log2/1+-2^{}", e), 1.0 - d, 1.0 + d, log2_of));
    }
    hashes.push_back(over("log/denormal", 0.0, 0x1p-1030, exact::log));
    return hashes;
}

Hashes power_hashes() {
    constexpr std::array bases{1e-300, 1e-6, 0.01, 0.3, 0.999, 1.0, 3.0, 1e6};
    constexpr std::array exponents{-20.0, -1.0, 0.0, 0.5, 2.0, 20.0, 200.0, 1e5};
    Hashes hashes;
    for (std::size_t b = 0; b + 1 < bases.size(); ++b)
        for (std::size_t e = 0; e + 1 < exponents.size(); ++e)
            hashes.push_back(hash_over(
                fmt::format("pow/{}^{}", bases[b], exponents[e]), arguments, [&](std::size_t i) {
                    return exact::pow(real(i, 1, bases[b], bases[b + 1]),
                                      real(i, 2, exponents[e], exponents[e + 1]));
                }));
    return hashes;
}

}  // namespace

Hashes function_hashes() {
    Hashes hashes = over_binades("exp", -12, 9, exact::exp);
    append(hashes, over_binades("sin", -10, 19, exact::sin));
    append(hashes, over_binades("cos", -10, 19, exact::cos));
    append(hashes, over_binades("acos", -12, -1, exact::acos));
    append(hashes, logarithm_hashes());
    append(hashes, power_hashes());
    return hashes;
}

}  // namespace twofold::platforms
