#pragma once
#include <array>
#include <string_view>
#include <vector>

/// Enumerators and their names, as tables.
namespace twofold::scene_io {

template <class E>
struct Named {
    std::string_view name;
    E value;
};
template <class E>
Named(std::string_view, E) -> Named<E>;  // clang 14 does not deduce aggregates

template <class E, std::size_t N>
std::vector<std::string_view> names_of(const std::array<Named<E>, N>& names) {
    std::vector<std::string_view> result;
    for (const Named<E>& entry : names) result.push_back(entry.name);
    return result;
}

template <class E, std::size_t N>
std::string_view name_in(const std::array<Named<E>, N>& names, E value) {
    for (const Named<E>& entry : names)
        if (entry.value == value) return entry.name;
    return {};
}

}  // namespace twofold::scene_io
