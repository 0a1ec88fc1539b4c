#pragma once
#include <cstddef>
#include <initializer_list>
#include <vector>

#include "texunit/random.hpp"

namespace twofold::test {

/// Throws of one state's own dice: they depend on the seed, the state's number and how many were
/// thrown before. An argument list must not hold two of them (docs/exactness.md, E07); braces may.
class Dice {
  public:
    Dice(std::uint64_t seed, std::uint64_t state) : seed_(random_u64(seed, state)) {}

    std::uint64_t bits() { return random_u64(seed_, thrown_++); }
    /// In [0, 1).
    double unit() { return random_unit(seed_, thrown_++); }
    double real(double low, double high) { return low + (high - low) * unit(); }
    /// From low to high, both included.
    int integer(int low, int high) {
        return low + static_cast<int>(bits() % static_cast<std::uint64_t>(high - low + 1));
    }
    std::size_t index(std::size_t size) { return static_cast<std::size_t>(bits() % size); }
    bool chance(double probability) { return unit() < probability; }

    /// An enumerator from the first, which is 0, to `last`.
    template <class E>
    E up_to(E last) {
        return static_cast<E>(integer(0, static_cast<int>(last)));
    }
    template <class T>
    T one_of(std::initializer_list<T> values) {
        return *(values.begin() + index(values.size()));
    }
    template <class T>
    const T& element(const std::vector<T>& values) {
        return values[index(values.size())];
    }

  private:
    std::uint64_t seed_;
    std::uint64_t thrown_ = 0;
};

}  // namespace twofold::test
