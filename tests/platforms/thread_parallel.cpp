#include "texunit/parallel.hpp"

#ifndef __wasi__
#include <algorithm>
#include <atomic>
#include <future>
#include <vector>
#endif

/// In place of texunit/parallel.cpp where there is no oneTBB: plain threads, which take the next
/// number that no other took; an exception reaches the caller. Where there are no threads either,
/// one does all.
namespace twofold {

#ifdef __wasi__
void parallel_for(std::size_t count, int, const std::function<void(std::size_t)>& body) {
    for (std::size_t i = 0; i < count; ++i) body(i);
}
#else
void parallel_for(std::size_t count, int threads, const std::function<void(std::size_t)>& body) {
    std::atomic<std::size_t> next{0};
    const auto work = [&] {
        for (std::size_t i = next++; i < count; i = next++) body(i);
    };
    std::vector<std::future<void>> others;  // which wait where an exception ends the loop early
    const auto wanted = threads > 0 ? static_cast<std::size_t>(threads) : std::size_t{2};
    for (std::size_t k = 1; k < std::min(wanted, count); ++k)
        others.push_back(std::async(std::launch::async, work));
    work();
    for (std::future<void>& other : others) other.get();
}
#endif

}  // namespace twofold
