#include "texunit/parallel.hpp"

#ifndef __wasi__
#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>
#endif

/// In place of texunit/parallel.cpp where there is no oneTBB: plain threads, which take the next
/// number that no other took. Where there are no threads either, one does all.
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
    std::vector<std::thread> others;
    const auto wanted = threads > 0 ? static_cast<std::size_t>(threads) : std::size_t{2};
    for (std::size_t k = 1; k < std::min(wanted, count); ++k) others.emplace_back(work);
    work();
    for (std::thread& other : others) other.join();
}
#endif

}  // namespace twofold
