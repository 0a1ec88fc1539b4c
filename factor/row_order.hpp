#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "factor/sample_rows.hpp"

/// The order of the sample rows in memory. Views come spread over the sphere, so that each row
/// would touch texels far from those of the row before.
namespace twofold {

/// Rows that are put in order at a time, from the first sample on, so that samples may come in
/// batches and no list of all of them is needed.
inline constexpr std::size_t ordered_rows = std::size_t{1} << 17;

/// The rows [first, first + count) by runs of texels of map 2, in each by runs of texels of map 1,
/// else as they stand: neighbours then share values and sums that the first-level cache holds.
/// @return numbers below count, the row that comes first at the front
std::vector<std::uint32_t> order_of_rows(const SampleRows& rows, std::size_t first,
                                         std::size_t count, const MapShape& shape);

/// Puts values[first + order[k]] at first + k.
template <class Value>
void put_in_order(std::vector<Value>& values, std::size_t first,
                  std::span<const std::uint32_t> order) {
    std::vector<Value> moved;
    moved.reserve(order.size());
    for (const std::uint32_t k : order) moved.push_back(values[first + k]);
    for (std::size_t k = 0; k < moved.size(); ++k) values[first + k] = moved[k];
}
void put_in_order(SampleRows& rows, std::size_t first, std::span<const std::uint32_t> order);

}  // namespace twofold
