#include <algorithm>
#include <catch2/catch.hpp>
#include <cfenv>
#include <numeric>

#include "raster/coverage.hpp"
#include "raster/frame_check.hpp"
#include "tests/raster/builders.hpp"

/// The hard cases (R) about which pixels a triangle covers.
namespace {
using namespace twofold;
using namespace twofold::test;
__extension__ using Int128 = __int128;

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

TEST_CASE("R03 shared edges of random fans cover each pixel once", "[hard][R03][long]") {
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
