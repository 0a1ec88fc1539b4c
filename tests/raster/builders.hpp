#pragma once
#include <cmath>
#include <map>
#include <vector>

#include "raster/reference.hpp"
#include "raster/renderer.hpp"
#include "texunit/fnv1a.hpp"
#include "texunit/paraboloid.hpp"
#include "texunit/random.hpp"

/// Small meshes, textures and states that the raster tests share.
namespace twofold::test {

/// The presets that follow the text of OpenGL: all but coarse8, which white does not leave alone.
inline constexpr std::array faithful_presets{Preset::ideal64, Preset::float32, Preset::gl13,
                                             Preset::nv2x, Preset::nv17};

/// The presets that compute in bytes as the chips do.
constexpr bool is_chip(Preset preset) { return preset == Preset::nv17 || preset == Preset::nv2x; }

/// Takes (x, y, z) in pixels from the upper left corner and window depth 0..1 to clip space with w
/// = 1; exact for powers of two.
inline Mat4 pixel_projection(int width, int height) {
    Mat4 m{1.0};
    m[0][0] = 2.0 / width;
    m[1][1] = -2.0 / height;
    m[2][2] = 2.0;
    m[3] = {-1.0, 1.0, -1.0, 1.0};
    return m;
}

/// glFrustum with a square window: x and y reach +-near/2 at distance near.
inline Mat4 frustum(double near, double far) {
    Mat4 m{0.0};
    m[0][0] = m[1][1] = 2.0;
    m[2][2] = (near + far) / (near - far);
    m[2][3] = -1.0;
    m[3][2] = 2.0 * near * far / (near - far);
    return m;
}

/// A mesh without sharing: each three positions are a triangle.
inline Mesh triangles(const std::vector<Vec3>& positions) {
    Mesh mesh;
    mesh.positions = positions;
    for (std::uint32_t i = 0; i < positions.size(); ++i) mesh.indices.push_back(i);
    return mesh;
}

/// The rectangle (x0, y0)..(x1, y1) in pixels at window depth z, front-facing, with (s, t) = (0, 0)
/// at its lower left.
inline Mesh rectangle(double x0, double y0, double x1, double y1, double z = 0.0) {
    Mesh mesh;
    mesh.positions = {{x0, y1, z}, {x1, y1, z}, {x1, y0, z}, {x0, y0, z}};
    mesh.texcoords[0] = {{0, 0, 0, 1}, {1, 0, 0, 1}, {1, 1, 0, 1}, {0, 1, 0, 1}};
    mesh.indices = {0, 1, 2, 0, 2, 3};
    return mesh;
}

/// A frame of one pass whose positions are pixels.
inline Frame pixel_frame(int width, int height, const Mesh& mesh, PassState state = {}) {
    state.projection = pixel_projection(width, height);
    Frame frame;
    frame.width = width;
    frame.height = height;
    frame.meshes = {mesh};
    frame.passes = {{state, 0}};
    return frame;
}

/// A state that counts: every fragment adds `steps` / 255 to red, green and blue.
inline PassState counting_state(int steps = 1) {
    PassState state;
    state.color = Vec4{steps / 255.0, steps / 255.0, steps / 255.0, 1.0};
    state.blend = Blend{BlendFactor::one, BlendFactor::one};
    return state;
}

/// The unit sphere as a cube of 6 n^2 squares blown up: 12 n^2 triangles, front faces outside. A
/// point depends on its lattice place alone, so neighbours agree in every bit.
inline Mesh sphere(int n) {
    Mesh mesh;
    const auto point = [n](int a, int b, int axis, int side) {
        std::array<double, 3> p{};
        p[static_cast<std::size_t>(axis)] = side;
        p[static_cast<std::size_t>((axis + 1) % 3)] = side * (2.0 * a - n) / n;
        p[static_cast<std::size_t>((axis + 2) % 3)] = (2.0 * b - n) / n;
        return normalized(Vec3{p[0], p[1], p[2]});
    };
    for (int axis = 0; axis < 3; ++axis)
        for (const int side : {1, -1})
            for (int a = 0; a < n; ++a)
                for (int b = 0; b < n; ++b) {
                    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
                    for (const auto& [i, j] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}})
                        mesh.positions.push_back(point(a + i, b + j, axis, side));
                    for (const std::uint32_t k : {0u, 1u, 2u, 0u, 2u, 3u})
                        mesh.indices.push_back(first + k);
                }
    mesh.normals = mesh.positions;
    return mesh;
}

/// One face of a paraboloid pair: one colour, alpha 1 where the texel is opaque.
inline Texture face_texture(Rgba8 color, int size, double guard) {
    std::vector<Rgba8> texels;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            Rgba8 texel = color;
            texel.a = texel_is_opaque(x, y, size, guard) ? 255 : 0;
            texels.push_back(texel);
        }
    return {size, size, texels};
}

/// Texels without a pattern, the same for the same width.
inline std::vector<Rgba8> noise(int width, int height) {
    std::vector<Rgba8> texels;
    for (int i = 0; i < width * height; ++i) {
        const std::uint64_t bits =
            random_u64(static_cast<std::uint64_t>(width), static_cast<std::uint64_t>(i));
        const auto byte = [bits](int k) { return static_cast<std::uint8_t>(bits >> (8 * k)); };
        texels.push_back({byte(0), byte(1), byte(2), byte(3)});
    }
    return texels;
}

/// Whether the fast pipeline draws what the reference draws.
inline bool same_pictures(const Frame& frame, Preset preset) {
    const Framebuffer fast = render(frame, preset);
    const Framebuffer reference = render(frame, preset, {}, {Pipeline::reference});
    return fast.bytes == reference.bytes && fast.values == reference.values;
}

/// FNV-1a of the displayed bytes, as docs/exactness.md, section 7, lays them out.
inline std::uint64_t hash_of(const Framebuffer& picture) {
    Fnv1a hash;
    hash.u32(static_cast<std::uint32_t>(picture.width));
    hash.u32(static_cast<std::uint32_t>(picture.height));
    hash.u32(4);
    for (const Rgba8& p : picture.bytes) hash.u8(p.r).u8(p.g).u8(p.b).u8(p.a);
    return hash.value();
}

/// How often each value of the red channel occurs.
inline std::map<int, int> red_histogram(const Framebuffer& picture) {
    std::map<int, int> histogram;
    for (const Rgba8& p : picture.bytes) ++histogram[p.r];
    return histogram;
}

/// The red channel at column x, row y from the top.
inline int red(const Framebuffer& picture, int x, int y) {
    return picture.bytes[static_cast<std::size_t>(y * picture.width + x)].r;
}

// The paper's drawing of a sphere: the front or back map of the normal times the front or back map
// of the reflection, in four passes that alpha test keeps apart.

inline constexpr int map_size = 64;
inline constexpr double map_guard = 0.875;

/// View rotation about x by the 3-4-5 triangle's angle, then about y by the 5-12-13 triangle's:
/// both hemispheres of normals and of reflections are in sight.
inline Mat4 view_rotation() {
    Mat4 x{1.0}, y{1.0};
    x[1][1] = x[2][2] = 0.8;
    x[1][2] = 0.6;
    x[2][1] = -0.6;
    y[0][0] = y[2][2] = 5.0 / 13;
    y[0][2] = -12.0 / 13;
    y[2][0] = 12.0 / 13;
    return x * y;
}

inline Mat4 inverse_view_rotation() {
    Mat4 m = view_rotation(), inverse{1.0};
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) inverse[i][j] = m[j][i];
    return inverse;
}

/// The textures of `sphere_frame`: normal front, normal back, reflection front, reflection back.
inline constexpr std::array<Rgba8, 4> face_colors{Rgba8{255, 80, 80, 255}, Rgba8{80, 255, 80, 255},
                                                  Rgba8{255, 255, 255, 255},
                                                  Rgba8{255, 255, 120, 255}};

inline TextureUnitState map_unit(TexGen texgen, Face face) {
    TextureUnitState unit;
    unit.texgen = texgen_all(texgen);
    unit.texture = (texgen == TexGen::normal_map ? 0u : 2u) + (face == Face::front ? 0u : 1u);
    unit.matrix = paraboloid_matrix(face, map_guard) * inverse_view_rotation();
    return unit;
}

/// A sphere of 12 n^2 triangles in size x size pixels, drawn in the paper's four passes.
inline Frame sphere_frame(int n, int size) {
    Frame frame;
    frame.width = frame.height = size;
    frame.meshes = {sphere(n)};
    for (const Rgba8& c : face_colors)
        frame.textures.push_back(face_texture(c, map_size, map_guard));
    Mat4 away{1.0};
    away[3] = {0.0, 0.0, -3.0, 1.0};
    for (const Face normal : {Face::front, Face::back})
        for (const Face reflection : {Face::front, Face::back}) {
            PassState state;
            state.modelview = away * view_rotation();
            state.projection = frustum(1.0, 10.0);
            state.projection[0][0] = state.projection[1][1] = 2.5;
            state.cull = CullFace::back;
            state.alpha_test = AlphaTest{};
            state.depth_test = DepthTest{CompareFunc::lequal, true};
            state.units = {map_unit(TexGen::normal_map, normal),
                           map_unit(TexGen::reflection_map, reflection)};
            frame.passes.push_back({state, 0});
        }
    return frame;
}

/// A checkered floor to the horizon: perspective, clipping behind the eye, repeat, linear filter.
inline Frame floor_frame() {
    Mesh floor = triangles({{-40, -1, 5}, {40, -1, 5}, {40, -1, -60}, {-40, -1, -60}});
    floor.indices = {0, 1, 2, 0, 2, 3};
    for (const Vec3& p : floor.positions)
        floor.texcoords[0].push_back({p.x / 2, p.z / 2, 0.0, 1.0});
    floor.colors = {{1, 1, 1, 1}, {1, 0.7, 0.4, 1}, {0.2, 0.3, 0.9, 1}, {0.3, 0.9, 0.5, 1}};
    PassState state;
    state.projection = frustum(0.25, 100.0);
    state.units[0] = TextureUnitState{};
    state.units[0]->texture = 0;
    state.units[0]->wrap_s = state.units[0]->wrap_t = Wrap::repeat;
    Frame frame;
    frame.width = 64;
    frame.height = 48;
    frame.clear_color = {0.4, 0.6, 0.8, 1.0};
    frame.meshes = {floor};
    const Rgba8 light{240, 230, 220, 255}, dark{40, 50, 60, 255};
    frame.textures = {{2, 2, std::vector<Rgba8>{light, dark, dark, light}}};
    frame.passes = {{state, 0}};
    return frame;
}

/// Six coloured triangles around a point, then a half-transparent one over them.
inline Frame fan_frame() {
    const std::array<Vec3, 6> rim{Vec3{45.3, 24, 0.5}, {33.1, 5.7, 0.5},  {12.2, 7.9, 0.5},
                                  {2.5, 24, 0.5},      {13.9, 42.6, 0.5}, {36.7, 43.8, 0.5}};
    Mesh fan = triangles({{24.5, 24.5, 0.5}});
    fan.positions.insert(fan.positions.end(), rim.begin(), rim.end());
    fan.colors = {{1, 1, 1, 1},       {1, 0, 0, 1},     {1, 0.8, 0, 0.8}, {0, 0.9, 0.1, 0.6},
                  {0, 0.7, 0.9, 0.4}, {0.1, 0, 1, 0.2}, {0.9, 0, 0.7, 0}};
    fan.indices.clear();
    for (std::uint32_t k = 0; k < 6; ++k)
        for (const std::uint32_t i : {0u, 1 + k, 1 + (k + 1) % 6}) fan.indices.push_back(i);
    Frame frame = pixel_frame(48, 48, fan);
    frame.meshes.push_back(triangles({{4, 46, 0.25}, {44, 40, 0.25}, {30, 10, 0.25}}));
    PassState glass = frame.passes[0].state;
    glass.color = {0.2, 0.9, 0.5, 0.6};
    glass.blend = Blend{BlendFactor::src_alpha, BlendFactor::one_minus_src_alpha};
    frame.passes.push_back({glass, 1});
    return frame;
}

/// A mesh of the given triangles as the only pass of a 64 x 64 picture that counts coverage.
inline Framebuffer counted(const std::vector<Vec3>& positions, Preset preset,
                           PassState state = {}) {
    state.color = counting_state().color;
    state.blend = counting_state().blend;
    return render_reference(pixel_frame(64, 64, triangles(positions), state), preset);
}

}  // namespace twofold::test
