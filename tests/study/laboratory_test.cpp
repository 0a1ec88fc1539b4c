#include "study/sweep/laboratory.hpp"

#include <catch2/catch.hpp>

#include "sweep_fixtures.hpp"

using namespace twofold;

namespace {

constexpr int samples = 4000;

/// A small gold-suzanne with the changes.
Cell small_cell(const std::string& change) {
    return make_cell(read_source(shipped_scene("gold-suzanne.json")),
                     {"image.width=48", "image.height=36", "presets=[\"nv17\"]",
                      "factorization.map_size=8", "factorization.held_out=200",
                      "environment.cells=2048", "factorization.samples=4000", change});
}

/// One whose common cell is this one.
Laboratory laboratory_of(const Cell& anchor) {
    return {anchor, samples, {0.0, 1, 1}, 1, [](const std::string&) {}};
}

/// What was found, but for the times.
std::string findings_of(Laboratory& laboratory, const Cell& cell) {
    auto result = laboratory.measure(cell).result;
    result.erase("times");
    return result.dump();
}

}  // namespace

TEST_CASE("a cell's findings do not depend on the cells that were measured before it", "[long]") {
    Laboratory shared = laboratory_of(small_cell("factorization.terms=1"));
    for (const char* change :
         {"factorization.model=slf", "factorization.map_form=sphere",
          "factorization.lighting_sum=full", "factorization.lighting_tolerance=0.5",
          "factorization.surface_rows=texels", "white.percentile=50"}) {
        CAPTURE(change);
        const Cell cell = small_cell(change);
        Laboratory alone = laboratory_of(cell);
        CHECK(findings_of(shared, cell) == findings_of(alone, cell));
    }
}
