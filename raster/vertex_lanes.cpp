#include "raster/vertex_lanes.hpp"

#include <algorithm>
#include <utility>

#include "raster/clip.hpp"
#include "raster/lane_targets.hpp"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/vertex_lanes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/vertex_arithmetic-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace twofold::lanes {
namespace HWY_NAMESPACE {
namespace {
struct Four {
    V x, y, z, w;
};
struct Three {
    V x, y, z;
};

/// The terms of a row times a vector that are not 0: texture matrices are full of zeros.
struct Terms {
    std::array<V, 4> a, b;
    std::size_t size = 0;

    HWY_INLINE Terms(const Row& row, const Four& v) {
        add(row[0], v.x);
        add(row[1], v.y);
        add(row[2], v.z);
        add(row[3], v.w);
    }
    HWY_INLINE void add(double coefficient, V v) {
        if (coefficient == 0.0) return;
        a[size] = set(coefficient);
        b[size++] = v;
    }
    template <class A, std::size_t N>
    HWY_INLINE V sum() const {
        std::array<V, N> x, y;
        std::copy_n(a.begin(), N, x.begin());
        std::copy_n(b.begin(), N, y.begin());
        return A::sum_of_products(x, y);
    }
};

template <class A>
HWY_INLINE V sparse_dot4(const Row& row, const Four& v) {
    const Terms terms(row, v);
    switch (terms.size) {
        case 0:
            return set(0.0);
        case 1:
            return A::mul(terms.a[0], terms.b[0]);
        case 2:
            return terms.template sum<A, 2>();
        case 3:
            return terms.template sum<A, 3>();
        default:
            return terms.template sum<A, 4>();
    }
}

template <class A>
HWY_NOINLINE V dot4(const Row& row, const Four& v) {
    if constexpr (A::sums_products) return sparse_dot4<A>(row, v);
    return A::sum(A::mul(set(row[0]), v.x), A::mul(set(row[1]), v.y), A::mul(set(row[2]), v.z),
                  A::mul(set(row[3]), v.w));
}
template <class A>
HWY_NOINLINE Four multiply(const Rows& m, const Four& v) {
    return {dot4<A>(m[0], v), dot4<A>(m[1], v), dot4<A>(m[2], v), dot4<A>(m[3], v)};
}
template <class A>
HWY_NOINLINE V dot3(const Three& a, const Three& b) {
    if constexpr (A::sums_products)
        return A::sum_of_products(std::array{a.x, a.y, a.z}, std::array{b.x, b.y, b.z});
    return A::sum(A::mul(a.x, b.x), A::mul(a.y, b.y), A::mul(a.z, b.z));
}
template <class A>
HWY_INLINE V dot3(const Row& row, const Three& v) {
    return dot3<A>(Three{set(row[0]), set(row[1]), set(row[2])}, v);
}
template <class A>
HWY_INLINE Three scaled(const Three& v, V by) {
    return {A::mul(v.x, by), A::mul(v.y, by), A::mul(v.z, by)};
}

HWY_INLINE V column(const VertexSource& s, std::size_t i) {
    return hn::LoadU(D(), s.values + i * s.step);
}

/// unit() of texgen.hpp; `wild` collects lengths of 0.
template <class A>
HWY_NOINLINE Three unit(const Three& v, Mask& wild) {
    const V square = dot3<A>(v, v);
    wild = hn::Or(wild, A::wild(square));
    return scaled<A>(v, A::reciprocal_sqrt(square));
}

template <class A>
HWY_INLINE Three eye_normal(const VertexRule& rule, const VertexInput& in, std::size_t i,
                            Mask& wild) {
    const Three n{column(in.normal[0], i), column(in.normal[1], i), column(in.normal[2], i)};
    const Three eye{dot3<A>(rule.normal[0], n), dot3<A>(rule.normal[1], n),
                    dot3<A>(rule.normal[2], n)};
    return rule.normalize ? unit<A>(eye, wild) : eye;
}

/// reflection_map() of texgen.hpp.
template <class A>
HWY_INLINE Three reflected(const Four& eye, const Three& normal, Mask& wild) {
    wild = hn::Or(wild, A::wild(eye.w));
    const V over_w = hn::Neg(A::reciprocal(eye.w));
    const Three to_eye = unit<A>(scaled<A>({eye.x, eye.y, eye.z}, over_w), wild);
    const Three twice{A::sum(normal.x, normal.x), A::sum(normal.y, normal.y),
                      A::sum(normal.z, normal.z)};
    const Three n = scaled<A>(normal, dot3<A>(to_eye, twice));
    return {A::reflect(n.x, to_eye.x, false), A::reflect(n.y, to_eye.y, false),
            A::reflect(n.z, to_eye.z, true)};
}

/// What texture coordinates are generated from.
struct Sources {
    Four object, eye;
    Three normal, reflection;
};

template <class A>
HWY_INLINE V generated(const SetRule& rule, std::size_t k, const Sources& from, const Four& own) {
    const auto component = [&](const Three& v, V fourth) HWY_ATTR {
        return k == 0 ? v.x : (k == 1 ? v.y : (k == 2 ? v.z : fourth));
    };
    switch (rule.mode[k]) {
        case TexGen::object_linear:
            return dot4<A>(rule.plane[k], from.object);
        case TexGen::eye_linear:
            return dot4<A>(rule.plane[k], from.eye);
        case TexGen::normal_map:
            return component(from.normal, own.w);
        case TexGen::reflection_map:
            return component(from.reflection, own.w);
        default:
            break;
    }
    return component({own.x, own.y, own.z}, own.w);
}

template <class A>
HWY_NOINLINE Four coordinates(const SetRule& rule, const Sources& from, const Four& own) {
    return multiply<A>(rule.matrix,
                       {generated<A>(rule, 0, from, own), generated<A>(rule, 1, from, own),
                        generated<A>(rule, 2, from, own), generated<A>(rule, 3, from, own)});
}

template <class A>
HWY_INLINE void project(const VertexRule& rule, const Four& clip, V rw, std::size_t i,
                        VertexOutput& out) {
    const D d;
    const hn::Rebind<std::int32_t, D> di;
    const auto window = [&](V c, std::size_t k) HWY_ATTR {
        return A::sum(A::mul(c, rw), set(rule.offset[k]));
    };
    const V snap = set(rule.snap);
    hn::Store(hn::DemoteTo(di, hn::Mul(window(clip.x, 0), snap)), di, out.x.data() + i);
    hn::Store(hn::DemoteTo(di, hn::Mul(window(clip.y, 1), snap)), di, out.y.data() + i);
    hn::Store(window(clip.z, 2), d, out.z.data() + i);
    hn::Store(rule.perspective ? A::emitted_reciprocal(rw) : set(1.0), d, out.inverse_w.data() + i);
}

/// Bits gathered lane by lane.
struct Bits {
    hn::Vec<U> value;

    HWY_INLINE void add(Mask m, int bit) {
        const U u;
        value = hn::Or(
            value, hn::IfThenElseZero(hn::RebindMask(u, m), hn::Set(u, std::uint64_t{1} << bit)));
    }
};

HWY_INLINE Mask negative(V v) { return hn::Lt(v, hn::Zero(D())); }
HWY_INLINE Mask within(V v, double limit) { return hn::Le(hn::Abs(v), set(limit)); }

/// outcode() of clip.hpp.
HWY_NOINLINE hn::Vec<U> outcodes(const VertexRule& rule, const Four& c) {
    const auto moved = [&](V v, std::size_t k) HWY_ATTR {
        return hn::Add(v, hn::Mul(set(rule.offset_f64[k]), c.w));
    };
    const V x = moved(c.x, 0), y = moved(c.y, 1), z = moved(c.z, 2);
    const V band = hn::Mul(set(guard_band), c.w);
    const V right = hn::Mul(set(rule.width + 1.0), c.w);
    const V below = hn::Mul(set(rule.height + 1.0), c.w);
    Bits bits{hn::Zero(U())};
    bits.add(negative(hn::Sub(c.w, set(smallest_w))), 0);
    bits.add(negative(z), 1);
    bits.add(negative(hn::Sub(c.w, z)), 2);
    bits.add(negative(hn::Add(band, x)), 3);
    bits.add(negative(hn::Sub(band, x)), 4);
    bits.add(negative(hn::Add(band, y)), 5);
    bits.add(negative(hn::Sub(band, y)), 6);
    bits.add(negative(hn::Add(c.w, x)), 7);
    bits.add(negative(hn::Sub(right, x)), 8);
    bits.add(negative(hn::Add(c.w, y)), 9);
    bits.add(negative(hn::Sub(below, y)), 10);
    const Mask usable = hn::And(
        hn::And(within(c.x, largest_clip_coordinate), within(c.y, largest_clip_coordinate)),
        hn::And(within(c.z, largest_clip_coordinate), within(c.w, largest_clip_coordinate)));
    return hn::IfThenElse(hn::RebindMask(U(), usable), bits.value, hn::Set(U(), unusable_vertex));
}

/// One vector of vertices: `from` in the mesh, `i` in the block.
template <class A>
HWY_INLINE void transform_vector(const VertexRule& rule, const VertexInput& in, std::size_t from,
                                 std::size_t i, VertexOutput& out) {
    const D d;
    Mask wild = hn::FirstN(d, 0);
    Sources s{};
    s.object = {column(in.position[0], from), column(in.position[1], from),
                column(in.position[2], from), column(in.position[3], from)};
    if (rule.needs_eye) s.eye = multiply<A>(rule.modelview, s.object);
    if (rule.needs_normal) s.normal = eye_normal<A>(rule, in, from, wild);
    if (rule.needs_reflection) s.reflection = reflected<A>(s.eye, s.normal, wild);
    const Four clip = multiply<A>(rule.composite, s.object);
    const V rw = A::clip_reciprocal(clip.w);
    project<A>(rule, clip, rw, i, out);
    Bits flags{hn::Zero(U())};
    for (std::size_t k = 0; k < rule.sets; ++k) {
        const auto& own = in.own[k];
        const Four c = coordinates<A>(rule.set[k], s,
                                      {column(own[0], from), column(own[1], from),
                                       column(own[2], from), column(own[3], from)});
        const auto stored = [&](V v, std::size_t n) HWY_ATTR {
            const V value = rule.over_w ? A::mul(v, rw) : v;
            hn::Store(value, d, out.coords[k][n].data() + i);
            return value;
        };
        const V x = stored(c.x, 0), y = stored(c.y, 1), w = stored(c.w, 3);
        stored(c.z, 2);
        const int bit = static_cast<int>(k);
        flags.add(hn::Ge(w, set(smallest_q)), bit);
        flags.add(hn::Le(w, set(-smallest_q)), 4 + bit);
        const Mask bounded =
            hn::And(hn::And(within(x, largest_coordinate), within(y, largest_coordinate)),
                    within(w, largest_coordinate));
        flags.add(bounded, 8 + bit);
    }
    const V emitted = hn::Load(d, out.inverse_w.data() + i);
    flags.add(hn::And(within(hn::Load(d, out.z.data() + i), largest_coordinate),
                      hn::And(hn::Ge(emitted, set(smallest_q)),
                              hn::Le(emitted, set(largest_coordinate)))),
              12);
    hn::Store(flags.value, U(), out.flags.data() + i);
    hn::Store(outcodes(rule, clip), U(), out.outcode.data() + i);
    hn::Store(hn::IfThenElseZero(wild, set(1.0)), d, out.wild.data() + i);
}

template <class A>
void transform_vectors(const VertexRule& rule, const VertexInput& in, std::size_t first,
                       std::size_t count, VertexOutput& out) {
    for (std::size_t i = 0; i < count; i += hn::Lanes(D()))
        transform_vector<A>(rule, in, first + i, i, out);
}

void transform_any(VertexArithmetic arithmetic, const VertexRule& rule, const VertexInput& in,
                   std::size_t first, std::size_t count, VertexOutput& out) {
    switch (arithmetic) {
        case VertexArithmetic::binary64:
            return transform_vectors<Binary64>(rule, in, first, count, out);
        case VertexArithmetic::binary32:
            return transform_vectors<Binary32>(rule, in, first, count, out);
        case VertexArithmetic::nv1x:
            return transform_vectors<Nv1x>(rule, in, first, count, out);
        case VertexArithmetic::nv2x:
            break;
    }
    transform_vectors<Nv2x>(rule, in, first, count, out);
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace twofold::lanes
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace twofold::lanes {

HWY_EXPORT(transform_any);

void transform_block(VertexArithmetic arithmetic, const VertexRule& rule, const VertexInput& in,
                     std::size_t first, std::size_t count, VertexOutput& out) {
    HWY_DYNAMIC_DISPATCH(transform_any)(arithmetic, rule, in, first, count, out);
}

}  // namespace twofold::lanes
#endif
