#include "tests/platforms/preset_input.hpp"

namespace twofold::platforms {
namespace {

constexpr std::size_t items = 256;

template <NumericModel M, class Result>
NamedHash over(const M& m, const char* stage, std::string_view what, const Result& result) {
    return hash_over(preset_name(stage, m, what), items, result);
}

template <NumericModel M>
InterpolationWeights<typename M::Real> weights(std::size_t i, bool equal_w) {
    InterpolationWeights<typename M::Real> w{};
    for (std::size_t k = 0; k < 3; ++k) {
        w.edge[k] = integer(i, 40 + k, 0, 100000) + (k == 0 ? 1 : 0);
        w.inverse_w[k] = static_cast<typename M::Real>(equal_w ? 1.0 : real(i, 50 + k, 0.1, 2.0));
    }
    return w;
}

template <NumericModel M>
Hashes color_hashes(const M& m) {
    const auto words = [&](std::size_t i) {
        using A = typename M::Vertex;
        return m.vertex_color(
            {A::from_double(real(i, 1, -0.1, 1.1)), A::from_double(real(i, 2, -0.1, 1.1)),
             A::from_double(real(i, 3, -0.1, 1.1)), A::from_double(real(i, 4, -0.1, 1.1))});
    };
    const auto iterated = [&](bool equal_w) {
        return [&m, equal_w](std::size_t i) {
            return m.iterate_color(weights<M>(i, equal_w), channel(m, i, 1), channel(m, i, 2),
                                   channel(m, i, 3));
        };
    };
    return {over(m, "color", "vertex", words), over(m, "color", "linear", iterated(true)),
            over(m, "color", "perspective", iterated(false))};
}

template <NumericModel M>
Hashes texel_hashes(const M& m) {
    const auto byte = [](std::size_t i, std::size_t k) {
        return static_cast<std::uint8_t>(integer(i, k, 0, 255));
    };
    Hashes hashes{
        over(m, "texel", "bytes",
             [&](std::size_t i) {
                 return m.texel(Rgba8{byte(i, 1), byte(i, 2), byte(i, 3), byte(i, 4)});
             }),
        over(m, "texel", "binary32",
             [&](std::size_t i) {
                 return m.texel(Rgba32f{static_cast<float>(real(i, 1, -0.1, 1.1)),
                                        static_cast<float>(real(i, 2, -0.1, 1.1)), 0.5F, 1.0F});
             }),
        over(m, "texel", "constant",
             [&](std::size_t i) { return m.constant(real(i, 1, -0.1, 1.1)); }),
        over(m, "filter", "bilinear",
             [&](std::size_t i) {
                 return m.filter(channel(m, i, 1), channel(m, i, 2), channel(m, i, 3),
                                 channel(m, i, 4), fraction(m, i, 5), fraction(m, i, 6));
             }),
        over(m, "filter", "levels", [&](std::size_t i) {
            return m.filter_levels(channel(m, i, 1), channel(m, i, 2), fraction(m, i, 3));
        })};
    for (int bits = 1; bits <= 8; ++bits)
        hashes.push_back(over(m, "texel", fmt::format("expand-{}-bits", bits), [&](std::size_t i) {
            return m.expand(static_cast<int>(i & ((std::size_t{1} << bits) - 1)), bits);
        }));
    return hashes;
}

template <NumericModel M>
Hashes product_hashes(const M& m) {
    const auto u = [&](std::size_t i, std::size_t k) { return channel(m, i, k); };
    const auto s = [&](std::size_t i, std::size_t k) { return signed_channel(m, i, k); };
    return {
        over(m, "unit", "modulate", [&](std::size_t i) { return m.modulate(u(i, 1), u(i, 2)); }),
        over(m, "unit", "scale",
             [&](std::size_t i) { return m.scale(u(i, 1), integer(i, 2, 1, 4)); }),
        over(m, "unit", "product", [&](std::size_t i) { return m.product(s(i, 1), s(i, 2)); }),
        over(m, "unit", "sum-of-products",
             [&](std::size_t i) { return m.sum_of_products(s(i, 1), s(i, 2), s(i, 3), s(i, 4)); }),
        over(m, "unit", "dot",
             [&](std::size_t i) { return m.dot(color(m, i, 1), color(m, i, 5)); }),
        over(m, "unit", "lerp", [&](std::size_t i) { return m.lerp(u(i, 1), u(i, 2), u(i, 3)); })};
}

template <NumericModel M>
Hashes mapping_hashes(const M& m) {
    const auto s = [&](std::size_t i, std::size_t k) { return signed_channel(m, i, k); };
    Hashes hashes{
        over(m, "unit", "add", [&](std::size_t i) { return m.add(s(i, 1), s(i, 2)); }),
        over(m, "unit", "invert", [&](std::size_t i) { return m.invert(s(i, 1)); }),
        over(m, "unit", "expand-normal", [&](std::size_t i) { return m.expand_normal(s(i, 1)); }),
        over(m, "unit", "half-bias", [&](std::size_t i) { return m.half_bias(s(i, 1)); }),
        over(m, "unit", "clamp", [&](std::size_t i) { return m.clamp_unsigned(s(i, 1)); }),
        over(m, "unit", "finish", [&](std::size_t i) { return m.finish(s(i, 1)); })};
    for (int scale = 0; scale < 4; ++scale)
        for (const bool bias : {false, true})
            hashes.push_back(over(m, "unit", fmt::format("scale-{}-bias-{}", scale, bias),
                                  [&, scale, bias](std::size_t i) {
                                      return m.scale_and_bias(m.add(s(i, 1), s(i, 2)),
                                                              static_cast<CombinerScale>(scale),
                                                              bias);
                                  }));
    return hashes;
}

}  // namespace

Hashes channel_hashes() {
    return over_presets([](const auto& m) {
        Hashes hashes = color_hashes(m);
        append(hashes, texel_hashes(m));
        append(hashes, product_hashes(m));
        append(hashes, mapping_hashes(m));
        return hashes;
    });
}

}  // namespace twofold::platforms
