#include "raster/primitive.hpp"

#include <catch2/catch.hpp>

using namespace twofold;

namespace {

struct Expected {
    Primitive primitive;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<std::uint32_t> provoking_last, provoking_first;
};

const std::vector<std::uint32_t> six{10, 11, 12, 13, 14, 15};

const std::vector<Expected> table{
    {Primitive::triangles, {{10, 11, 12}, {13, 14, 15}}, {12, 15}, {10, 13}},
    {Primitive::triangle_strip,
     {{10, 11, 12}, {12, 11, 13}, {12, 13, 14}, {14, 13, 15}},
     {12, 13, 14, 15},
     {10, 11, 12, 13}},
    {Primitive::triangle_fan,
     {{10, 11, 12}, {10, 12, 13}, {10, 13, 14}, {10, 14, 15}},
     {12, 13, 14, 15},
     {11, 12, 13, 14}},
    {Primitive::polygon,
     {{10, 11, 12}, {10, 12, 13}, {10, 13, 14}, {10, 14, 15}},
     {10, 10, 10, 10},
     {10, 10, 10, 10}},
    {Primitive::quads, {{10, 11, 12}, {10, 12, 13}}, {13, 13}, {13, 13}},
    {Primitive::quad_strip,
     {{10, 11, 12}, {12, 11, 13}, {12, 13, 14}, {14, 13, 15}},
     {13, 13, 15, 15},
     {13, 13, 15, 15}},
};

}  // namespace

TEST_CASE("primitives are split and coloured as the table says") {
    for (const Expected& e : table)
        for (const auto convention : {ProvokingVertex::last, ProvokingVertex::first}) {
            const auto found = assemble(e.primitive, six, convention);
            const auto& provoking =
                convention == ProvokingVertex::last ? e.provoking_last : e.provoking_first;
            REQUIRE(found.size() == e.triangles.size());
            for (std::size_t k = 0; k < found.size(); ++k) {
                CAPTURE(static_cast<int>(e.primitive), k);
                CHECK(found[k].vertex == e.triangles[k]);
                CHECK(found[k].provoking == provoking[k]);
            }
        }
}

TEST_CASE("too few vertices draw nothing") {
    for (const Expected& e : table) {
        const std::size_t wanted =
            e.primitive == Primitive::quads || e.primitive == Primitive::quad_strip ? 4 : 3;
        const std::vector<std::uint32_t> few(six.begin(),
                                             six.begin() + static_cast<std::ptrdiff_t>(wanted) - 1);
        CHECK(assemble(e.primitive, few, ProvokingVertex::last).empty());
        CHECK(assemble(e.primitive, {}, ProvokingVertex::last).empty());
    }
}
