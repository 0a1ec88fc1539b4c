#include "factor/measured_data.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "factor/spectrum.hpp"
#include "factor/surface_angles.hpp"
#include "tests/data_folder.hpp"
#include "tests/factor/measured_files.hpp"
#include "tests/refusal.hpp"
#include "texunit/exact_math.hpp"

using namespace twofold;
using namespace twofold::cases;

namespace {

std::string merl_refusal(const Bytes& bytes) {
    return refusal(ExitCode::bad_file, [&] { parse_merl(bytes, "m.binary"); });
}

std::string rgl_refusal(const Bytes& bytes) {
    return refusal(ExitCode::bad_file, [&] { parse_rgl(bytes, "r.bsdf"); });
}

std::string cornell_refusal(const std::string& text) {
    return refusal(ExitCode::bad_file, [&] { parse_cornell(text, "c.brdf"); });
}

Bytes bytes_of_text(std::string_view text) { return {text.begin(), text.end()}; }

bool contains(const std::string& text, std::string_view part) {
    return text.find(part) != std::string::npos;
}

Vec3 direction(double theta, double phi) {
    return {exact::sin(theta) * exact::cos(phi), exact::sin(theta) * exact::sin(phi),
            exact::cos(theta)};
}

}  // namespace

TEST_CASE("D04 a MERL file of other size or dimensions is refused, an LFS pointer by its name",
          "[hard][D04]") {
    CHECK(contains(merl_refusal(bytes_of_text("version https://git-lfs.github.com/spec/v1\n")),
                   "Git LFS pointer"));
    for (const std::int32_t edge : {0, -1, 2147483647, 89}) {
        Bytes bytes;
        put(bytes, edge);
        put(bytes, std::int32_t{90});
        put(bytes, std::int32_t{180});
        CHECK(contains(merl_refusal(bytes), "dimension " + std::to_string(edge)));
    }
    Bytes huge;  // 65536^3 is 0 in 32 bits
    for (int i = 0; i < 3; ++i) put(huge, std::int32_t{65536});
    CHECK(contains(merl_refusal(huge), "dimension 65536"));
    Bytes header;
    for (const std::int32_t edge : {90, 90, 180}) put(header, edge);
    CHECK(contains(merl_refusal(header), "has 34992012 bytes, this one 12"));
    CHECK(contains(merl_refusal(Bytes(5)), "this one 5"));
    Bytes whole(12 + 24 * merl_plane);
    std::copy(header.begin(), header.end(), whole.begin());
    CHECK(merl_refusal(whole) == "accepted");
    whole.pop_back();
    CHECK(contains(merl_refusal(whole), "this one 34992011"));
}

TEST_CASE("D04 a MERL value is that of its bin in its channel's scale, and a mark is none",
          "[hard][D04]") {
    const Bytes file = merl_file([](int c, int i, int j, int k) {
        if (c == 1 && i == 0) return -1.0;  // 16,200 marks
        return 1.0 + k + 200.0 * (j + 100.0 * i);
    });
    const MeasuredData data = parse_merl(file, "m.binary");
    CHECK(data.counts[0] == ValueCounts{merl_plane, 0, 0, 0});
    CHECK(data.counts[1] == ValueCounts{merl_plane, 0, 16200, 0});
    // theta_h = 0 and theta_d = 0: the very first bin.
    const Rgb first = data.value(Vec3(0.0, 0.0, 1.0), Vec3(0.0, 0.0, 1.0));
    CHECK(first.x == Approx(1.0 / 1500.0));
    CHECK(std::isnan(first.y));
    CHECK(first.z == Approx(1.66 / 1500.0));
    // theta_h = 0.3, theta_d = 0.5, phi_d = 1: h, then d turned into place.
    const Vec3 h = direction(0.3, 0.7);
    const Vec3 t = direction(0.3 + exact::pi / 2.0, 0.7), b = cross(h, t);
    const Vec3 across = exact::cos(1.0) * t + exact::sin(1.0) * b;
    const Vec3 wi = exact::cos(0.5) * h + exact::sin(0.5) * across;
    const Vec3 wo = exact::cos(0.5) * h - exact::sin(0.5) * across;
    const int i = static_cast<int>(90.0 * std::sqrt(0.3 * 2.0 / exact::pi));
    const int j = static_cast<int>(90.0 * 0.5 * 2.0 / exact::pi);
    const int k = static_cast<int>(180.0 * 1.0 / exact::pi);
    const double stored = 1.0 + k + 200.0 * (j + 100.0 * i);
    CHECK(data.value(wi, wo).x == Approx(stored / 1500.0));
    CHECK(data.value(wi, wo).y == Approx(stored * 1.15 / 1500.0));
    // Reciprocity is that of the index: phi_d + pi is the same bin.
    CHECK(data.value(wo, wi).x == data.value(wi, wo).x);
}

TEST_CASE("the tables of observer and D65 give D65's white, and an even spectrum is white") {
    CHECK(tabulated_white().x == Approx(0.3127).margin(5e-4));
    CHECK(tabulated_white().y == Approx(0.3290).margin(5e-4));
    for (const std::vector<double>& nm :
         {std::vector<double>{400, 700}, {400, 410, 433, 500, 600, 690}, {300, 555, 900}}) {
        Rgb sum(0.0);
        for (const Rgb& weight : spectrum_weights(nm)) sum += weight;
        for (int c = 0; c < 3; ++c) CHECK(sum[c] == Approx(1.0).epsilon(1e-12));
    }
}

TEST_CASE(
    "a Cornell file is numbers between comments, and what cannot be is refused with its line") {
    const MeasuredData data =
        parse_cornell("2 # count\r\n450 # nm\n650\n\n0.5 0 0.25 3 .125 .125", "c");
    REQUIRE(data.scattered.size() == 1);
    CHECK(data.scattered[0].wi.z == Approx(std::cos(0.5)));
    CHECK(data.scattered[0].wo.x == Approx(std::sin(0.25) * std::cos(3.0)));
    CHECK(data.scattered[0].f.y == Approx(0.125));
    CHECK(contains(cornell_refusal(""), "number of wavelengths: the end"));
    CHECK(contains(cornell_refusal("1e9"), "number of wavelengths: '1e9'"));
    CHECK(contains(cornell_refusal("2.5 400 500"), "2.5 wavelengths"));
    CHECK(contains(cornell_refusal("2\n500\n400"), "line 3: wavelength: '400'"));
    CHECK(contains(cornell_refusal("2 800 900"), "no wavelength within"));
    CHECK(contains(cornell_refusal("2 450 550\n"), "no measurement"));
    CHECK(contains(cornell_refusal("2 450 550\n1.6 0 0 0 1 1"), "line 2: theta_i: '1.6'"));
    CHECK(contains(cornell_refusal("2 450 550\n1 0 0 9 1 1"), "phi_o: '9'"));
    CHECK(contains(cornell_refusal("2 450 550\n1 0 0 0 1"), "value: the end"));
    for (const char* word : {"nan", "1e999", "1,5", "0x1p2", "-"})
        CHECK(contains(cornell_refusal(std::string("2 450 550\n1 0 0 0 1 ") + word), "value: '"));
}

TEST_CASE("scattered samples give themselves back, and between them the mean of the nearest") {
    std::vector<BrdfSample> samples;
    for (int i = 0; i < 20; ++i)
        samples.push_back({direction(0.05 * i, 0.0), direction(0.03 * i + 0.1, 2.0), Rgb(0.1 * i)});
    const auto value = scattered_value(samples);
    for (const BrdfSample& s : samples) {
        CHECK(value(s.wi, s.wo) == s.f);
        CHECK(value(s.wo, s.wi).x == Approx(s.f.x));  // a pair and its reciprocal are one point
    }
    const double between = value(direction(0.475, 0.0), direction(0.385, 2.0)).x;
    CHECK(between > 0.9);
    CHECK(between < 1.0);
    // Fewer samples than neighbours.
    const auto two = scattered_value({samples[3], samples[9]});
    const double mean = two(direction(0.3, 0.0), direction(0.28, 2.0)).x;
    CHECK(mean > 0.3);
    CHECK(mean < 0.9);
}

TEST_CASE("an RGL file of even distributions gives its colour over 4 sigma and the cosine") {
    const auto fields = rgl_fields([](std::size_t slice, std::size_t channel) {
        return channel == 2 ? -1.0F : static_cast<float>(1 + slice) * (channel == 0 ? 1.0F : 0.5F);
    });
    const MeasuredData data = parse_rgl(tensor_file(fields), "r");
    CHECK(data.counts[0] == ValueCounts{48, 0, 0, 0});
    CHECK(data.counts[2] == ValueCounts{48, 0, 48, 0});
    const Vec3 wo = direction(0.6, 2.0);
    for (const double theta : {0.0, 0.3, 0.75, 1.2, 1.55}) {
        const double colour =
            theta < 0.75 ? 1.0 + theta / 0.75 : 2.0 + std::min(theta - 0.75, 0.75) / 0.75;
        const Rgb f = data.value(direction(theta, 0.4), wo);
        CHECK(f.x == Approx(colour / (4.0 * wo.z)).epsilon(1e-6));
        CHECK(f.y == Approx(0.5 * f.x).epsilon(1e-12));
        CHECK(f.z == 0.0);
    }
}

TEST_CASE("an RGL file that is damaged is refused by field") {
    const auto good = rgl_fields([](std::size_t, std::size_t) { return 1.0F; });
    REQUIRE(rgl_refusal(tensor_file(good)) == "accepted");
    CHECK(contains(rgl_refusal(bytes_of_text("tensor_fil")), "truncated"));
    CHECK(contains(rgl_refusal(bytes_of_text("no tensor file at all")), "no tensor file"));
    const auto changed = [&](std::size_t field, const Field& with) {
        auto fields = good;
        fields[field] = with;
        return rgl_refusal(tensor_file(fields));
    };
    const auto one = [](std::size_t) { return 1.0F; };
    CHECK(contains(changed(0, {"theta", {3}, one}), "no field 'theta_i'"));
    CHECK(contains(changed(0, {"theta_i", {3}, one}), "'theta_i' does not ascend"));
    CHECK(contains(changed(1, {"sigma", {8}, one}), "field 'sigma' is [8]"));
    CHECK(contains(changed(1, {"sigma", {2, 4}, [](std::size_t) { return 0.0F; }}),
                   "'sigma' has the value 0"));
    CHECK(contains(changed(3, {"vndf", {1, 3, 4, 4}, [](std::size_t) { return 0.0F; }}),
                   "'vndf' is 0 everywhere"));
    CHECK(contains(changed(4, {"rgb", {1, 2, 3, 4, 4}, one}), "field 'rgb' is [1, 2, 3, 4, 4]"));
    CHECK(contains(
        changed(4,
                {"rgb", {1, 3, 3, 4, 4}, [](std::size_t i) { return i == 7 ? INFINITY : 1.0F; }}),
        "'rgb' is not finite"));
    Bytes short_file = tensor_file(good);
    short_file.pop_back();
    CHECK(contains(rgl_refusal(short_file), "field 'rgb' does not fit"));
    // A product of edges that overflows 64 bits, and offsets past the end.
    Bytes bytes = tensor_file(good);
    const auto edge =
        std::search(bytes.begin(), bytes.end(), good[1].name.begin(), good[1].name.end()) + 5 + 2 +
        1 + 8;
    std::fill(edge, edge + 16, static_cast<unsigned char>(0xff));
    CHECK(contains(rgl_refusal(bytes), "field 'sigma' does not fit"));
    std::fill(edge - 8, edge, static_cast<unsigned char>(0xff));
    CHECK(contains(rgl_refusal(bytes), "past the end"));
}

TEST_CASE("damaged measured files are read or refused, never worse") {
    const Bytes rgl = tensor_file(rgl_fields([](std::size_t, std::size_t) { return 1.0F; }));
    const auto some_value = [](const MeasuredData& data) {
        (void)data.value(direction(0.4, 0.0), direction(1.1, 2.5));
    };
    CHECK(replay_damaged(rgl, 3000, 200, [&](const Bytes& b) { some_value(parse_rgl(b, "r")); }) >
          500);
    const std::string text = cornell_file([](double, double, double) { return 0.2; });
    CHECK(replay_damaged(bytes_of_text(text.substr(0, 2000)), 2000, 40, [&](const Bytes& b) {
              some_value(parse_cornell(std::string(b.begin(), b.end()), "c"));
          }) > 500);
    CHECK(replay_damaged(bytes_of_text("version https://git-lfs.github.com/spec/v1\nsize 34992012"),
                         500, 60, [&](const Bytes& b) { parse_merl(b, "m"); }) == 500);
}

TEST_CASE("Cornell's own files have the sums that their description states") {
    const auto folder = data_folder();
    if (!folder) return;
    for (const auto& [name, negative] :
         {std::pair{"garnet_red", std::size_t{143}}, {"krylon_blue", std::size_t{1063}}}) {
        const Bytes bytes = bytes_of(*folder / "brdf/cornell" / (std::string(name) + ".brdf"));
        const MeasuredData data = parse_cornell(std::string(bytes.begin(), bytes.end()), name);
        REQUIRE(data.scattered.size() == 1439);
        double theta = 0.0;
        std::size_t below = 0;
        for (const BrdfSample& s : data.scattered) theta += polar_angle(s.wi);
        for (const ValueCounts& c : data.counts) below += c.negative;
        CHECK(theta == Approx(1133.416940).epsilon(1e-8));
        CHECK(below == negative);
    }
}

TEST_CASE("RGL's own files have values that are nearly reciprocal") {
    // Divided by the wrong cosine they would differ by a factor of two here.
    const auto folder = data_folder();
    if (!folder) return;
    const Bytes bytes = bytes_of(*folder / "brdf/rgl/paper_white_rgb.bsdf");
    const MeasuredData data = parse_rgl(bytes, "paper_white");
    for (const double phi : {0.5, 1.5, 2.5}) {
        const Vec3 a = direction(0.3, 0.0), b = direction(1.05, phi);
        CHECK(data.value(a, b).y == Approx(data.value(b, a).y).epsilon(0.12));
    }
}
