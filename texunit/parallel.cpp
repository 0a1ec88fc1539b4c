#include "texunit/parallel.hpp"

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <optional>

namespace twofold {
namespace {

/// oneTBB has one worker per processor unless told otherwise; more are wanted only to show that
/// results do not depend on their number.
std::optional<tbb::global_control> more_workers(int threads) {
    if (threads <= tbb::info::default_concurrency()) return std::nullopt;
    return std::make_optional<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                   static_cast<std::size_t>(threads));
}

}  // namespace

void parallel_for(std::size_t count, int threads, const std::function<void(std::size_t)>& body) {
    if (threads == 1 || count <= 1) {
        for (std::size_t i = 0; i < count; ++i) body(i);
        return;
    }
    const auto loop = [&] { tbb::parallel_for(std::size_t{0}, count, body); };
    // Workers stay in the arena that is there already; they come to one that is made for a call
    // some 10 us late. Isolated, a thread that waits takes no body of an outer call.
    if (threads <= 0 || threads == tbb::info::default_concurrency())
        return tbb::this_task_arena::isolate(loop);
    const auto workers = more_workers(threads);
    tbb::task_arena(threads).execute(loop);
}

}  // namespace twofold
