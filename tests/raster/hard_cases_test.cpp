#include <algorithm>
#include <catch2/catch.hpp>
#include <cfenv>
#include <limits>
#include <numeric>
#include <set>

#include "raster/clip.hpp"
#include "raster/coverage.hpp"
#include "raster/frame_check.hpp"
#include "tests/raster/builders.hpp"
#include "texunit/error.hpp"

/// The raster cases of docs/hard-cases.md that need no tiles and no fused passes.
namespace {
using namespace twofold;
using namespace twofold::test;
__extension__ using Int128 = __int128;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// Twice the signed area of (a, b, p), in integers that cannot overflow.
Int128 side(WindowPoint a, WindowPoint b, WindowPoint p) {
    return Int128{b.x - a.x} * (p.y - a.y) - Int128{b.y - a.y} * (p.x - a.x);
}

/// The fill rule said differently: the sample lies inside once it is moved right by an
/// infinitesimal and down by an infinitesimal of that.
bool inside_after_nudge(WindowPoint a, WindowPoint b, WindowPoint p) {
    const Int128 e = side(a, b, p);
    if (e != 0) return e > 0;
    const std::int64_t along_x = -(b.y - a.y), along_y = b.x - a.x;
    return along_x != 0 ? along_x > 0 : along_y > 0;
}

bool reference_covers(std::array<WindowPoint, 3> t, WindowPoint p) {
    if (side(t[0], t[1], t[2]) == 0) return false;
    if (side(t[0], t[1], t[2]) < 0) std::swap(t[1], t[2]);
    return inside_after_nudge(t[0], t[1], p) && inside_after_nudge(t[1], t[2], p) &&
           inside_after_nudge(t[2], t[0], p);
}

bool covers(const TriangleSetup& t, WindowPoint p) {
    return std::ranges::all_of(t.edge, [p](const EdgeFunction& e) { return e.covers(e.at(p)); });
}

/// How often each pixel of a small target is covered by a set of triangles in 1/16 pixel.
struct CountMap {
    int width, height;
    std::vector<int> count = std::vector<int>(static_cast<std::size_t>(width * height), 0);

    void draw(const std::array<WindowPoint, 3>& p) {
        const TriangleSetup t = set_up(p);
        if (t.doubled_area == 0) return;
        for_each_covered_pixel(t, 4, {0, 0, width, height},
                               [&](int x, int y, const auto&) { ++at(x, y); });
    }
    int& at(int x, int y) { return count[static_cast<std::size_t>(y * width + x)]; }
};

WindowPoint operator-(WindowPoint a, WindowPoint b) { return {a.x - b.x, a.y - b.y}; }

/// A star-shaped polygon around `centre`: corners sorted by angle, each less than half a turn after
/// the one before; empty if chance gave no such polygon.
std::vector<WindowPoint> random_star(std::uint64_t seed, WindowPoint centre, int corners,
                                     std::int64_t grid) {
    std::vector<WindowPoint> star;
    for (std::uint64_t k = 0; k < static_cast<std::uint64_t>(corners); ++k) {
        const auto x = static_cast<std::int64_t>(random_u64(seed, 2 * k) % 512);
        const auto y = static_cast<std::int64_t>(random_u64(seed, 2 * k + 1) % 512);
        star.push_back({x / grid * grid + grid / 2, y / grid * grid + grid / 2});
    }
    const auto lower = [&](WindowPoint p) {
        const auto d = p - centre;
        return d.y > 0 || (d.y == 0 && d.x > 0);
    };
    std::stable_sort(star.begin(), star.end(), [&](WindowPoint a, WindowPoint b) {
        if (lower(a) != lower(b)) return lower(a);
        return side(centre, a, b) > 0;
    });
    for (std::size_t k = 0; k < star.size(); ++k)
        if (side(centre, star[k], star[(k + 1) % star.size()]) <= 0) return {};
    return star;
}

/// A mesh of the given triangles as the only pass of a 64 x 64 picture that counts coverage.
Framebuffer counted(const std::vector<Vec3>& positions, Preset preset, PassState state = {}) {
    state.color = counting_state().color;
    state.blend = counting_state().blend;
    return render_reference(pixel_frame(64, 64, triangles(positions), state), preset);
}
}  // namespace

TEST_CASE("R01 triangles without area draw nothing and are counted", "[hard][R01]") {
    for (const Preset preset : all_presets) {
        std::feclearexcept(FE_ALL_EXCEPT);
        const auto picture = counted({{0, 0, 0},
                                      {8, 8, 0},
                                      {16, 16, 0},
                                      {5, 5, 0},
                                      {5, 5, 0},
                                      {9, 30, 0},
                                      {7, 7, 0},
                                      {7, 7, 0},
                                      {7, 7, 0},
                                      {0, 20, 0},
                                      {63, 20, 0},
                                      {30, 20, 0},
                                      {3, 3, 0},
                                      {3, 3, 0.5},
                                      {3, 9, 0.25}},
                                     preset);
        CHECK(std::fetestexcept(FE_DIVBYZERO | FE_INVALID) == 0);
        CHECK(picture.counters.zero_area == 5);
        CHECK(picture.counters.fragments == 0);
        CHECK(red_histogram(picture) == std::map<int, int>{{0, 64 * 64}});
    }
}

TEST_CASE("R02 slivers of 1/256 and 1/512 pixel cover a centre at a known number of offsets",
          "[hard][R02]") {
    const auto offsets_that_cover = [](std::int64_t x1, std::int64_t y2) {
        int covered = 0;
        for (std::int64_t dx = 0; dx < 16; ++dx)
            for (std::int64_t dy = 0; dy < 16; ++dy) {
                CountMap map{3, 3};
                map.draw({WindowPoint{16 + dx, 16 + dy},
                          {16 + dx + x1, 16 + dy},
                          {16 + dx, 16 + dy + y2}});
                const int sum = std::accumulate(map.count.begin(), map.count.end(), 0);
                CHECK(sum <= 1);
                covered += sum;
            }
        return covered;
    };
    CHECK(offsets_that_cover(1, 1) == 1);  // only with its upper left corner on the centre
    CHECK(offsets_that_cover(2, 1) == 2);
    CHECK(offsets_that_cover(1, 2) == 2);
}

TEST_CASE("R02 attributes of a sliver stay within the range of its vertices", "[hard][R02]") {
    for (const Preset preset : all_presets) {
        Mesh mesh = triangles({{8.5, 8.5, 0.25}, {8.5625, 8.5, 0.75}, {8.5, 8.5625, 0.5}});
        mesh.colors = {{0.2, 0, 0, 1}, {0.6, 0, 0, 1}, {0.4, 0, 0, 1}};
        const auto picture = render_reference(pixel_frame(16, 16, mesh), preset);
        REQUIRE(picture.counters.fragments == 1);
        CHECK(red(picture, 8, 8) >= 51);
        CHECK(red(picture, 8, 8) <= 153);
    }
}

TEST_CASE("R03 shared edges of random fans cover each pixel once", "[hard][R03]") {
    int usable = 0, twice = 0, wrong = 0;
    std::int64_t pixels = 0;
    for (std::uint64_t i = 0; i < 20000; ++i) {
        const std::int64_t grid = i % 2 == 0 ? 16 : 1;  // vertices on pixel centres, or anywhere
        const WindowPoint centre{16 * 16 + (grid == 16 ? 8 : 3), 16 * 16 + (grid == 16 ? 8 : 11)};
        const auto star = random_star(i, centre, 3 + static_cast<int>(i % 6), grid);
        if (star.empty()) continue;
        ++usable;
        CountMap map{32, 32};
        for (std::size_t k = 0; k < star.size(); ++k)
            map.draw({centre, star[k], star[(k + 1) % star.size()]});
        for (int y = 0; y < 32; ++y)
            for (int x = 0; x < 32; ++x) {
                const WindowPoint p{16 * x + 8, 16 * y + 8};
                bool within = false, on_rim = false;
                for (std::size_t k = 0; k < star.size(); ++k) {
                    const WindowPoint a = star[k], b = star[(k + 1) % star.size()];
                    if (side(centre, a, p) < 0 || side(a, b, p) < 0 || side(b, centre, p) < 0)
                        continue;
                    within = true;
                    on_rim = on_rim || side(a, b, p) == 0;
                }
                const int n = map.at(x, y);
                pixels += n;
                twice += n > 1;
                wrong += on_rim ? n > 1 : n != (within ? 1 : 0);
            }
    }
    CHECK(twice == 0);
    CHECK(wrong == 0);
    CHECK(usable == 13250);
    CHECK(pixels == 3553395);
}

TEST_CASE("R04 a pixel under a vertex that triangles share belongs to one of them", "[hard][R04]") {
    const std::vector<WindowPoint> rim{{400, 264}, {390, 380}, {264, 420}, {130, 390},
                                       {120, 264}, {140, 150}, {264, 110}, {400, 130}};
    const WindowPoint centre{264, 264};
    for (std::size_t n = 3; n <= 8; ++n)
        for (std::size_t turn = 0; turn < 8; ++turn)
            for (const bool reverse : {false, true}) {
                std::vector<std::array<WindowPoint, 3>> fan;
                for (std::size_t k = 0; k < n; ++k)
                    fan.push_back({centre, rim[(k * 8 / n + turn) % 8],
                                   rim[((k + 1) % n * 8 / n + turn) % 8]});
                if (reverse) std::reverse(fan.begin(), fan.end());
                CountMap map{32, 32};
                for (const auto& t : fan) map.draw(t);
                CHECK(map.at(16, 16) == 1);
            }
}

TEST_CASE("R05 a T-junction off the grid misses and doubles the known number of pixels",
          "[hard][R05]") {
    struct Total {
        int missed = 0, doubled = 0;
        bool operator==(const Total&) const = default;
    };
    // The middle vertex of the edge (0,0)-(16,5) lies half-way between two grid lines of 1/16.
    const auto total = [](Preset preset) {
        Total sum;
        for (int offset = 0; offset < 256; ++offset) {
            const Vec3 o{3 + offset % 16 / 16.0, 3 + offset / 16 / 16.0, 0};
            const Vec3 a = o, b = o + Vec3{16, 5, 0}, middle = o + Vec3{5.5, 1.71875, 0};
            const Vec3 above = o + Vec3{16, -9, 0}, below = o + Vec3{0, 16, 0};
            const auto apart = counted({a, b, above, a, below, middle, below, b, middle}, preset);
            const auto joined = counted({a, b, above, a, below, b}, preset);
            for (std::size_t i = 0; i < apart.bytes.size(); ++i) {
                sum.missed += apart.bytes[i].r < joined.bytes[i].r;
                sum.doubled += apart.bytes[i].r > joined.bytes[i].r;
            }
        }
        return sum;
    };
    for (const Preset preset : {Preset::ideal64, Preset::gl13})
        CHECK(total(preset) == Total{0, 0});  // their grids hold the vertex
    for (const Preset preset : {Preset::float32, Preset::nv17}) {
        const Total t = total(preset);
        CAPTURE(name_of(preset), t.missed, t.doubled);
        CHECK(t == Total{60, 0});
    }
}

TEST_CASE("R06 both windings cover the same pixels and culling takes one of them", "[hard][R06]") {
    const std::vector<Vec3> front{{3.3, 50.1, 0}, {60.2, 40.7, 0}, {20.9, 4.4, 0}};
    const std::vector<Vec3> back{front[0], front[2], front[1]};
    for (const Preset preset : all_presets) {
        const auto a = counted(front, preset), b = counted(back, preset);
        CHECK(a.bytes == b.bytes);
        CHECK(a.counters.fragments > 1000);
        PassState state;
        state.cull = CullFace::back;
        CHECK(counted(front, preset, state).bytes == a.bytes);
        CHECK(counted(back, preset, state).counters.culled == 1);
        CHECK(counted(back, preset, state).counters.fragments == 0);
        state.cull = CullFace::front;
        CHECK(counted(back, preset, state).bytes == a.bytes);
        CHECK(counted(front, preset, state).counters.fragments == 0);
    }
}

TEST_CASE("R08 two triangles whose shared edge passes behind the eye have no gap and no overlap",
          "[hard][R08]") {
    // A floor at y = -1 from far behind the eye to the horizon's edge, split along its diagonal.
    Mesh floor = triangles({{-900, -1, 700},
                            {900, -1, 700},
                            {900, -1, -300},
                            {-900, -1, 700},
                            {900, -1, -300},
                            {-900, -1, -300}});
    PassState state = counting_state();
    state.projection = frustum(0.25, 1000.0);
    Frame frame;
    frame.width = frame.height = 64;
    frame.meshes = {floor};
    frame.passes = {{state, 0}};
    for (const Preset preset : all_presets) {
        CAPTURE(name_of(preset));
        const auto picture = render_reference(frame, preset);
        CHECK(picture.counters.clipped == 2);
        int wrong = 0;
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 64; ++x) wrong += red(picture, x, y) != (y >= 32 ? 1 : 0);
        CHECK(wrong == 0);
    }
}

TEST_CASE("R09 a triangle outside one plane is rejected before set-up", "[hard][R09]") {
    for (const Preset preset : all_presets) {
        const auto c = counted({{70, 3, 0}, {90, 8, 0}, {75, 40, 0}}, preset).counters;
        CHECK(c.triangles == 1);
        CHECK(c.rejected == 1);
        CHECK(c.set_up == 0);
        CHECK(c.fragments == 0);
    }
}

TEST_CASE("R10 the guard band is not visible", "[hard][R10]") {
    // Pixels of the triangle that was cut by hand, in binary64, at x = +-2^15 pixels.
    for (const double beyond : {1.0 / 16, 1.0, 100.0, 1e6}) {
        const double far = guard_band + beyond;
        const Vec3 apex{20, 10, 0}, right{far, 40, 0}, left{-far, 50, 0};
        const auto at_band = [](Vec3 in, Vec3 out) {
            const double t = ((out.x < 0 ? -guard_band : guard_band) - in.x) / (out.x - in.x);
            return Vec3{out.x < 0 ? -guard_band : guard_band, in.y + t * (out.y - in.y), 0};
        };
        const Vec3 r1 = at_band(apex, right), l1 = at_band(apex, left);
        const Vec3 r2 = at_band(left, right), l2 = at_band(right, left);
        const auto whole = counted({apex, left, right}, Preset::ideal64);
        const auto by_hand = counted({apex, l1, l2, apex, l2, r2, apex, r2, r1}, Preset::ideal64);
        CHECK(whole.counters.clipped == 1);
        CHECK(whole.bytes == by_hand.bytes);
        CHECK(whole.counters.fragments > 1000);
    }
    for (const Preset preset : all_presets) {
        const double in = guard_band - 1.0 / 16;
        const auto c = counted({{20, 10, 0}, {-in, 50, 0}, {in, 40, 0}}, preset).counters;
        CHECK(c.clipped == 0);
        CHECK(c.fragments > 1000);
    }
}

TEST_CASE("R11 edge functions are exact at every span and 32-bit ones are not", "[hard][R11]") {
    for (const std::int64_t span : {2900, 4096, 8192, 16384, 32768}) {
        CAPTURE(span);
        int wrong = 0, wrong_in_32_bits = 0;
        for (std::uint64_t i = 0; i < 20000; ++i) {
            const auto draw = [&](std::uint64_t k) {
                return static_cast<std::int64_t>(random_u64(31, 16 * i + k) %
                                                 static_cast<std::uint64_t>(16 * span));
            };
            const std::array<WindowPoint, 3> t{
                WindowPoint{draw(0), draw(1)}, {draw(2), draw(3)}, {draw(4), draw(5)}};
            const TriangleSetup setup = set_up(t);
            const WindowPoint random{draw(6) / 16 * 16 + 8, draw(7) / 16 * 16 + 8};
            for (const WindowPoint p :
                 {random, t[0], t[1], t[2],
                  WindowPoint{(t[0].x + t[1].x) / 2, (t[0].y + t[1].y) / 2}}) {
                const bool expected = reference_covers(t, p);
                wrong += covers(setup, p) != expected;
                bool narrow = true;
                for (const EdgeFunction& e : setup.edge) {
                    const auto value = static_cast<std::int32_t>(e.at(p));
                    narrow = narrow && e.covers(value);
                }
                wrong_in_32_bits += narrow != expected;
            }
        }
        CHECK(wrong == 0);
        CHECK((wrong_in_32_bits > 0) == (span > 2900));
    }
}

TEST_CASE("R12 a target of 16,384^2 pixels is covered exactly", "[hard][R12]") {
    constexpr std::int64_t n = 16384, far = 16 * n;
    const auto pixels_of = [](const std::array<WindowPoint, 3>& p) {
        std::int64_t pixels = 0;
        for_each_covered_pixel(set_up(p), 4, {0, 0, n, n},
                               [&](int, int, const auto&) { ++pixels; });
        return pixels;
    };
    const std::array<WindowPoint, 3> upper{WindowPoint{0, 0}, {far, 0}, {0, far}};
    CHECK(pixels_of(upper) == n * (n - 1) / 2);
    const TriangleSetup lower = set_up({WindowPoint{far, far}, {0, far}, {far, 0}});
    CHECK(lower.doubled_area == far * far);
    CHECK(lower.doubled_area < std::int64_t{1} << 40);
    // The other half owns the diagonal; every 97th row of it, to save time.
    for (int y = 0; y < n; y += 97) {
        CHECK(covers(lower, {16 * (n - 1 - y) + 8, 16 * y + 8}));
        CHECK_FALSE(covers(lower, {16 * (n - 2 - y) + 8, 16 * y + 8}));
    }
    Frame frame;
    frame.width = frame.height = 16385;
    CHECK_THROWS_WITH(render_reference(frame, Preset::gl13), Catch::Contains("16385"));
    frame.width = frame.height = 16384;
    CHECK_NOTHROW(check_frame(frame));
}

TEST_CASE("R13 R14 R15 a vertex that is huge, NaN or infinite costs its triangle only",
          "[hard][R13][R14][R15]") {
    const std::vector<Vec3> good{{3, 50, 0.5}, {60, 40, 0.5}, {20, 4, 0.5}};
    for (const Preset preset : all_presets) {
        const auto expected = counted(good, preset);
        for (const double bad : {1e30, -1e30, infinity, -infinity, not_a_number, -not_a_number})
            for (int component = 0; component < 3; ++component) {
                std::vector<Vec3> with_bad{{1, 1, 0}, {60, 2, 0}, {30, 60, 0}};
                with_bad[1][component] = bad;
                with_bad.insert(with_bad.end(), good.begin(), good.end());
                const auto picture = counted(with_bad, preset);
                CAPTURE(name_of(preset), bad, component);
                CHECK(picture.bytes == expected.bytes);
                CHECK(picture.counters.not_finite == 1);
            }
    }
}

TEST_CASE("R18 a singular modelview is refused by name where normals are needed", "[hard][R18]") {
    Frame frame = sphere_frame(1, 8);
    frame.passes[2].state.modelview[1] = frame.passes[2].state.modelview[0];
    try {
        render_reference(frame, Preset::nv17);
        FAIL("drawn");
    } catch (const Error& e) {
        CHECK(e.code() == ExitCode::failure);
        CHECK(std::string(e.what()) ==
              "pass 2: modelview is singular, so it transforms no normals");
    }
    frame.passes[2].state.modelview = Mat4{0.0};
    CHECK_THROWS_AS(render_reference(frame, Preset::nv17), Error);
    for (auto& unit : frame.passes[2].state.units) unit.reset();
    CHECK_NOTHROW(render_reference(frame, Preset::nv17));
}

TEST_CASE("R19 a second pass with depth EQUAL hits every pixel of the first, in any state",
          "[hard][R19]") {
    for (const Preset preset : all_presets) {
        std::uint64_t missed = 0, pixels = 0;
        for (std::uint64_t i = 0; i < 1000; ++i) {
            const auto draw = [i](std::uint64_t k) { return random_unit(1900 + i, k); };
            Frame frame;
            frame.width = frame.height = 24;
            std::vector<Vec3> positions;
            for (std::uint64_t k = 0; k < 9; ++k)
                positions.push_back(
                    {6 * draw(3 * k) - 3, 6 * draw(3 * k + 1) - 3, -0.5 - 5 * draw(3 * k + 2)});
            frame.meshes = {triangles(positions)};
            frame.meshes[0].normals.assign(9, Vec3{0, 0, 1});
            frame.textures = {face_texture({200, 100, 50, 255}, 4, 1.0)};
            PassState first;
            first.projection = frustum(1.0, 6.0);
            first.color_mask = {true, false, false, false};
            first.depth_test = DepthTest{CompareFunc::less, true};
            PassState second = first;
            second.color_mask = {false, true, false, false};
            second.depth_test = DepthTest{CompareFunc::equal, draw(40) < 0.5};
            second.normalize = draw(41) < 0.5;
            if (draw(42) < 0.5) second.alpha_test = AlphaTest{CompareFunc::gequal, 0.0};
            if (draw(43) < 0.5) second.blend = Blend{BlendFactor::one, BlendFactor::one};
            for (std::size_t u = 0; u < 2; ++u)
                if (draw(44 + u) < 0.5) {
                    second.units[u] = TextureUnitState{};
                    if (draw(46 + u) < 0.5)
                        second.units[u]->texgen = texgen_all(TexGen::reflection_map);
                }
            frame.passes = {{first, 0}, {second, 0}};
            for (const Rgba8& p : render_reference(frame, preset).bytes) {
                pixels += p.r == 255;
                missed += (p.r != 0) != (p.g != 0);
            }
        }
        CHECK(missed == 0);
        CHECK(pixels > 50000);
    }
}

TEST_CASE("R20 depth 1 passes against a cleared buffer only where equality does", "[hard][R20]") {
    for (const Preset preset : all_presets)
        for (const auto& [z, func, drawn] : {std::tuple{1.0, CompareFunc::less, false},
                                             {1.0, CompareFunc::lequal, true},
                                             {0.0, CompareFunc::less, true},
                                             {-0.0, CompareFunc::less, true},
                                             {0.5, CompareFunc::greater, false}}) {
            PassState state;
            state.depth_test = DepthTest{func, true};
            const Frame frame = pixel_frame(4, 4, rectangle(0, 0, 4, 4, z), state);
            CHECK((render_reference(frame, preset).counters.written == 16) == drawn);
        }
}

TEST_CASE("R21 a polygon larger than the target covers it, once", "[hard][R21]") {
    for (const Preset preset : all_presets)
        for (const double reach : {10.0, 3000.0, 30000.0, 1e7, 1e12}) {
            CAPTURE(name_of(preset), reach);
            const auto picture = render_reference(
                pixel_frame(64, 64, rectangle(-reach, -reach, reach + 64, reach + 64),
                            counting_state()),
                preset);
            CHECK(red_histogram(picture) == std::map<int, int>{{1, 64 * 64}});
            CHECK(picture.counters.fragments == 64 * 64);
        }
}

TEST_CASE("R22 pictures without pixels succeed and pictures of one pixel follow the sample rule",
          "[hard][R22]") {
    for (const Preset preset : all_presets) {
        for (const auto& [w, h] : {std::pair{0, 0}, {0, 5}, {5, 0}}) {
            Frame frame = pixel_frame(1, 1, rectangle(0, 0, 1, 1));
            frame.width = w;
            frame.height = h;
            const auto picture = render_reference(frame, preset);
            CHECK(picture.bytes.empty());
            CHECK(picture.values.empty());
        }
        const auto one = [&](double x0, double x1) {
            const auto mesh = rectangle(x0, 0, x1, 1);
            return red(render_reference(pixel_frame(1, 1, mesh), preset), 0, 0);
        };
        CHECK(one(0.0, 1.0) == 255);
        CHECK(one(0.5, 1.0) == 255);  // a left edge holds the centre
        CHECK(one(0.0, 0.5) == 0);    // a right edge does not
        const auto column = render_reference(pixel_frame(1, 64, rectangle(0, 16, 1, 48)), preset);
        CHECK(red_histogram(column) == std::map<int, int>{{0, 32}, {255, 32}});
    }
}

TEST_CASE("C06 adding saturates in each pass, so order matters only beyond 255", "[hard][C06]") {
    const auto added = [](int a, int b, int minus, Preset preset) {
        Frame frame = pixel_frame(2, 2, rectangle(0, 0, 2, 2));
        const auto pass = [&](double steps, BlendFactor source, BlendFactor destination) {
            PassState state = frame.passes[0].state;
            state.color = Vec4{steps / 255, steps / 255, steps / 255, 1.0};
            state.blend = Blend{source, destination};
            return Pass{state, 0};
        };
        using enum BlendFactor;
        const Pass dim = pass(minus, zero, src_color);
        const std::vector<Pass> sum{pass(a, one, one), pass(b, one, one)};
        frame.passes = {sum[0], sum[1], dim};
        const int dim_last = red(render_reference(frame, preset), 0, 0);
        frame.passes = {sum[0], dim, sum[1]};
        return std::pair{dim_last, red(render_reference(frame, preset), 0, 0)};
    };
    for (const Preset preset : all_presets) {
        CHECK(added(200, 100, 255, preset) == std::pair{255, 255});
        CHECK(added(100, 200, 255, preset) == std::pair{255, 255});
        CHECK(added(200, 100, 51, preset) == std::pair{51, 140});  // (255) / 5; 200 / 5 + 100
        CHECK(added(20, 10, 255, preset) == std::pair{30, 30});
    }
}

TEST_CASE("T11 a unit without a texture is white", "[hard][T11]") {
    for (const Preset preset : all_presets) {
        PassState state;
        state.color = {0.1, 0.5, 0.9, 0.7};
        state.units[1] = TextureUnitState{};
        Frame frame = pixel_frame(8, 8, rectangle(0, 0, 8, 8), state);
        const auto without = render_reference(frame, preset);
        frame.textures = {{1, 1, std::vector<Rgba8>{{255, 255, 255, 255}}}};
        frame.passes[0].state.units[1]->texture = 0;
        CHECK(render_reference(frame, preset).bytes == without.bytes);
        frame.passes[0].state.units[1].reset();
        if (preset != Preset::coarse8)
            CHECK(render_reference(frame, preset).bytes == without.bytes);
    }
}
