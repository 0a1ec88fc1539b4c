#include "bench/draw/contest.hpp"

#include <algorithm>
#include <map>

namespace twofold::bench {
namespace {

using Rounds = std::map<std::string, std::vector<FrameTimes>>;

Rounds draw_in_turn(const Contest& contest) {
    Rounds rounds;
    for (int round = 0; round < contest.rounds; ++round)
        for (const Contestant& c : contest.contestants) rounds[c.name].push_back(c.time());
    return rounds;
}

std::vector<double> seconds_of(const Rounds& rounds, const std::string& name, bool wall,
                               double divisor) {
    std::vector<double> seconds;
    if (const auto found = rounds.find(name); found != rounds.end())
        for (const FrameTimes& t : found->second)
            seconds.push_back((wall ? t.wall : t.cpu) / divisor);
    return seconds;
}

double cpu_median(const Rounds& rounds, const std::string& name) {
    std::vector<double> medians;
    for (const FrameTimes& t : rounds.at(name)) medians.push_back(t.cpu_median);
    return median(medians);
}

bool has_row_of(const std::vector<Row>& rows, const std::string& ours) {
    return std::any_of(rows.begin(), rows.end(),
                       [&](const Row& row) { return row.duel.ours == ours; });
}

}  // namespace

std::vector<double> Row::ratios() const {
    std::vector<double> result;
    for (std::size_t i = 0; i < peer.size(); ++i) result.push_back(peer[i] / ours[i]);
    return result;
}

bool meets_floor(const Row& row, double share) {
    const auto& floor = row.duel.target.floor;
    return !floor || row.peer.empty() || median(row.ratios()) >= share * *floor;
}

std::vector<Row> hold(const Contest& contest) {
    const Rounds rounds = draw_in_turn(contest);
    std::vector<Row> rows;
    for (const Duel& d : contest.duels) {
        if (!rounds.contains(d.ours)) continue;
        if (!rounds.contains(d.peer) && has_row_of(rows, d.ours)) continue;
        rows.push_back({contest.work, contest.pixels, d, seconds_of(rounds, d.ours, d.wall, 1.0),
                        seconds_of(rounds, d.peer, d.wall, d.head_start),
                        cpu_median(rounds, d.ours)});
    }
    return rows;
}

}  // namespace twofold::bench
