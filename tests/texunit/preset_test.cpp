#include "texunit/preset.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <fstream>
#include <iterator>
#include <string>

#include "texunit/presets.hpp"

namespace {
using namespace twofold;
}

TEST_CASE("every preset states a rule and its source for the same 19 stages", "[preset]") {
    for (const Preset preset : all_presets) {
        CAPTURE(name_of(preset));
        const auto rules = stage_rules(preset);
        REQUIRE(rules.size() == 19);
        for (std::size_t i = 0; i < rules.size(); ++i) {
            CHECK(rules[i].stage == stage_rules(Preset::ideal64)[i].stage);
            CHECK_FALSE(rules[i].rule.empty());
            CHECK_FALSE(rules[i].source.empty());
        }
        const MarkCounts n = count_marks(preset);
        CHECK(n.sourced + n.inferred + n.chosen == 19);
    }
}

TEST_CASE("preset nv17 stands on 7 sourced, 4 inferred and 8 chosen stages", "[preset]") {
    const MarkCounts n = count_marks(Preset::nv17);
    CHECK(n.sourced == 7);
    CHECK(n.inferred == 4);
    CHECK(n.chosen == 8);
    CHECK(exactness_sentence(Preset::nv17) ==
          "bit-exact to preset nv17 v2: 7 stages sourced, 4 inferred, 8 chosen");
}

TEST_CASE("the marks of preset nv17 are those of the hardware reference, stage by stage",
          "[preset]") {
    using enum Mark;
    const std::array<Mark, 19> expected{
        spec,   spec, spec,   chosen,   inferred, chosen,   chosen, inferred, chosen, chosen,
        chosen, spec, chosen, inferred, spec,     inferred, spec,   spec,     chosen};
    const auto rules = stage_rules(Preset::nv17);
    REQUIRE(rules.size() == expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
        CAPTURE(i + 1, rules[i].stage);
        CHECK(rules[i].mark == expected[i]);
    }
}

TEST_CASE("preset nv2x stands on what captures settle, but for its general combiners", "[preset]") {
    using enum Mark;
    const std::array<Mark, 19> expected{inferred, measured, measured, spec,     spec,
                                        measured, measured, measured, measured, measured,
                                        measured, measured, chosen,   measured, measured,
                                        spec,     measured, measured, chosen};
    const auto rules = stage_rules(Preset::nv2x);
    REQUIRE(rules.size() == expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
        CAPTURE(i + 1, rules[i].stage);
        CHECK(rules[i].mark == expected[i]);
    }
    CHECK(exactness_sentence(Preset::nv2x) ==
          "bit-exact to preset nv2x v2: 16 stages sourced, 1 inferred, 2 chosen");
}

TEST_CASE("only nv2x claims measurements: nothing public was measured on the others", "[preset]") {
    for (const Preset preset : all_presets) {
        const bool claims = std::ranges::any_of(
            stage_rules(preset), [](const StageRule& r) { return r.mark == Mark::measured; });
        CHECK(claims == (preset == Preset::nv2x));
    }
}

TEST_CASE("custom is a preset with a table, but not one of the fixed ones", "[preset]") {
    CHECK(std::ranges::find(all_presets, Preset::custom) == all_presets.end());
    CHECK(preset_named("custom") == Preset::custom);
    CHECK(name_of(Preset::custom) == "custom");
    CHECK(version_of(Preset::custom) == 3);
    REQUIRE(stage_rules(Preset::custom).size() == 19);
    for (std::size_t i = 0; i < 19; ++i)
        CHECK(stage_rules(Preset::custom)[i].stage == stage_rules(Preset::ideal64)[i].stage);
    CHECK(count_marks(Preset::custom).chosen == 19);
    CHECK(with_model(Preset::custom, []<class M>(const M&) { return M::preset; }) ==
          Preset::custom);
}

TEST_CASE("a preset is found by its name and by nothing else", "[preset]") {
    for (const Preset preset : all_presets) CHECK(preset_named(name_of(preset)) == preset);
    CHECK_FALSE(preset_named("geforce4"));
    CHECK_FALSE(preset_named(""));
    CHECK_FALSE(preset_named("NV17"));
}

TEST_CASE("each preset's numeric model carries that preset's name", "[preset]") {
    for (const Preset preset : all_presets)
        CHECK(with_model(preset, []<class M>(const M&) { return M::preset; }) == preset);
}

TEST_CASE("marks have the names that reports print", "[preset]") {
    CHECK(name_of(Mark::spec) == "spec");
    CHECK(name_of(Mark::measured) == "measured");
    CHECK(name_of(Mark::inferred) == "inferred");
    CHECK(name_of(Mark::chosen) == "chosen");
}

TEST_CASE("docs/hardware.md holds the table and the counts of every preset", "[preset]") {
    std::ifstream file(std::string(TWOFOLD_SOURCE_DIR) + "/docs/hardware.md");
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    std::vector<Preset> presets(all_presets.begin(), all_presets.end());
    presets.push_back(Preset::custom);
    for (const Preset preset : presets) {
        CAPTURE(name_of(preset));
        const auto begin =
            text.find(fmt::format("### {} v{}\n", name_of(preset), version_of(preset)));
        REQUIRE(begin != std::string::npos);
        const std::string section = text.substr(begin, text.find("\n##", begin + 3) - begin);
        for (const StageRule& r : stage_rules(preset))
            CHECK(section.find(fmt::format("| {} | {} | {} | {} |\n", r.stage, r.rule,
                                           name_of(r.mark), r.source)) != std::string::npos);
        const MarkCounts n = count_marks(preset);
        CHECK(section.find(fmt::format("{} sourced, {} inferred, {} chosen.", n.sourced, n.inferred,
                                       n.chosen)) != std::string::npos);
    }
}
