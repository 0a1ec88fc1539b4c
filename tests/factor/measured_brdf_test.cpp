#include "factor/measured_brdf.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "factor/directions.hpp"
#include "factor/environment.hpp"
#include "factor/evaluate.hpp"
#include "factor/lighting.hpp"
#include "tests/data_folder.hpp"
#include "tests/factor/measured_files.hpp"
#include "texunit/exact_math.hpp"
#include "texunit/ordered_sum.hpp"

using namespace twofold;
using namespace twofold::cases;

namespace {

/// A model that stands for a measurement: a constant and a lobe about the normal's half vector.
Rgb glossy(Vec3 wi, Vec3 wo) {
    const Vec3 h = normalized(wi + wo);
    const double lobe = exact::exp(-12.0 * (1.0 - h.z) / h.z);
    return Rgb(0.1) + lobe * Rgb(1.0, 0.5, 0.25);
}

/// A product of the very form that is fitted.
Rgb separable(Vec3 wi, Vec3 wo) {
    const Vec3 h = normalized(wi + wo);
    const double p = (1.0 + wi.z) * (1.0 + wo.z), q = exact::exp(-3.0 * (1.0 - h.z));
    return p * q * Rgb(0.3, 0.2, 0.1);
}

MeasuredData data_of(std::function<Rgb(Vec3, Vec3)> value) {
    MeasuredData data;
    data.value = std::move(value);
    return data;
}

Brdf brdf_of(const MeasuredData& data, Fill fill) {
    MeasuredBrdf brdf;
    brdf.model = std::make_shared<const MeasuredModel>(make_model(data, fill, 2));
    return brdf;
}

/// Pairs of directions over the hemisphere, away from the horizon.
std::vector<NodeDirections> some_pairs() {
    std::vector<NodeDirections> pairs;
    const auto a = surface_views(3000, 5), b = surface_views(3000, 6);
    for (std::size_t i = 0; i < a.size(); ++i) {
        const double ci = dot(a[i].n, a[i].v), co = dot(b[i].n, b[i].v);
        if (ci < 0.1 || co < 0.1) continue;
        const double phi = 0.7 * static_cast<double>(i), si = std::sqrt(1.0 - ci * ci);
        pairs.push_back({{si * exact::cos(phi), si * exact::sin(phi), ci},
                         {std::sqrt(1.0 - co * co), 0.0, co}});
    }
    return pairs;
}

/// Root mean square of the difference over that of the truth, the channels together.
double relative_rms(const Brdf& brdf, const std::function<Rgb(Vec3, Vec3)>& truth) {
    double error = 0.0, whole = 0.0;
    for (const NodeDirections& at : some_pairs()) {
        const Rgb t = truth(at.wi, at.wo);
        const Rgb difference = evaluate(brdf, Vec3(0.0, 0.0, 1.0), at.wo, at.wi) - t;
        error += dot(difference, difference);
        whole += dot(t, t);
    }
    return std::sqrt(error / whole);
}

DistantLights sky() {
    PaintedEnvironment painted{Rgb(0.2, 0.3, 0.5), {}};
    painted.discs.push_back({Vec3(1.0, 2.0, 0.5), 20.0, Rgb(8.0, 7.0, 5.0)});
    return latitude_longitude(paint(painted, 60, 30), {}, "sky").lights;
}

}  // namespace

TEST_CASE("a node's directions are at the node") {
    for (std::size_t n = 0; n < HalfAngleTable::nodes; n += 97) {
        const NodeDirections at = node_directions(n);
        if (at.wi.z < 0.02 || at.wo.z < 0.02) continue;
        const Vec3 sum = at.wi + at.wo;
        const HalfAngle place = half_angle(at.wi.z, at.wo.z, dot(sum, sum));
        const std::size_t i = n / (48 * 25), j = n / 25 % 48, k = n % 25;
        CHECK(place.half * 89.0 == Approx(static_cast<double>(i)).margin(2e-2));
        CHECK(place.difference * 47.0 == Approx(static_cast<double>(j)).margin(1e-6));
        if (i > 2 && j > 0)
            CHECK(place.azimuth * 24.0 == Approx(static_cast<double>(k)).margin(1e-3));
    }
}

TEST_CASE("interpolation gives a measurement back, gaps included") {
    CHECK(relative_rms(brdf_of(data_of(glossy), Fill::interpolate), glossy) < 0.01);
    const auto with_holes = [](Vec3 wi, Vec3 wo) {
        const bool measured = std::fmod(1000.0 * (wi.x + 2.0 * wo.z), 7.0) > 1.0;
        return measured ? glossy(wi, wo) : Rgb(std::numeric_limits<double>::quiet_NaN());
    };
    CHECK(relative_rms(brdf_of(data_of(with_holes), Fill::interpolate), glossy) < 0.03);
    CHECK_THROWS_WITH(
        make_model(data_of([](Vec3, Vec3) { return Rgb(std::nan("")); }), Fill::interpolate, 1),
        Catch::Contains("no measured value"));
}

TEST_CASE("the homomorphic product gives a product back, and a sum of two parts roughly",
          "[long]") {
    CHECK(relative_rms(brdf_of(data_of(separable), Fill::homomorphic), separable) < 0.01);
    CHECK(relative_rms(brdf_of(data_of(glossy), Fill::homomorphic), glossy) < 0.25);
}

TEST_CASE("a product from scattered samples has a value where nothing was measured") {
    const auto f = [](double ti, double to, double phi) {
        const Vec3 wi(std::sin(ti), 0.0, std::cos(ti));
        return separable(wi, Vec3(std::sin(to) * std::cos(phi), std::sin(to) * std::sin(phi),
                                  std::cos(to)))
            .x;
    };
    const MeasuredData data = parse_cornell(cornell_file(f), "c");
    const auto truth = [](Vec3 wi, Vec3 wo) { return Rgb(separable(wi, wo).x); };
    CHECK(relative_rms(brdf_of(data, Fill::homomorphic), truth) < 0.04);
    CHECK(relative_rms(brdf_of(data, Fill::interpolate), truth) < 0.10);
}

TEST_CASE(
    "the lighting sum of a measured material is the sum of its values, to the last bit, at any "
    "number of threads",
    "[long]") {
    const DistantLights lights = sky();
    const auto views = surface_views(40, 9);
    for (const Fill fill : {Fill::homomorphic, Fill::interpolate}) {
        const Brdf brdf = brdf_of(data_of(glossy), fill);
        const auto radiance = outgoing_radiance(brdf, lights, views, 1);
        CHECK(outgoing_radiance(brdf, lights, views, 3) == radiance);
        for (std::size_t i = 0; i < views.size(); ++i)
            for (int c = 0; c < 3; ++c)
                CHECK(radiance[i][c] == ordered_sum(lights.size(), [&](std::size_t k) {
                          const Vec3 l = lights.direction(k);
                          const double cosine = dot(views[i].n, l) > 0.0 ? dot(views[i].n, l) : 0.0;
                          return evaluate(brdf, views[i].n, views[i].v, l)[c] * cosine *
                                 lights.weight(k)[c];
                      }));
    }
    MeasuredBrdf unloaded;
    unloaded.source.path = "m.binary";
    CHECK_THROWS_WITH(outgoing_radiance(unloaded, lights, views, 1),
                      Catch::Contains("'m.binary' was not loaded"));
}

TEST_CASE("models have the same bits at any number of threads", "[long]") {
    for (const Fill fill : {Fill::homomorphic, Fill::interpolate}) {
        const MeasuredModel one = make_model(data_of(glossy), fill, 1),
                            three = make_model(data_of(glossy), fill, 3);
        CHECK(one.table.f == three.table.f);
        CHECK(one.product.p.nodes == three.product.p.nodes);
        CHECK(one.product.q.nodes == three.product.q.nodes);
    }
}

TEST_CASE("D02 a channel with a third of zeros is floored, and its factors are finite",
          "[hard][D02]") {
    const auto dark = [](Vec3 wi, Vec3 wo) {
        Rgb f = glossy(wi, wo);
        if (std::fmod(1000.0 * wi.z, 3.0) < 1.0) f.z = 0.0;
        return f;
    };
    const MeasuredModel model = make_model(data_of(dark), Fill::homomorphic, 2);
    const ProductFit& blue = (*model.report.factors)[2];
    CHECK(static_cast<double>(blue.zero) > 0.3 * static_cast<double>(model.report.samples));
    CHECK(blue.used == model.report.samples);
    CHECK_FALSE(blue.partly_unsupported);
    for (const Rgba32f& node : model.product.q.nodes)
        CHECK((std::isfinite(node[2]) && node[2] > 0.0F));
}

TEST_CASE(
    "F13 D03 a channel of 97.7 % zeros is partly unsupported: masked, and 0 where it has no "
    "support",
    "[hard][D03][F13][long]") {
    // Blue has a value in the highlight only.
    const auto clipped = [](Vec3 wi, Vec3 wo) {
        Rgb f = glossy(wi, wo);
        const Vec3 h = normalized(wi + wo);
        f.z = h.z > 0.99998 ? f.z : 0.0;
        return f;
    };
    const MeasuredModel model = make_model(data_of(clipped), Fill::homomorphic, 2);
    const auto& fit = *model.report.factors;
    CHECK(fit[2].partly_unsupported);
    CHECK(fit[2].used + fit[2].zero == model.report.samples);
    CHECK_FALSE(fit[0].partly_unsupported);
    CHECK(model.product.q.nodes.front()[2] > 0.0F);
    CHECK(model.product.q.nodes.back()[2] == 0.0F);
    // Alone or beside the others, the channel is the same.
    const MeasuredModel alone = make_model(
        data_of([&](Vec3 wi, Vec3 wo) { return Rgb(clipped(wi, wo).z); }), Fill::homomorphic, 2);
    for (std::size_t i = 0; i < model.product.q.nodes.size(); ++i)
        CHECK(alone.product.q.nodes[i][0] == model.product.q.nodes[i][2]);
    // A black channel stays black; all three black is an error.
    const auto no_blue = [](Vec3 wi, Vec3 wo) { return glossy(wi, wo) * Rgb(1.0, 1.0, 0.0); };
    CHECK(make_model(data_of(no_blue), Fill::homomorphic, 1).product.alpha[2] == 0.0F);
    CHECK_THROWS_WITH(
        make_model(data_of([](Vec3, Vec3) { return Rgb(0.0); }), Fill::homomorphic, 1),
        Catch::Contains("above 0"));
}

TEST_CASE("a MERL file with marks is one material by both fills", "[long]") {
    const Bytes file = merl_file([](int c, int i, int j, int) {
        if (j == 89 || (i + j) % 50 == 49) return -1.0;
        const double x = i / 90.0;
        return 1500.0 * (0.1 + exact::exp(-20.0 * x * x)) / (c == 1 ? 1.15 : c == 2 ? 1.66 : 1.0);
    });
    const MeasuredData data = parse_merl(file, "m");
    const MeasuredModel table = make_model(data, Fill::interpolate, 2);
    const MeasuredModel product = make_model(data, Fill::homomorphic, 2);
    CHECK(table.report.filled[0] > 0);
    CHECK((*product.report.factors)[0].unmeasured > 0);
    CHECK((*product.report.factors)[0].relative_rms < 0.05);
    for (const double theta : {0.0, 0.2, 0.6}) {
        const double f = 0.1 + exact::exp(-20.0 * theta * 2.0 / exact::pi);
        const double h = std::sqrt(std::sqrt(1.0 - std::cos(theta)));
        CHECK(trilinear(table.table, {h, 0.2, 0.5}).x == Approx(f).epsilon(0.06));
    }
}

TEST_CASE("measured paints and films: what each fill makes of the files") {
    const auto folder = data_folder();
    if (!folder) return;
    // Relative rms at pairs that are no nodes: interpolated, factored (the worst channel's
    // luminance decides both).
    struct Case {
        const char* file;
        double interpolated, factored;
    };
    for (const Case& c :
         {Case{"rgl/paper_white_rgb.bsdf", 0.02, 0.2},
          Case{"rgl/vch_golden_yellow_rgb.bsdf", 0.05, 1.1},
          Case{"rgl/cg_sunflower_rgb.bsdf", 0.05, 0.6}, Case{"cornell/garnet_red.brdf", 0.1, 0.4},
          Case{"cornell/krylon_blue.brdf", 0.1, 0.4}}) {
        const Bytes bytes = bytes_of(*folder / "brdf" / c.file);
        const bool rgl = std::string_view(c.file).starts_with("rgl");
        const MeasuredData data =
            rgl ? parse_rgl(bytes, c.file)
                : parse_cornell(std::string(bytes.begin(), bytes.end()), c.file);
        const auto truth = [&](Vec3 wi, Vec3 wo) {
            const Rgb f = data.value(wi, wo);
            return Rgb(std::max(f.x, 0.0), std::max(f.y, 0.0), std::max(f.z, 0.0));
        };
        INFO(c.file);
        CHECK(relative_rms(brdf_of(data, Fill::interpolate), truth) < c.interpolated);
        CHECK(relative_rms(brdf_of(data, Fill::homomorphic), truth) < c.factored);
    }
}
