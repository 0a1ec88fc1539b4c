#include <algorithm>

#include "bench/check.hpp"
#include "bench/tables.hpp"
#include "scenes/camera.hpp"
#include "scenes/mesh_shapes.hpp"
#include "texunit/paraboloid.hpp"

/// The paper's drawing: two factors on dual paraboloids, four passes told apart by alpha.
namespace twofold::bench {
namespace {

constexpr int picture_size = 1024;
constexpr int factor_size = 256;
constexpr double guard = 0.875;

std::uint8_t byte_of(double value) {
    return static_cast<std::uint8_t>(std::clamp(value, 0.0, 1.0) * 255.0 + 0.5);
}

/// A lobe around `axis` on a floor, sharper with more squarings: 2^squarings is its exponent.
double lobe(Vec3 d, Vec3 axis, int squarings) {
    double value = std::max(0.0, dot(d, normalized(axis)));
    for (int i = 0; i < squarings; ++i) value *= value;
    return 0.1 + 0.9 * value;
}

/// A face of a factor: diffuse-like lobes by the normal, sharper ones by the reflected view.
Texture factor_face(Face face, int squarings) {
    std::vector<Rgba8> texels;
    for (int y = 0; y < factor_size; ++y)
        for (int x = 0; x < factor_size; ++x) {
            const Vec3 d = texel_direction({face, x, y}, factor_size, guard);
            texels.push_back(
                {byte_of(lobe(d, {1, 2, 1}, squarings)), byte_of(lobe(d, {-2, 1, 1}, squarings)),
                 byte_of(lobe(d, {0, -1, 2}, squarings)),
                 static_cast<std::uint8_t>(texel_is_opaque(x, y, factor_size, guard) ? 255 : 0)});
        }
    return {factor_size, factor_size, std::move(texels)};
}

TextureUnitState factor_unit(TexGen texgen, std::size_t texture, Face face, const Mat4& view) {
    TextureUnitState unit;
    unit.texture = texture;
    unit.texgen = texgen_all(texgen);
    unit.matrix = paraboloid_matrix(face, guard) * Mat4{glm::transpose(Mat3{view})};
    return unit;
}

PassState common_state(const Camera& camera) {
    PassState state;
    state.modelview = view_matrix(camera);
    state.projection = projection_matrix(camera, 1.0);
    state.color = Vec4{1.0, 0.8, 0.6, 1.0};
    state.cull = CullFace::back;
    state.depth_test = DepthTest{CompareFunc::lequal, true};
    state.alpha_test = AlphaTest{CompareFunc::gequal, 1.0};
    return state;
}

Frame four_pass_frame() {
    Camera camera;
    camera.eye = {1.2, 0.9, 2.6};
    camera.target = {0.0, 0.0, 0.0};
    Frame frame = empty_frame(picture_size);
    frame.meshes = {sphere_mesh(41)};
    frame.textures = {factor_face(Face::front, 0), factor_face(Face::back, 0),
                      factor_face(Face::front, 3), factor_face(Face::back, 3)};
    constexpr std::array faces{Face::front, Face::back};
    PassState state = common_state(camera);
    for (std::size_t i = 0; i < 2; ++i)
        for (std::size_t j = 0; j < 2; ++j) {
            state.units[0] = factor_unit(TexGen::normal_map, i, faces[i], state.modelview);
            state.units[1] = factor_unit(TexGen::reflection_map, 2 + j, faces[j], state.modelview);
            state.units[1]->env.rgb_scale = 2;
            frame.passes.push_back({state, 0});
        }
    return frame;
}

/// For each pixel, which passes draw it: bit p for pass p alone.
std::vector<unsigned> drawing_passes(const Frame& frame) {
    std::vector<unsigned> drawn(picture_size * picture_size, 0);
    for (std::size_t p = 0; p < frame.passes.size(); ++p) {
        Frame alone = frame;
        alone.passes = {frame.passes[p]};
        const Framebuffer picture = render_reference(alone, Preset::gl13);
        for (std::size_t i = 0; i < drawn.size(); ++i)
            if (picture.bytes[i] != key_color) drawn[i] |= 1U << p;
    }
    return drawn;
}

/// Seams: pixels that are not drawn by the same passes as all of their eight neighbours. The discs
/// of opaque texels overlap by a band of 1.5 texels, so this holds the pixels where a pass's alpha
/// comes within a texel of its disc's edge, which is where the last bit of a coordinate decides
/// whether the pass draws at all, and those next to where the chosen pass changes.
std::vector<bool> seams(const Frame& frame) {
    const std::vector<unsigned> drawn = drawing_passes(frame);
    std::vector<bool> seam(drawn.size(), false);
    for (int y = 1; y + 1 < picture_size; ++y)
        for (int x = 1; x + 1 < picture_size; ++x) {
            const auto at = [&](int i, int j) {
                return drawn[static_cast<std::size_t>((y + j) * picture_size + x + i)];
            };
            for (int j = -1; j <= 1; ++j)
                for (int i = -1; i <= 1; ++i)
                    if (at(i, j) != at(0, 0))
                        seam[static_cast<std::size_t>(y * picture_size + x)] = true;
        }
    return seam;
}

}  // namespace

/// Coverage: vertices snap to different grids, gl13's and llvmpipe's of 1/256 pixel, softpipe's
/// none. On float32's of 1/16 pixel a vertex moves by up to 1/32, so that of the silhouette's 2,500
/// pixels one in a hundred or so changes. Colours: a filter in floating point differs by less than
/// a step; weights of 8 bits cost up to 1 step a factor, and the scale of 2 doubles it.
std::vector<Check> four_pass_checks() {
    const auto frames = [] { return std::vector<Frame>{four_pass_frame()}; };
    return {{"four passes, 20,172 triangles",
             {1, 10},
             2,
             frames,
             seams,
             {Preset::gl13, Preset::ideal64}},
            {"four passes, 1/16 pixel grid", {1, 64}, 2, frames, seams, {Preset::float32}}};
}

}  // namespace twofold::bench
