#include "texunit/parallel.hpp"

#include <atomic>
#include <catch2/catch.hpp>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

using twofold::parallel_for;

TEST_CASE("every index is visited once at any number of threads", "[parallel]") {
    const int threads = GENERATE(-1, 0, 1, 2, 3, 7);
    const std::size_t count = GENERATE(0u, 1u, 2u, 1000u);
    std::vector<int> visits(count, 0);
    parallel_for(count, threads, [&](std::size_t i) { ++visits[i]; });
    CHECK(visits == std::vector<int>(count, 1));
}

TEST_CASE("seven threads are seven threads even on a smaller machine", "[parallel]") {
    std::mutex mutex;
    std::set<std::thread::id> seen;
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    // Each body waits until seven threads have come, so that no thread can do the work of another.
    parallel_for(7, 7, [&](std::size_t) {
        for (;;) {
            {
                const std::lock_guard lock(mutex);
                seen.insert(std::this_thread::get_id());
                if (seen.size() == 7) return;
            }
            if (std::chrono::steady_clock::now() > deadline) return;
            std::this_thread::yield();
        }
    });
    CHECK(seen.size() == 7);
}

TEST_CASE("one thread means the caller's, in ascending order", "[parallel]") {
    std::vector<std::size_t> order;
    bool elsewhere = false;
    const auto caller = std::this_thread::get_id();
    parallel_for(5, 1, [&](std::size_t i) {
        order.push_back(i);
        elsewhere = elsewhere || std::this_thread::get_id() != caller;
    });
    CHECK(order == std::vector<std::size_t>{0, 1, 2, 3, 4});
    CHECK_FALSE(elsewhere);
}

TEST_CASE("an exception in a body reaches the caller", "[parallel]") {
    const int threads = GENERATE(1, 2, 7);
    const auto fail_at_50 = [](std::size_t i) {
        if (i == 50) throw std::runtime_error("fifty");
    };
    CHECK_THROWS_WITH(parallel_for(100, threads, fail_at_50), "fifty");
}

TEST_CASE("loops may be nested", "[parallel]") {
    std::atomic<int> calls = 0;
    parallel_for(8, 2, [&](std::size_t) { parallel_for(8, 2, [&](std::size_t) { ++calls; }); });
    CHECK(calls == 64);
}
