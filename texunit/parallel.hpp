#pragma once
#include <cstddef>
#include <functional>

namespace twofold {

/// Calls body(0) ... body(count - 1), each once, in any order, on up to `threads` threads; all of
/// the machine for threads <= 0. Bodies must not share what they write: let each own a block, a
/// tile or a column, and add up afterwards (texunit/ordered_sum.hpp), so that results do not depend
/// on the number of threads.
/// @throws the first exception that a body threw; bodies not yet begun may then be left out
void parallel_for(std::size_t count, int threads, const std::function<void(std::size_t)>& body);

}  // namespace twofold
