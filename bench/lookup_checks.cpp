#include <fmt/format.h>

#include "bench/check.hpp"
#include "bench/tables.hpp"
#include "scenes/camera.hpp"
#include "scenes/mesh_shapes.hpp"

/// Coordinate generation, wraps and filters.
namespace twofold::bench {
namespace {

TexEnv replace() {
    TexEnv env;
    env.mode = TexEnvMode::replace;
    return env;
}

Mat4 scale_and_offset(double scale, double offset) {
    Mat4 m{1.0};
    m[0][0] = m[1][1] = scale;
    m[3] = Vec4{offset, offset, 0.0, 1.0};
    return m;
}

/// A sphere seen from aside, its texture smooth.
Frame texgen_frame(TexGen mode) {
    Camera camera;
    camera.eye = {1.5, -0.7, 2.4};
    camera.target = {0.0, 0.0, 0.0};
    Frame frame = empty_frame(256);
    frame.meshes = {sphere_mesh(24)};
    frame.textures = {smooth_texture(64, 4)};
    PassState state;
    state.modelview = view_matrix(camera);
    state.projection = projection_matrix(camera, 1.0);
    state.cull = CullFace::back;
    TextureUnitState unit;
    unit.texture = 0;
    unit.env = replace();
    unit.texgen = texgen_all(mode);
    unit.texgen.object_plane = {Vec4{0.3, 0.2, 0.1, 0.5}, Vec4{-0.1, 0.3, 0.2, 0.5}, Vec4{0.0},
                                Vec4{0.0}};
    unit.texgen.eye_plane = {Vec4{0.3, 0.1, 0.1, 0.8}, Vec4{-0.1, 0.3, 0.0, 0.5}, Vec4{0.0},
                             Vec4{0.0}};
    if (mode == TexGen::normal_map || mode == TexGen::reflection_map)
        unit.matrix = scale_and_offset(0.5, 0.5);
    state.units[0] = unit;
    frame.passes = {{state, 0}};
    return frame;
}

/// On float32's grid snapping moves a vertex by up to 1/32 pixel: of a rim of some 600 pixels a few
/// are drawn by one side only, and next to it, where the surface turns away and the reflected view
/// turns twice as fast, a place in the texture moves by more than a texel of 4 steps. On the finer
/// grids of gl13 and ideal64 neither happens.
std::vector<Check> texgen_checks() {
    constexpr std::array names{"none",       "object_linear", "eye_linear",
                               "sphere_map", "normal_map",    "reflection_map"};
    std::vector<Check> checks;
    for (std::size_t m = 1; m < names.size(); ++m) {
        const auto frames = [=] {
            return std::vector<Frame>{texgen_frame(static_cast<TexGen>(m))};
        };
        checks.push_back({fmt::format("texgen {}", names[m]),
                          {1, 4},
                          1,
                          frames,
                          {},
                          {Preset::gl13, Preset::ideal64}});
        checks.push_back({fmt::format("texgen {}, 1/16 pixel grid", names[m]),
                          {5, 10},
                          1,
                          frames,
                          {},
                          {Preset::float32}});
    }
    return checks;
}

/// Coordinates from -1 to 2 over 48 texels and 160 pixels: no pixel centre lies on a texel's edge
/// or centre, where a last bit would choose the texels.
Frame wrap_frame(Wrap s, Wrap t, Filter filter, BaseFormat format) {
    Frame frame = empty_frame(160);
    frame.meshes = {squares(1, 4, true)};
    frame.textures = {random_texture(5, 16, format)};
    TextureUnitState unit = nearest_unit(0, replace());
    unit.min_filter = unit.mag_filter = filter;
    unit.wrap_s = s;
    unit.wrap_t = t;
    unit.matrix = scale_and_offset(3.0, -1.0);
    unit.border_color = color_of({255, 60, 120, 180});
    PassState state;
    state.units[0] = unit;
    frame.passes = {{state, 0}};
    return frame;
}

std::vector<Frame> wrap_frames(Wrap wrap, Filter filter) {
    std::vector<Frame> frames;
    for (int other = 0; other < 5; ++other)
        frames.push_back(wrap_frame(wrap, static_cast<Wrap>(other), filter, BaseFormat::rgba));
    frames.push_back(wrap_frame(wrap, wrap, filter, BaseFormat::luminance));
    return frames;
}

/// Nearest texels are whole bytes and arrive as they are. Bilinear ones are rounded once by both;
/// weights of 8 bits, applied along s and along t, cost up to 2 steps more where texels are black
/// and white side by side.
std::vector<Check> wrap_checks() {
    constexpr std::array names{"repeat", "clamp", "clamp_to_edge", "clamp_to_border",
                               "mirrored_repeat"};
    std::vector<Check> checks;
    for (std::size_t w = 0; w < names.size(); ++w)
        for (const Filter filter : {Filter::nearest, Filter::linear}) {
            const bool linear = filter == Filter::linear;
            checks.push_back({fmt::format("wrap {}, {}", names[w], linear ? "linear" : "nearest"),
                              {linear ? 1 : 0, 0},
                              linear ? 2 : 0,
                              [=] { return wrap_frames(static_cast<Wrap>(w), filter); }});
        }
    return checks;
}

/// Gallium's state tracker strips border texels before a driver sees them, so with Mesa only
/// lookups that read none can be compared: that they stay unread is what this shows.
std::vector<Frame> border_frames(Wrap wrap, Filter filter) {
    std::vector<Frame> frames = {wrap_frame(wrap, wrap, filter, BaseFormat::rgba)};
    frames[0].textures = {random_texture(6, 18)};
    frames[0].textures[0].border = 1;
    return frames;
}

std::vector<Check> border_checks() {
    std::vector<Check> checks;
    const auto add = [&](const char* name, Wrap wrap, Filter filter, const char* driver = "") {
        const int steps = filter == Filter::linear ? 1 : 0;
        checks.push_back({fmt::format("border texels {}", name), {steps, 0}, 2 * steps, [=] {
                              return border_frames(wrap, filter);
                          }});
        checks.back().driver = driver;
    };
    add("unread by repeat, linear", Wrap::repeat, Filter::linear);
    add("unread by clamp_to_edge, linear", Wrap::clamp_to_edge, Filter::linear);
    add("unread by mirrored_repeat, linear", Wrap::mirrored_repeat, Filter::linear);
    add("unread by clamp, nearest", Wrap::clamp, Filter::nearest);
    add("read by clamp, linear", Wrap::clamp, Filter::linear, "NVIDIA");
    add("read by clamp_to_border, nearest", Wrap::clamp_to_border, Filter::nearest, "NVIDIA");
    add("read by clamp_to_border, linear", Wrap::clamp_to_border, Filter::linear, "NVIDIA");
    return checks;
}

/// A smooth texture whose levels are told apart by their brightness.
Texture mipmapped_texture() {
    Texture texture = smooth_texture(64, 2);
    for (int size = 32, level = 1; size >= 1; size /= 2, ++level) {
        auto texels = std::get<std::vector<Rgba8>>(smooth_texture(size, 2 << level).texels);
        for (Rgba8& t : texels) t.b = static_cast<std::uint8_t>(40 * level);
        texture.mipmaps.push_back({size, size, std::move(texels)});
    }
    return texture;
}

/// A level of detail of exactly `octaves` + `bias` everywhere: every way of estimating it that
/// OpenGL allows agrees where the coordinates run along the picture's axes. The offset keeps the
/// pixel centres off the texels' edges.
Frame mipmap_frame(Filter filter, MipFilter mip, int octaves, double bias) {
    Frame frame = empty_frame(table_size);
    frame.meshes = {squares(1, 4, true)};
    frame.textures = {mipmapped_texture()};
    TextureUnitState unit = nearest_unit(0, replace());
    unit.min_filter = unit.mag_filter = filter;
    unit.mip_filter = mip;
    unit.wrap_s = unit.wrap_t = Wrap::repeat;
    unit.lod_bias = bias;
    unit.matrix = scale_and_offset(1 << octaves, 0.3 / 64.0);
    PassState state;
    state.units[0] = unit;
    frame.passes = {{state, 0}};
    return frame;
}

std::vector<Frame> mipmap_frames(Filter filter, MipFilter mip) {
    std::vector<Frame> frames;
    for (int octaves = 0; octaves < 5; ++octaves)
        for (const double bias : {-0.7, -0.25, 0.0, 0.2, 0.375, 0.6, 0.9})
            frames.push_back(mipmap_frame(filter, mip, octaves, bias));
    return frames;
}

/// Between two levels 40 steps apart in blue an 8-bit fraction is worth 40/256 step. Nearest texels
/// are whole bytes as long as levels are not blended.
std::vector<Check> mipmap_checks() {
    constexpr std::array filters{"nearest", "linear"};
    constexpr std::array mips{"off", "nearest", "linear"};
    std::vector<Check> checks;
    for (std::size_t f = 0; f < filters.size(); ++f)
        for (std::size_t m = 0; m < mips.size(); ++m)
            checks.push_back(
                {fmt::format("filter {}, mipmaps {}", filters[f], mips[m]),
                 {f + m / 2 == 0 ? 0 : 1, 0},
                 f + m / 2 == 0 ? 0 : 1,
                 [=] { return mipmap_frames(static_cast<Filter>(f), static_cast<MipFilter>(m)); }});
    return checks;
}

/// Every face its own levels: red tells the face, blue the level, green runs with the level's
/// texels.
Texture mipmapped_cube() {
    const auto image = [](int face, int size, int level) {
        auto texels = std::get<std::vector<Rgba8>>(smooth_texture(size, 2 << level).texels);
        for (Rgba8& t : texels) {
            t.r = static_cast<std::uint8_t>(40 * face + 20);
            t.b = static_cast<std::uint8_t>(40 * level);
        }
        return TextureImage{size, size, std::move(texels)};
    };
    const auto face = [&](int number) {
        auto [width, height, texels] = image(number, 64, 0);
        TextureFace result{width, height, std::move(texels)};
        for (int size = 32, level = 1; size >= 1; size /= 2, ++level)
            result.mipmaps.push_back(image(number, size, level));
        return result;
    };
    TextureFace base = face(0);
    Texture cube{base.width, base.height, std::move(base.texels), BaseFormat::rgba,
                 std::move(base.mipmaps)};
    for (int number = 1; number < 6; ++number) cube.cube_faces.push_back(face(number));
    return cube;
}

/// The picture as one face, `octaves` + `bias` levels below the base: (s, t) of the squares becomes
/// a direction whose component along `axis` is `sign`.
Frame cube_frame(Filter filter, MipFilter mip, int face, int octaves, double bias) {
    Frame frame = empty_frame(64 >> octaves);
    frame.meshes = {squares(1, 4, true)};
    frame.textures = {mipmapped_cube()};
    TextureUnitState unit = nearest_unit(0, replace());
    unit.target = TextureTarget::cube_map;
    unit.min_filter = unit.mag_filter = filter;
    unit.mip_filter = mip;
    unit.lod_bias = bias;
    const int axis = face / 2, u = (axis + 1) % 3, v = (axis + 2) % 3;
    Mat4 matrix{0.0};
    matrix[0][u] = matrix[1][v] = 2.0;
    matrix[3][u] = matrix[3][v] = -1.0;
    matrix[3][axis] = face % 2 == 0 ? 1.0 : -1.0;
    matrix[3][3] = 1.0;
    unit.matrix = matrix;
    PassState state;
    state.units[0] = unit;
    frame.passes = {{state, 0}};
    return frame;
}

/// A face magnified, where all wraps but one leave it.
std::vector<Frame> cube_wrap_frames() {
    std::vector<Frame> frames;
    for (int w = 0; w < 5; ++w) {
        frames.push_back(cube_frame(Filter::linear, MipFilter::off, w, 0, 0.0));
        frames.back().width = frames.back().height = 160;
        TextureUnitState& unit = *frames.back().passes[0].state.units[0];
        unit.wrap_s = unit.wrap_t = static_cast<Wrap>(w);
        unit.border_color = color_of({255, 60, 120, 180});
    }
    return frames;
}

std::vector<Check> cube_checks() {
    const auto frames = [](Filter filter, MipFilter mip) {
        std::vector<Frame> result;
        for (int face = 0; face < 6; ++face)
            for (int octaves = 0; octaves < 4; ++octaves)
                for (const double bias : {0.0, 0.375})
                    result.push_back(cube_frame(filter, mip, face, octaves, bias));
        return result;
    };
    std::vector<Check> checks = {
        {"cube map, nearest levels",
         {0, 0},
         0,
         [=] { return frames(Filter::nearest, MipFilter::nearest); }},
        {"cube map, linear levels",
         {1, 0},
         1,
         [=] { return frames(Filter::linear, MipFilter::linear); }},
        {"cube map, wraps at the edges of a face", {1, 0}, 1, cube_wrap_frames}};
    return checks;
}

}  // namespace

std::vector<Check> lookup_checks() {
    std::vector<Check> checks = texgen_checks();
    for (auto* more : {&wrap_checks, &border_checks, &mipmap_checks, &cube_checks})
        for (Check& check : more()) checks.push_back(std::move(check));
    return checks;
}

}  // namespace twofold::bench
