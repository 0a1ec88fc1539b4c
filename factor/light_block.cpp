#include "factor/light_block.hpp"

#include <cmath>

#include "factor/evaluate.hpp"
#include "factor/light_lanes.hpp"
#include "factor/simd_clones.hpp"
#include "texunit/exact_math.hpp"

// Each helper is one loop over a run of neighbouring lights, without a branch, and is inlined into
// the block_sum of its material, which is compiled once for each vector width. A light below the
// horizon needs no branch either: its cosine is raised to 0, every other quantity stays finite, and
// its term comes out as +0.0.

namespace twofold {
namespace {

/// What Cook-Torrance needs of a light, apart from its colour.
struct Geometry {
    Lanes cosine;           ///< max(0, n.l)
    Lanes half_cosine;      ///< v.h
    Lanes squared_tangent;  ///< of the angle between n and h
    Lanes shadowing;        ///< G / (n.v); 0 below the horizon
};

/// With s = l + v and a = n.l + n.v: v.h = |s| / 2, n.h = a / |s|, tan^2 = (s^2 - a^2) / a^2 and
/// G = min(1, 4 a min(n.l, n.v) / s^2); one quotient 1 / (a^2 s^2) serves both.
[[gnu::always_inline]] inline void fill_geometry(Geometry& out, const LightBlock& block,
                                                 LightRun run, Vec3 n, Vec3 v) {
    const double* x = block.lights.x.data() + block.first + run.first;
    const double* y = block.lights.y.data() + block.first + run.first;
    const double* z = block.lights.z.data() + block.first + run.first;
    const double seen = dot(n, v);
    const double n_v = seen < least_cosine ? least_cosine : seen;
    const double inverse = 1.0 / n_v;
    for (std::size_t i = 0; i < run.count; ++i) {
        const double lit = n.x * x[i] + n.y * y[i] + n.z * z[i];
        const double n_l = lit > 0.0 ? lit : 0.0;
        const double sx = x[i] + v.x, sy = y[i] + v.y, sz = z[i] + v.z;
        const double length2 = sx * sx + sy * sy + sz * sz;
        const double s2 = length2 > 1e-60 ? length2 : 1e-60;
        const double a = n_l + n_v;
        const double a2 = a * a;
        const double quotient = 1.0 / (a2 * s2);
        const double across = s2 - a2 > 0.0 ? s2 - a2 : 0.0;
        const double lower = n_l < n_v ? n_l : n_v;
        const double shadow = 4.0 * a * a2 * lower * quotient;
        out.cosine.at[i] = n_l;
        out.half_cosine.at[i] = 0.5 * std::sqrt(s2);
        out.squared_tangent.at[i] = across * s2 * quotient;
        out.shadowing.at[i] = (shadow < 1.0 ? shadow : 1.0) * inverse;
    }
}

/// Adds w exp(-tan^2 / m^2) / m^2, but never less than exp(-600), which no sum beside it can tell
/// from 0: denormal numbers would cost a hundred times the time.
[[gnu::always_inline]] inline void add_lobe(Lanes& sum, const Geometry& of,
                                            CookTorranceTable::Lobe lobe, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        const double log_value = lobe.log_scale - of.squared_tangent.at[i] * lobe.inverse_square;
        sum.at[i] += exact::exp_normal(log_value > -600.0 ? log_value : -600.0);
    }
}

/// D G / (n.v), where 1 / cos^4 = (1 + tan^2)^2.
[[gnu::always_inline]] inline void fill_specular(Lanes& specular, const Geometry& of,
                                                 const CookTorranceTable& table,
                                                 std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        specular.at[i] = 0.0;
    }
    for (const CookTorranceTable::Lobe& lobe : table.lobes) {
        add_lobe(specular, of, lobe, count);
    }
    for (std::size_t i = 0; i < count; ++i) {
        const double secant2 = 1.0 + of.squared_tangent.at[i];
        specular.at[i] = specular.at[i] * (secant2 * secant2) * of.shadowing.at[i];
    }
}

/// Fresnel's formula over one common denominator: one division instead of two.
[[gnu::always_inline]] inline void fill_fresnel(Lanes& out, const Geometry& of,
                                                double index_square_less_1, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        const double c = of.half_cosine.at[i];
        const double g = std::sqrt(index_square_less_1 + c * c);
        const double more = g + c, less = g - c;
        const double u = c * less + 1.0, w = c * more - 1.0;
        out.at[i] = 0.5 * (less * less) * (u * u + w * w) / (more * more * (u * u));
    }
}

[[gnu::always_inline]] inline void fill_channel(double* term, const Geometry& of,
                                                const Lanes& specular, const Lanes& fresnel,
                                                double diffuse, double scale, const double* weight,
                                                std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        term[i] = (diffuse * of.cosine.at[i] + scale * fresnel.at[i] * specular.at[i]) * weight[i];
    }
}

[[gnu::always_inline]] inline void fill_run(Terms& terms, const CookTorranceTable& table,
                                            const LightBlock& block, LightRun run,
                                            const SurfaceView& at) {
    Geometry geometry;
    fill_geometry(geometry, block, run, at.n, at.v);
    Lanes specular;
    fill_specular(specular, geometry, table, run.count);
    std::array<Lanes, 3> fresnel;
    for (std::size_t k = 0; k < table.curves; ++k) {
        fill_fresnel(fresnel[k], geometry, table.index_square_less_1[k], run.count);
    }
    for (std::size_t c = 0; c < 3; ++c) {
        const int channel = static_cast<int>(c);
        fill_channel(terms[c].at + run.first, geometry, specular, fresnel[table.curve[c]],
                     table.diffuse_over_pi[channel], table.scale[channel], weights(block, run, c),
                     run.count);
    }
}

/// The two cosines of a light that modified Phong needs.
struct PhongLanes {
    Lanes cosine;    ///< max(0, n.l)
    Lanes mirrored;  ///< max(0, r_v.l)
};

[[gnu::always_inline]] inline void fill_cosines(PhongLanes& out, const LightBlock& block,
                                                LightRun run, Vec3 n, Vec3 r) {
    const double* x = block.lights.x.data() + block.first + run.first;
    const double* y = block.lights.y.data() + block.first + run.first;
    const double* z = block.lights.z.data() + block.first + run.first;
    for (std::size_t i = 0; i < run.count; ++i) {
        const double lit = n.x * x[i] + n.y * y[i] + n.z * z[i];
        const double along = r.x * x[i] + r.y * y[i] + r.z * z[i];
        out.cosine.at[i] = lit > 0.0 ? lit : 0.0;
        out.mirrored.at[i] = along > 0.0 ? along : 0.0;
    }
}

/// Factors of a power are raised to this: their product is still a normal number, and no sum of
/// radiances can tell it from 0 (denormal numbers would cost a hundred times the time).
constexpr double least_factor = 0x1p-500;

[[gnu::always_inline]] inline void multiply(Lanes& a, const Lanes& b, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        const double product = a.at[i] * b.at[i];
        a.at[i] = product > least_factor ? product : least_factor;
    }
}

/// base^N for a whole N by repeated squaring.
[[gnu::always_inline]] inline void fill_whole_power(Lanes& out, const Lanes& base,
                                                    unsigned exponent, std::size_t count) {
    Lanes square;
    for (std::size_t i = 0; i < count; ++i) {
        out.at[i] = 1.0;
        square.at[i] = base.at[i] > least_factor ? base.at[i] : least_factor;
    }
    for (unsigned rest = exponent; rest != 0; rest >>= 1) {
        if ((rest & 1U) != 0) {
            multiply(out, square, count);
        }
        multiply(square, square, count);
    }
}

/// base^N for any N as exp(N log base).
[[gnu::always_inline]] inline void fill_any_power(Lanes& out, const Lanes& base, double exponent,
                                                  std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        const double positive = base.at[i] > 1e-300 ? base.at[i] : 1e-300;
        const double log_power = exponent * exact::log(positive);
        out.at[i] = exact::exp_normal(log_power > -600.0 ? log_power : -600.0);
    }
}

/// max(0, r_v.l)^N, and 0 where r_v.l <= 0 even for N = 0: there is no lobe behind.
[[gnu::always_inline]] inline void fill_lobe(Lanes& out, const Lanes& base, double exponent,
                                             std::size_t count) {
    if (exponent < 65536.0 && std::floor(exponent) == exponent) {
        fill_whole_power(out, base, static_cast<unsigned>(exponent), count);
    } else {
        fill_any_power(out, base, exponent, count);
    }
    for (std::size_t i = 0; i < count; ++i) {
        out.at[i] = base.at[i] > 0.0 ? out.at[i] : 0.0;
    }
}

[[gnu::always_inline]] inline void fill_channel(double* term, const PhongLanes& of,
                                                const Lanes& lobe, double diffuse, double scale,
                                                const double* weight, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        term[i] = (diffuse + scale * lobe.at[i]) * of.cosine.at[i] * weight[i];
    }
}

[[gnu::always_inline]] inline void fill_run(Terms& terms, const ModifiedPhongTable& table,
                                            const LightBlock& block, LightRun run,
                                            const SurfaceView& at) {
    PhongLanes cosines;
    fill_cosines(cosines, block, run, at.n, 2.0 * dot(at.n, at.v) * at.n - at.v);
    Lanes lobe;
    fill_lobe(lobe, cosines.mirrored, table.exponent, run.count);
    for (std::size_t c = 0; c < 3; ++c) {
        const int channel = static_cast<int>(c);
        fill_channel(terms[c].at + run.first, cosines, lobe, table.diffuse_over_pi[channel],
                     table.scale[channel], weights(block, run, c), run.count);
    }
}

}  // namespace

TWOFOLD_SIMD_CLONES
Rgb block_sum(const CookTorranceTable& table, LightBlock block, const SurfaceView& at) {
    return sum_of_runs(
        block, [&](Terms & terms, LightRun run)
                   __attribute__((always_inline)) { fill_run(terms, table, block, run, at); });
}

TWOFOLD_SIMD_CLONES
Rgb block_sum(const ModifiedPhongTable& table, LightBlock block, const SurfaceView& at) {
    return sum_of_runs(
        block, [&](Terms & terms, LightRun run)
                   __attribute__((always_inline)) { fill_run(terms, table, block, run, at); });
}

}  // namespace twofold
