#include "factor/directions.hpp"
#include "factor/parametrization.hpp"
#include "tests/platforms/named_hash.hpp"
#include "texunit/cube_map.hpp"
#include "texunit/paraboloid.hpp"

namespace twofold::platforms {
namespace {

Vec3 direction(std::size_t i) {
    return normalized({real(i, 1, -1.0, 1.0), real(i, 2, -1.0, 1.0), real(i, 3, -1.0, 1.0)});
}

Hashes paraboloid_hashes(double guard) {
    constexpr std::size_t items = 512;
    constexpr int size = 16;
    const auto over = [&](const char* name, const auto& result) {
        return hash_over(fmt::format("paraboloid/guard-{}/{}", guard, name), items, result);
    };
    const auto texel = [](std::size_t i) {
        return ParaboloidTexel{i < 256 ? Face::front : Face::back, static_cast<int>(i % size),
                               static_cast<int>(i / size % size)};
    };
    const auto st = [&](std::size_t i) { return to_paraboloid(direction(i), guard); };
    return {over("face", [&](std::size_t i) { return static_cast<int>(st(i).face); }),
            over("st", [&](std::size_t i) { return st(i).st; }),
            over("back", [&](std::size_t i) { return from_paraboloid(st(i), guard); }),
            over("texel", [&](std::size_t i) { return texel_direction(texel(i), size, guard); }),
            over("opaque",
                 [&](std::size_t i) {
                     return static_cast<int>(texel_is_opaque(texel(i).x, texel(i).y, size, guard));
                 }),
            over("matrix", [&](std::size_t i) {
                return paraboloid_matrix(i % 2 == 0 ? Face::front : Face::back, guard) *
                       Vec4(direction(i), 1.0);
            })};
}

template <class Real>
Hashes cube_hashes(const char* format) {
    Hashes hashes;
    for (std::size_t f = 0; f < 6; ++f) {
        const auto face = static_cast<CubeFace>(f);
        hashes.push_back(
            hash_over(fmt::format("cube/{}/face-{}", format, f), 256, [=](std::size_t i) {
                const Vec3 d = direction(i);
                const auto at = on_face(face, ProjectiveCoordinates<Real>{
                                                  static_cast<Real>(d.x), static_cast<Real>(d.y),
                                                  static_cast<Real>(d.z), 1});
                return std::array{at.s, at.t, at.q};
            }));
    }
    hashes.push_back(hash_over(fmt::format("cube/{}/which", format), 256, [](std::size_t i) {
        const Vec3 d = direction(i);
        return static_cast<int>(cube_face(ProjectiveCoordinates<Real>{
            static_cast<Real>(d.x), static_cast<Real>(d.y), static_cast<Real>(d.z), 1}));
    }));
    return hashes;
}

Hashes footprint_hashes(const char* name, const MapShape& shape) {
    const auto over = [&](const char* what, const auto& result) {
        return hash_over(fmt::format("footprint/{}/{}", name, what), 512, result);
    };
    return {over("index", [&](std::size_t i) { return footprint_of(direction(i), shape).index; }),
            over("weight", [&](std::size_t i) { return footprint_of(direction(i), shape).weight; }),
            over("texel", [&](std::size_t i) {
                return texel_direction(texel_at(i % shape.texels(), shape), shape);
            })};
}

Hashes pair_hashes() {
    Hashes hashes;
    for (std::uint64_t sequence = 0; sequence < 4; ++sequence) {
        const auto views = surface_views(256, sequence);
        const auto over = [&](const char* name, const auto& result) {
            return hash_over(fmt::format("pairs/{}/{}", sequence, name), views.size(),
                             [&](std::size_t i) { return result(views[i]); });
        };
        hashes.push_back(over("normal", [](const SurfaceView& at) { return at.n; }));
        hashes.push_back(over("view", [](const SurfaceView& at) { return at.v; }));
        hashes.push_back(over("reflected", [](const SurfaceView& at) { return pi_2(at); }));
    }
    return hashes;
}

}  // namespace

Hashes direction_hashes() {
    Hashes hashes;
    for (const double guard : {1.0, 0.875, 0.75}) append(hashes, paraboloid_hashes(guard));
    append(hashes, cube_hashes<double>("binary64"));
    append(hashes, cube_hashes<float>("binary32"));
    append(hashes, footprint_hashes("paraboloid", {8, 0.875, MapForm::dual_paraboloid}));
    append(hashes, footprint_hashes("cube", {6, 1.0, MapForm::cube}));
    append(hashes, pair_hashes());
    return hashes;
}

}  // namespace twofold::platforms
