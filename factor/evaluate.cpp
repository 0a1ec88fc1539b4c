#include "factor/evaluate.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string_view>

#include "factor/light_block.hpp"
#include "texunit/error.hpp"
#include "texunit/exact_math.hpp"

namespace twofold {
namespace {

double least(double a, double b) { return b < a ? b : a; }
double most(double a, double b) { return a < b ? b : a; }

double slope_distribution(const CookTorrance& material, double cosine, double squared_tangent) {
    double sum = 0.0;
    for (const BeckmannLobe& lobe : material.lobes) {
        sum += lobe.weight * exact::exp(log_beckmann(cosine, squared_tangent, lobe.m));
    }
    return sum;
}

/// G / ((n.l) (n.v)), the quotient taken inside the minimum: no 0 / 0 at grazing (S02).
double shadowing_over_cosines(double n_l, double n_v, double n_h, double v_h) {
    return least(1.0 / (n_l * n_v), 2.0 * n_h / (v_h * most(n_l, n_v)));
}

Rgb value(const CookTorrance& material, Vec3 n, Vec3 v, Vec3 l) {
    const Vec3 h = normalized(l + v);
    const double n_l = most(dot(n, l), least_cosine);
    const double n_v = most(dot(n, v), least_cosine);
    const double n_h = most(dot(n, h), least_cosine);
    const double v_h = most(dot(v, h), least_cosine);
    const Vec3 across = cross(n, h);
    const double d = slope_distribution(material, n_h, dot(across, across) / (n_h * n_h));
    const double lobe =
        cook_torrance_constant(material.constant) * d * shadowing_over_cosines(n_l, n_v, n_h, v_h);
    const Rgb f(fresnel(v_h, material.f0.x), fresnel(v_h, material.f0.y),
                fresnel(v_h, material.f0.z));
    return material.diffuse / exact::pi + material.specular * f * lobe;
}

Rgb value(const ModifiedPhong& material, Vec3 n, Vec3 v, Vec3 l) {
    const Vec3 r = 2.0 * dot(n, v) * n - v;
    const double cosine = dot(r, l);
    const double lobe = cosine > 0.0 ? exact::pow(cosine, material.exponent) : 0.0;
    const double scale = (material.exponent + 2.0) / (2.0 * exact::pi);
    return material.diffuse / exact::pi + material.specular * (scale * lobe);
}

/// What the block kernel computes for one light.
Rgb value(const MeasuredBrdf& material, Vec3 n, Vec3 v, Vec3 l) {
    return measured_value(*material.model, dot(n, l), dot(n, v), dot(l + v, l + v));
}

void require(bool good, std::string_view field, double number) {
    if (!good) {
        throw Error(ExitCode::failure, fmt::format("brdf: {} = {} has no meaning", field, number));
    }
}

void require_reflectance(Rgb c, std::string_view field) {
    for (int i = 0; i < 3; ++i) {
        require(c[i] >= 0.0 && c[i] < 1e30, field, c[i]);
    }
}

void check_fields(const CookTorrance& material) {
    require_reflectance(material.diffuse, "diffuse");
    require_reflectance(material.specular, "specular");
    require_reflectance(material.f0, "f0");
    // Nearer to 1 the refractive index leaves the range in which the formula keeps its digits.
    require(max_component(material.f0) <= 1.0 - 1e-9, "f0", max_component(material.f0));
    for (const BeckmannLobe& lobe : material.lobes) {
        require(lobe.m >= 1e-6 && lobe.m <= 1e6, "m", lobe.m);
        require(lobe.weight >= 0.0 && lobe.weight < 1e30, "weight", lobe.weight);
    }
}

void check_fields(const ModifiedPhong& material) {
    require_reflectance(material.diffuse, "diffuse");
    require_reflectance(material.specular, "specular");
    require(material.exponent >= 0.0 && material.exponent <= 1e9, "exponent", material.exponent);
}

void check_fields(const MeasuredBrdf& material) {
    if (material.model == nullptr)
        throw Error(ExitCode::failure,
                    fmt::format("brdf: '{}' was not loaded", material.source.path));
}

}  // namespace

double log_beckmann(double cosine, double squared_tangent, double m) {
    const double square = cosine * cosine;
    return -squared_tangent / (m * m) - exact::log(m * m * square * square);
}

double refractive_index(double f0) { return (1.0 + std::sqrt(f0)) / (1.0 - std::sqrt(f0)); }

double fresnel(double cosine, double f0) {
    const double eta = refractive_index(f0);
    const double g = std::sqrt(eta * eta - 1.0 + cosine * cosine);
    const double a = (g - cosine) / (g + cosine);
    const double b = (cosine * (g + cosine) - 1.0) / (cosine * (g - cosine) + 1.0);
    return 0.5 * a * a * (1.0 + b * b);
}

double cook_torrance_constant(CookTorranceConstant constant) {
    return constant == CookTorranceConstant::pi1981 ? 1.0 / exact::pi : 0.25 / exact::pi;
}

Rgb evaluate(const Brdf& brdf, Vec3 n, Vec3 v, Vec3 l) {
    if (!(dot(n, v) > 0.0) || !(dot(n, l) > 0.0)) {
        return Rgb(0.0);
    }
    return std::visit([&](const auto& material) { return value(material, n, v, l); }, brdf);
}

void check(const Brdf& brdf) {
    std::visit([](const auto& material) { check_fields(material); }, brdf);
}

}  // namespace twofold
