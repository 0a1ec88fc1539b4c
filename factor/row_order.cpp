#include "factor/row_order.hpp"

#include <numeric>

namespace twofold {

namespace {

/// Texels of a run in map 1 and 2: values and sums of both are 24 KiB.
constexpr std::array<std::uint32_t, 2> run_texels{128, 256};

/// The order sorted by a key below `keys`; rows of one key keep theirs.
template <class Key>
std::vector<std::uint32_t> sorted_by(const std::vector<std::uint32_t>& order, std::size_t keys,
                                     const Key& key) {
    std::vector<std::uint32_t> next(keys + 1);
    for (const std::uint32_t k : order) ++next[key(k) + 1];
    std::partial_sum(next.begin(), next.end(), next.begin());
    std::vector<std::uint32_t> sorted(order.size());
    for (const std::uint32_t k : order) sorted[next[key(k)]++] = k;
    return sorted;
}

}  // namespace

std::vector<std::uint32_t> order_of_rows(const SampleRows& rows, std::size_t first,
                                         std::size_t count, const MapShape& shape) {
    std::vector<std::uint32_t> order(count);
    std::iota(order.begin(), order.end(), std::uint32_t{0});
    for (std::size_t map = 0; map < 2; ++map) {
        const auto start = static_cast<std::uint32_t>(map * shape.texels());
        order = sorted_by(order, shape.texels() / run_texels[map] + 1, [&](std::uint32_t k) {
            return (rows.texel[map][first + k] - start) / run_texels[map];
        });
    }
    return order;
}

void put_in_order(SampleRows& rows, std::size_t first, std::span<const std::uint32_t> order) {
    for (auto& texels : rows.texel) put_in_order(texels, first, order);
    for (auto& fractions : rows.fraction) put_in_order(fractions, first, order);
    if (rows.knot.empty()) return;
    put_in_order(rows.knot, first, order);
    put_in_order(rows.knot_fraction, first, order);
}

}  // namespace twofold
