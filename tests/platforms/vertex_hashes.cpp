#include "raster/project.hpp"
#include "raster/transform.hpp"
#include "tests/platforms/named_hash.hpp"
#include "texunit/exact_math.hpp"
#include "texunit/nv1x_arithmetic.hpp"
#include "texunit/presets.hpp"
#include "texunit/texgen.hpp"
#include "texunit/vertex_arithmetic.hpp"

namespace twofold::platforms {
namespace {

constexpr std::size_t items = 512;

/// Of any sign, 2^-32 to 2^32.
double operand(std::size_t i, std::size_t place) {
    return real(i, place, -2.0, 2.0) * exact::detail::power_of_two(static_cast<std::uint64_t>(
                                           1023 + integer(i, place + 8, -32, 31)));
}

template <class A>
struct Operands {
    typename A::Word a, b, c, d;
};

template <class A>
Operands<A> operands(std::size_t i) {
    return {A::from_double(operand(i, 1)), A::from_double(operand(i, 2)),
            A::from_double(operand(i, 3)), A::from_double(operand(i, 4))};
}

template <class A>
Hashes operation_hashes(const char* arithmetic) {
    using O = Operands<A>;
    const auto over = [&](const char* name, const auto& result) {
        return hash_over(fmt::format("vertex/{}/{}", arithmetic, name), items,
                         [&](std::size_t i) { return result(operands<A>(i)); });
    };
    return {over("from", [](const O& o) { return o.a; }),
            over("to", [](const O& o) { return A::to_double(o.a); }),
            over("negate", [](const O& o) { return A::negate(o.a); }),
            over("product", [](const O& o) { return A::mul(o.a, o.b); }),
            over("sum-2", [](const O& o) { return A::sum(o.a, o.b); }),
            over("sum-3", [](const O& o) { return A::sum(o.a, o.b, o.c); }),
            over("sum-4", [](const O& o) { return A::sum(o.a, o.b, o.c, o.d); }),
            over("reciprocal", [](const O& o) { return A::reciprocal(o.a); }),
            over("clip-reciprocal", [](const O& o) { return A::clip_reciprocal(o.a); }),
            over("emitted", [](const O& o) { return A::emitted_reciprocal(o.a); }),
            over("1-over-root", [](const O& o) { return A::reciprocal_sqrt(A::mul(o.a, o.a)); }),
            over("reflect", [](const O& o) { return A::reflect(o.a, o.b, false); }),
            over("reflect-z", [](const O& o) { return A::reflect(o.a, o.b, true); })};
}

Vec4 vec4(std::size_t i, std::size_t place, double w) {
    const double x = real(i, place, -2.0, 2.0), y = real(i, place + 1, -2.0, 2.0);
    const double z = real(i, place + 2, -2.0, 2.0);
    return {x, y, z, w};
}

template <class A>
NamedHash texgen_hash(const char* arithmetic, const char* name, TexGen mode) {
    TexGenState state = texgen_all(mode);
    for (std::size_t k = 0; k < 4; ++k)
        state.object_plane[k] = state.eye_plane[k] = vec4(k, 20, 0.25);
    return hash_over(fmt::format("texgen/{}/{}", arithmetic, name), items, [&](std::size_t i) {
        const Vec4 n = vec4(i, 4, 0.0);
        const auto normal =
            unit<A>(Vector3<A>{A::from_double(n.x), A::from_double(n.y), A::from_double(n.z)});
        return generate<A>(state, words_of<A>(vec4(i, 1, 1.0)), words_of<A>(vec4(i, 7, 1.0)),
                           words_of<A>(vec4(i, 10, real(i, 13, 0.5, 2.0))), normal);
    });
}

template <class A>
Hashes arithmetic_hashes(const char* arithmetic) {
    Hashes hashes = operation_hashes<A>(arithmetic);
    constexpr std::array<std::pair<const char*, TexGen>, 5> modes{
        {{"object-linear", TexGen::object_linear},
         {"eye-linear", TexGen::eye_linear},
         {"sphere", TexGen::sphere_map},
         {"normal", TexGen::normal_map},
         {"reflection", TexGen::reflection_map}}};
    for (const auto& [name, mode] : modes) hashes.push_back(texgen_hash<A>(arithmetic, name, mode));
    return hashes;
}

/// The division by w, the snap, and the conversion of attributes.
Hashes projection_hashes(Preset preset) {
    return with_model(preset, [&](const auto& m) {
        using M = std::remove_cvref_t<decltype(m)>;
        const Viewport viewport = viewport_of(640, 480, m.snap());
        const auto window = [&](std::size_t i) {
            ClipVertex v{};
            const double w = real(i, 5, 0.1, 50.0);
            v.clip = vec4(i, 1, w) * Vec4{160.0 * w, 120.0 * w, 0.2 * w, 1.0};
            v.color = vec4(i, 6, 0.5);
            v.coords[0] = vec4(i, 9, 1.0);
            return project(m, v, viewport, true);
        };
        const auto over = [&](const char* name, const auto& part) {
            return hash_over(fmt::format("project/{}/{}", name_of(preset), name), items,
                             [&](std::size_t i) { return part(window(i)); });
        };
        using V = WindowVertex<M>;
        return Hashes{over("x", [](const V& v) { return v.x; }),
                      over("y", [](const V& v) { return v.y; }),
                      over("z", [](const V& v) { return v.z; }),
                      over("1-over-w", [](const V& v) { return v.inverse_w; }),
                      over("color", [](const V& v) { return v.color; }),
                      over("coordinates", [](const V& v) { return v.coords[0]; })};
    });
}

}  // namespace

Hashes vertex_hashes() {
    Hashes hashes = arithmetic_hashes<IeeeArithmetic<double>>("binary64");
    append(hashes, arithmetic_hashes<IeeeArithmetic<float>>("binary32"));
    append(hashes, arithmetic_hashes<Nv1xArithmetic>("nv1x"));
    append(hashes, arithmetic_hashes<Nv2xArithmetic>("nv2x"));
    const auto word = [](std::size_t i) { return random_u32(1, i); };
    hashes.push_back(hash_over("vertex/nv1x/byte", items,
                               [&](std::size_t i) { return nv1x::float_to_byte(word(i)); }));
    hashes.push_back(hash_over("vertex/nv1x/22-bits", items,
                               [&](std::size_t i) { return nv1x::round_to_22_bits(word(i)); }));
    for (const Preset preset : all_presets) append(hashes, projection_hashes(preset));
    append(hashes, projection_hashes(Preset::custom));
    return hashes;
}

}  // namespace twofold::platforms
