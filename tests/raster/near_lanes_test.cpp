#include <catch2/catch.hpp>

#include "raster/vector_width.hpp"
#include "tests/raster/builders.hpp"
#include "texunit/presets.hpp"

namespace {
using namespace twofold;
using namespace twofold::test;

/// One triangle over the whole picture, so that tiles' rows are full from end to end. Coordinates
/// leave the texture at all sides; q is the same everywhere, or grows from corner to corner.
Mesh cover(int width, int height, double q1, double q2) {
    Mesh mesh = triangles({{0, 2.0 * height, 0}, {2.0 * width, 0, 0}, {0, 0, 0}});
    mesh.texcoords[0] = {{-0.3, 2.2, 0, 1}, {2.4 * q1, -0.2 * q1, 0, q1}, {-0.3, -0.2, 0, 1}};
    mesh.texcoords[1] = {{-0.3, 2.2, 0, 1}, {2.4 * q2, -0.2 * q2, 0, q2}, {-0.3, -0.2, 0, 1}};
    return mesh;
}

Frame covered(int width, int height, double q1, double q2, int units, Filter filter) {
    PassState state;
    for (int u = 0; u < units; ++u) {
        const auto k = static_cast<std::size_t>(u);
        state.units[k].emplace();
        state.units[k]->texture = k;
        state.units[k]->min_filter = state.units[k]->mag_filter = filter;
    }
    Frame frame = pixel_frame(width, height, cover(width, height, q1, q2), state);
    frame.textures = {{64, 32, noise(64, 32)}, {16, 128, noise(16, 128)}};
    return frame;
}

}  // namespace

TEST_CASE("Rows that a triangle fills have the reference's bytes, whatever their length") {
    for (const char* const vectors : {"baseline", "sse4", "avx2", "avx3"}) {
        limit_vectors(vectors);
        for (const int width : {15, 16, 17, 31, 63, 64, 65, 79, 80, 127, 128, 129, 197})
            for (const int units : {1, 2})
                for (const Filter filter : {Filter::nearest, Filter::linear}) {
                    INFO(vectors << ", " << width << " wide, " << units << " units");
                    CHECK(same_pictures(covered(width, 11, 1.0, 3.0, units, filter), Preset::nv17));
                }
    }
}

TEST_CASE("Units with the same q, others, and such as cannot be multiplied fill rows alike") {
    for (const auto& [q1, q2] : {std::pair{1.0, 1.0}, {3.0, 3.0}, {0.4, 5.0}, {1e-20, 3.0}})
        for (const Preset preset : {Preset::nv17, Preset::nv2x}) {
            INFO(q1 << ", " << q2);
            CHECK(same_pictures(covered(150, 140, q1, q2, 2, Filter::linear), preset));
        }
}
