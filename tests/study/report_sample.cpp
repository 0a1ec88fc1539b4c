#include "report_sample.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "texunit/image_file.hpp"
#include "texunit/linear.hpp"

using namespace twofold;

namespace {

constexpr int width = 800, height = 600;

std::uint8_t byte(double value) {
    return static_cast<std::uint8_t>(std::clamp(value, 0.0, 1.0) * 255.0 + 0.5);
}

double facing(Vec3 n, Vec3 direction) { return std::max(0.0, dot(n, normalized(direction))); }

/// Copper-like shading of a unit normal; `misfit` stands for what a factorisation loses.
Rgb shade(Vec3 n, double misfit) {
    const double key = facing(n, {0.6, 0.7, 0.5}), fill = facing(n, {-0.8, 0.1, 0.6});
    const double shine = key * key * key * key * key * key * key * key * key * key * key * key;
    const double value = 0.06 + 0.55 * key + 0.2 * fill + misfit * (n.x * n.y + 0.3 * n.z);
    return {value * 0.95 + 0.7 * shine, value * 0.64 + 0.6 * shine, value * 0.54 + 0.5 * shine};
}

/// A sphere in the middle of the picture; channels are cut to multiples of `grain` / 255.
ByteImage sphere(double radius, double misfit, double grain) {
    ByteImage image{width, height, std::vector<Rgba8>(std::size_t{width} * height)};
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const double u = (x + 0.5 - width / 2) / radius, v = (height / 2 - y - 0.5) / radius;
            if (u * u + v * v >= 1.0) continue;
            const Rgb c = shade({u, v, std::sqrt(1.0 - u * u - v * v)}, misfit);
            const auto cut = [&](double value) {
                return byte(std::floor(value * 255.0 / grain) * grain / 255.0);
            };
            image.pixels[static_cast<std::size_t>(y * width + x)] = {cut(c.x), cut(c.y), cut(c.z),
                                                                     255};
        }
    }
    return image;
}

ReportComparison compared(const std::string& name, const ByteImage& picture,
                          const std::string& reference_name, const ByteImage& reference) {
    constexpr int full_scale = 32;
    return {name, reference_name, difference_where_covered(picture, reference),
            encode_png(heat_map(picture, reference, full_scale)), full_scale};
}

ReportPicture factor_map(const std::string& name, double tilt) {
    constexpr int size = 32;
    ByteImage map{size, size, std::vector<Rgba8>(std::size_t{size} * size)};
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            const Rgb c = shade(normalized({(x - 16) / 12.0, (16 - y) / 12.0, tilt}), 0.0);
            map.pixels[static_cast<std::size_t>(y * size + x)] = {byte(c.x), byte(c.y), byte(c.z),
                                                                  255};
        }
    }
    return {name, encode_png(map), "7c1f0e5b93a2d846"};
}

ReportChannelFit fit(int iterations, double rate) {
    ReportChannelFit f{"converged",
                       iterations,
                       0.0,
                       {},
                       0.187,
                       0.231,
                       0.064,
                       0.412,
                       31.4,
                       1.73,
                       {{"floored", 1204}, {"below horizon", 96}}};
    double residual = 1.0;
    for (int i = 0; i < iterations; ++i) {
        residual *= i % 5 == 3 ? 0.99 : rate;
        f.history.push_back(residual);
    }
    f.relative_residual = residual;
    return f;
}

ReportMaterial copper() {
    return {"copper",
            "Cook-Torrance, Beckmann slope 0.3, index of refraction 1.5, diffuse 0.3, specular 0.7",
            "product, 1 term",
            4,
            32,
            2,
            0,
            {0.87, 0.81, 0.79},
            {fit(64, 0.80), fit(71, 0.82), fit(79, 0.84)},
            {factor_map("t1 front", 0.9), factor_map("t1 back", -0.9), factor_map("t2 front", 0.5),
             factor_map("t2 back", -0.5)}};
}

}  // namespace

Report sample_report() {
    const ByteImage exact = sphere(250.0, 0.0, 1.0), ideal64 = sphere(250.0, 0.06, 1.0);
    const ByteImage gl13 = sphere(250.0, 0.06, 2.0), nv17 = sphere(249.6, 0.06, 3.0);
    Report report;
    report.title = "Copper sphere in a painted studio";
    report.scene_path = "scenes/copper.json";
    report.version = "0.1.0";
    report.command = "twofold run scenes/copper.json -o out/copper";
    report.notes = {"The environment is a stand-in of the same kind as the paper's, not the same.",
                    "Times are of this run on this machine; compare only their ratios."};
    report.warnings = {
        "1204 samples of material copper were darker than the floor and were raised."};
    report.white = 1.84;
    report.environment = "painted, 3 discs on a constant background, 512 × 256";
    report.averaging_cost = 0.0031;
    report.pictures = {{"exact", encode_png(exact), "a41d09c75be2f318"},
                       {"ideal64", encode_png(ideal64), "09b7de215f6ac443"},
                       {"gl13", encode_png(gl13), "5e0c82d1973ab6f4"},
                       {"nv17", encode_png(nv17), "c2386f1ae70d9b55"}};
    report.comparisons = {
        compared("ideal64", ideal64, "exact", exact), compared("gl13", gl13, "exact", exact),
        compared("nv17", nv17, "exact", exact), compared("gl13", gl13, "ideal64", ideal64),
        compared("nv17", nv17, "ideal64", ideal64)};
    report.materials = {copper()};
    report.steps = {{"read scene", 0.0123},  {"light samples", 3.71}, {"solve", 0.64},
                    {"exact picture", 12.4}, {"draw ideal64", 0.082}, {"draw nv17", 0.051}};
    report.preset_sentences = {
        {"ideal64", "The same passes in binary64, without rounding to 8 bits between them."},
        {"gl13", "What OpenGL 1.3 asks for at 8 bits a channel."},
        {"nv17",
         "The arithmetic of the NV17 as far as it is known: 14 of 21 stages sourced, "
         "4 inferred, 3 chosen."}};
    report.provenance = {{"scene", "f3b1c5d07a9e4286"},
                         {"mesh sphere", "generated, 12 · 41² triangles"}};
    return report;
}
