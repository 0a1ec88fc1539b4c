#include <fmt/format.h>

#include <array>
#include <cmath>
#include <memory>

#include "factor/measured_data.hpp"
#include "factor/surface_angles.hpp"
#include "factor/tensor_file.hpp"
#include "texunit/error.hpp"
#include "texunit/exact_math.hpp"
#include "texunit/fixed.hpp"

namespace twofold {
namespace {

/// A position among `count` nodes: the lower of two neighbours and the weight of the upper.
struct Between {
    std::size_t lower;
    double weight;
};

/// Nodes lie at i / (count - 1) of the unit interval.
Between between(double coordinate, std::size_t count) {
    const double position = coordinate * static_cast<double>(count - 1);
    const std::size_t lower = to_fixed(position, std::size_t{0}, count - 2);
    const double weight = position - static_cast<double>(lower);
    return {lower, weight < 0.0 ? 0.0 : weight > 1.0 ? 1.0 : weight};
}

double mixed(double a, double b, double t) { return (1.0 - t) * a + t * b; }

/// Tables of rows x columns, one after the other; the first coordinate runs along a row.
struct Tables {
    std::size_t rows = 0, columns = 0;
    std::vector<double> values;

    double at(std::size_t table, std::size_t row, std::size_t column) const {
        return values[(table * rows + row) * columns + column];
    }
    double& at(std::size_t table, std::size_t row, std::size_t column) {
        return values[(table * rows + row) * columns + column];
    }
    double bilinear(std::size_t table, double x, double y) const {
        const Between i = between(x, columns), j = between(y, rows);
        const auto row = [&](std::size_t r) {
            return mixed(at(table, r, i.lower), at(table, r, i.lower + 1), i.weight);
        };
        return mixed(row(j.lower), row(j.lower + 1), j.weight);
    }
};

/// Everything that an evaluation needs. Of vndf: D its values, C their integral along each row up
/// to a column, M the integral of the rows' totals up to a row, each table scaled to a total of 1.
struct RglBrdf {
    std::vector<double> theta;  ///< of the slices, ascending
    Tables sigma, ndf, density, along_row, rgb;
    std::vector<double> over_rows;  ///< M, rows of a slice after one another
};

/// Two neighbouring slices in theta_i and the weight of the upper.
Between slice_at(const std::vector<double>& theta, double angle) {
    std::size_t lower = 0;
    while (lower + 2 < theta.size() && theta[lower + 1] <= angle) ++lower;
    const double t = (angle - theta[lower]) / (theta[lower + 1] - theta[lower]);
    return {lower, t < 0.0 ? 0.0 : t > 1.0 ? 1.0 : t};
}

/// Distribution functions of the slices' densities, by the trapezoid rule with spacing 1.
void integrate(RglBrdf& brdf) {
    Tables &d = brdf.density, &c = brdf.along_row;
    c = d;
    for (std::size_t slice = 0; slice < brdf.theta.size(); ++slice) {
        std::vector<double> m(d.rows, 0.0);
        for (std::size_t j = 0; j < d.rows; ++j) {
            c.at(slice, j, 0) = 0.0;
            for (std::size_t i = 1; i < d.columns; ++i)
                c.at(slice, j, i) =
                    c.at(slice, j, i - 1) + 0.5 * (d.at(slice, j, i - 1) + d.at(slice, j, i));
            if (j > 0)
                m[j] = m[j - 1] +
                       0.5 * (c.at(slice, j - 1, d.columns - 1) + c.at(slice, j, d.columns - 1));
        }
        const double total = m.back();
        for (std::size_t j = 0; j < d.rows; ++j) {
            for (std::size_t i = 0; i < d.columns; ++i) {
                d.at(slice, j, i) /= total;
                c.at(slice, j, i) /= total;
            }
            brdf.over_rows.push_back(m[j] / total);
        }
    }
}

/// Where the visible normal b of the slices is in their colour tables: the inverse of sampling
/// vndf.
Vec2 colour_place(const RglBrdf& brdf, Between slice, Vec2 b) {
    const Between i = between(b.x, brdf.density.columns), j = between(b.y, brdf.density.rows);
    const auto of = [&](const Tables& tables, std::size_t row, std::size_t column) {
        return mixed(tables.at(slice.lower, row, column), tables.at(slice.lower + 1, row, column),
                     slice.weight);
    };
    const auto over_rows = [&](std::size_t s) {
        return brdf.over_rows[s * brdf.density.rows + j.lower];
    };
    const auto column = [&](const Tables& tables, std::size_t c) {
        return mixed(of(tables, j.lower, c), of(tables, j.lower + 1, c), j.weight);
    };
    const double s = i.weight, t = j.weight;
    const std::size_t last = brdf.density.columns - 1;
    const double c0 = column(brdf.density, i.lower), c1 = column(brdf.density, i.lower + 1);
    const double r0 = of(brdf.along_row, j.lower, last), r1 = of(brdf.along_row, j.lower + 1, last);
    const double row_total = mixed(r0, r1, t);
    const double x = s * (c0 + 0.5 * s * (c1 - c0)) + column(brdf.along_row, i.lower);
    const double m = mixed(over_rows(slice.lower), over_rows(slice.lower + 1), slice.weight);
    return {row_total > 0.0 ? x / row_total : 0.0, t * (r0 + 0.5 * t * (r1 - r0)) + m};
}

double elevation_coordinate(double theta) { return std::sqrt(2.0 * theta / exact::pi); }

/// An angle of -2 pi to 2 pi as a part of a turn from -pi on.
double turn_coordinate(double phi) {
    const double turn = (phi + exact::pi) / (2.0 * exact::pi);
    return turn - std::floor(turn);
}

/// f(wi, wo), as the data set's README of evaluation has it, steps 1 to 5.
Rgb value_at(const RglBrdf& brdf, Vec3 wi, Vec3 wo) {
    const Vec3 m = normalized(wi + wo);
    const double theta_i = polar_angle(wi), phi_i = azimuth(wi.x, wi.y);
    const Vec2 a(elevation_coordinate(theta_i), turn_coordinate(phi_i));
    const Vec2 b(elevation_coordinate(polar_angle(m)), turn_coordinate(azimuth(m.x, m.y) - phi_i));
    const Between slice = slice_at(brdf.theta, theta_i);
    const Vec2 place = colour_place(brdf, slice, b);
    const double scale =
        brdf.ndf.bilinear(0, b.x, b.y) / (4.0 * brdf.sigma.bilinear(0, a.x, a.y) * wo.z);
    Rgb f;
    for (std::size_t c = 0; c < 3; ++c) {
        const double colour =
            mixed(brdf.rgb.bilinear(3 * slice.lower + c, place.x, place.y),
                  brdf.rgb.bilinear(3 * (slice.lower + 1) + c, place.x, place.y), slice.weight);
        f[static_cast<int>(c)] = colour > 0.0 ? colour * scale : 0.0;
    }
    return f;
}

[[noreturn]] void fail(std::string_view name, std::string_view what) {
    throw Error(ExitCode::bad_file, fmt::format("{}: {}", name, what));
}

/// A field whose last two dimensions are rows and columns of at least two, and whose others are
/// `leading`.
Tables tables_of(const Tensor& tensor, const std::vector<std::size_t>& leading,
                 std::string_view field, std::string_view name) {
    const auto& shape = tensor.shape;
    const bool good = shape.size() == leading.size() + 2 &&
                      std::equal(leading.begin(), leading.end(), shape.begin()) &&
                      shape[shape.size() - 2] >= 2 && shape.back() >= 2;
    if (!good)
        fail(name, fmt::format("field '{}' is [{}], not of an isotropic RGB material", field,
                               fmt::join(shape, ", ")));
    return {shape[shape.size() - 2], shape.back(), {tensor.values.begin(), tensor.values.end()}};
}

void require_ascending(const std::vector<double>& theta, std::string_view name) {
    bool good = theta.size() >= 2;
    for (std::size_t i = 1; i < theta.size(); ++i) good = good && theta[i - 1] < theta[i];
    if (!good) fail(name, "field 'theta_i' does not ascend");
}

void require_positive(const Tables& tables, bool zero_too, std::string_view field,
                      std::string_view name) {
    for (const double value : tables.values)
        if (!(value > 0.0 || (zero_too && value == 0.0)))
            fail(name, fmt::format("field '{}' has the value {}", field, value));
}

RglBrdf read_brdf(std::span<const unsigned char> bytes, std::string_view name) {
    constexpr std::array<std::string_view, 5> fields{"theta_i", "sigma", "ndf", "vndf", "rgb"};
    const auto tensors = parse_tensors(bytes, fields, name);
    RglBrdf brdf;
    const Tensor& theta = tensors.at("theta_i");
    brdf.theta.assign(theta.values.begin(), theta.values.end());
    require_ascending(brdf.theta, name);
    brdf.sigma = tables_of(tensors.at("sigma"), {}, "sigma", name);
    brdf.ndf = tables_of(tensors.at("ndf"), {}, "ndf", name);
    brdf.density = tables_of(tensors.at("vndf"), {1, brdf.theta.size()}, "vndf", name);
    brdf.rgb = tables_of(tensors.at("rgb"), {1, brdf.theta.size(), 3}, "rgb", name);
    require_positive(brdf.sigma, false, "sigma", name);
    require_positive(brdf.ndf, true, "ndf", name);
    require_positive(brdf.density, true, "vndf", name);
    integrate(brdf);
    for (const double value : brdf.over_rows)
        if (!std::isfinite(value)) fail(name, "field 'vndf' is 0 everywhere in a slice");
    return brdf;
}

}  // namespace

MeasuredData parse_rgl(std::span<const unsigned char> bytes, std::string_view name) {
    const auto brdf = std::make_shared<const RglBrdf>(read_brdf(bytes, name));
    MeasuredData data;
    const std::size_t plane = brdf->rgb.rows * brdf->rgb.columns;
    for (std::size_t i = 0; i < brdf->rgb.values.size(); ++i)
        data.counts[i / plane % 3].add(brdf->rgb.values[i]);
    data.value = [brdf](Vec3 wi, Vec3 wo) { return value_at(*brdf, wi, wo); };
    return data;
}

}  // namespace twofold
