#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "bench/draw/child.hpp"
#include "bench/draw/peers.hpp"
#include "bench/draw/report.hpp"
#include "texunit/error.hpp"

using namespace twofold;
using namespace twofold::bench;

namespace {

/// One that always takes as long.
Contestant steady(const std::string& name, double cpu, double wall) {
    return {name, [=] { return FrameTimes{cpu, cpu, wall}; }};
}

Contest contest() {
    return {
        "work",
        1e6,
        {steady("ours", 0.002, 0.004), steady("alone", 0.001, 0.001), steady("peer", 0.006, 0.006)},
        {{"ours", "peer", {2.0, 4.0}},
         {"ours", "peer", {}, true},
         {"ours", "peer", {}, false, 2.0},
         {"ours", "absent"},
         {"alone", "absent", {2.0, {}}},
         {"absent", "peer"}},
        3};
}

}  // namespace

TEST_CASE("A contest gives for each duel the peer's time over ours") {
    const std::vector<Row> rows = hold(contest());
    REQUIRE(rows.size() == 4);
    CHECK(rows[0].our_ns_per_pixel() == Approx(2.0));
    CHECK(rows[0].ratios() == std::vector<double>(3, 0.006 / 0.002));
    CHECK(median(rows[1].ratios()) == Approx(1.5));
    CHECK(median(rows[2].ratios()) == Approx(1.5));
    CHECK(rows[3].peer.empty());
}

TEST_CASE("A floor is missed only by a peer that is there") {
    std::vector<Row> rows = hold(contest());
    CHECK(meets_floor(rows[0], 1.0));
    CHECK(meets_floor(rows[3], 1.0));
    rows[0].duel.target.floor = 5.0;
    CHECK_FALSE(meets_floor(rows[0], 1.0));
    CHECK(meets_floor(rows[0], 0.5));
}

TEST_CASE("The median of an even number of values is the mean of the middle two") {
    CHECK(median({3.0, 1.0, 2.0}) == 2.0);
    CHECK(median({4.0, 1.0, 2.0, 3.0}) == 2.5);
}

TEST_CASE("The slope of a series is what one more unit costs") {
    const Series series{"work", "pixel", {{100, 2.0}, {300, 3.0}}};
    CHECK(series.slope(1) == Approx(0.005));
}

TEST_CASE("The best kernel is the fastest checked one in perspective at 1024") {
    const std::string printed =
        "core clock 3.00 GHz (dependent additions)\n"
        "AVX2 gather32        persp   1024     4.100     12.00      90.0     same\n"
        "AVX-512 pairs,load   persp   1024     3.500     10.00     100.0     same\n"
        "AVX-512 no fetch     persp   1024     1.000      3.00     900.0        -\n"
        "SSE2 one pixel       persp   1024     0.100      3.00     900.0  DIFFERS\n"
        "AVX-512 pairs,load  affine   1024     2.500     10.00     100.0     same\n"
        "AVX-512 pairs,load   persp    512     2.500     10.00     100.0     same\n";
    CHECK(best_kernel(printed) == Approx(3.5e-9));
    CHECK_THROWS_AS(best_kernel("nothing"), Error);
}

TEST_CASE("The report is a table between two markers and a JSON document") {
    const DrawReport report{
        "machine", {}, hold(contest()), {}, {{"memory", "MiB", 3.0, {64.0, {}}}}};
    const std::string table = markdown_of(report);
    CHECK_THAT(table, Catch::Contains("| work | ours | 2.000 | peer | 6.000 | 3.00 | 3.00-3.00 | "
                                      "2.00 | 4.00 | floor |"));
    const std::string document =
        "before\n<!-- bench_draw: begin -->\nold\n<!-- bench_draw: end -->\nafter\n";
    CHECK(with_table(document, "new\n", "file") ==
          "before\n<!-- bench_draw: begin -->\nnew\n<!-- bench_draw: end -->\nafter\n");
    CHECK_THROWS_WITH(with_table("no marker", "new", "file"), Catch::Contains("file: no line"));
    const auto json = nlohmann::json::parse(json_of(report));
    CHECK(json["rows"][0]["ratio"] == Approx(3.0));
    CHECK_FALSE(json["rows"][3].contains("peer"));
    CHECK(json["figures"][0]["most"]["floor"] == 64.0);
}

TEST_CASE("A child gives its output, and an error if it fails") {
    const ChildResult child =
        run_child({"/bin/sh", "-c", "echo $TWOFOLD_TEST"}, {{"TWOFOLD_TEST", "heard"}});
    CHECK(child.output == "heard\n");
    CHECK(child.wall > 0.0);
    CHECK_THROWS_WITH(run_child({"/no/such/program"}), Catch::Contains("/no/such/program"));
    CHECK_THROWS_WITH(run_child({"/bin/sh", "-c", "exit 3"}), Catch::Contains("exit code 3"));
    CHECK_THROWS_WITH(run_child({"/bin/sh", "-c", "kill -9 $$"}), Catch::Contains("signal 9"));
}
