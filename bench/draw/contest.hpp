#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "bench/draw/timing.hpp"

/// Renderers that draw the same work in turn, and their speeds in proportion.
namespace twofold::bench {

struct Contestant {
    std::string name;
    std::function<FrameTimes()> time;  ///< draws for a while
};

/// How many times the peer's speed is asked for.
struct Target {
    std::optional<double> floor, aim;
};

/// Two contestants by name, and what is wanted of the first.
struct Duel {
    std::string ours, peer;
    Target target{};
    bool wall = false;      ///< wall time instead of processor time
    double head_start = 1;  ///< the peer's time is divided by it
};

struct Contest {
    std::string work;
    double pixels = 0;  ///< of a frame that are covered
    std::vector<Contestant> contestants;
    std::vector<Duel> duels;
    int rounds = 5;
};

/// One duel's outcome. Of each round there is one time of each.
struct Row {
    std::string work;
    double pixels = 0;
    Duel duel;
    std::vector<double> ours, peer;  ///< seconds of a frame; `peer` is empty where it is absent
    double our_median = 0;           ///< processor seconds of a frame, where it is known

    double our_ns_per_pixel() const { return 1e9 * median(ours) / pixels; }
    double peer_ns_per_pixel() const { return 1e9 * median(peer) / pixels; }
    /// The peer's time over ours in each round: above 1 we are the faster.
    std::vector<double> ratios() const;
};

/// Whether a row meets `share` of its floor; true where there is none.
bool meets_floor(const Row& row, double share);

/// Lets all contestants draw in turn, round after round, and compares them as the duels say. A duel
/// with an absent peer gives a row of its own only where ours has none yet.
std::vector<Row> hold(const Contest& contest);

}  // namespace twofold::bench
