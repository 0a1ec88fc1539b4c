#include "tests/raster/random/random_state.hpp"

#include "raster/color_format.hpp"
#include "scenes/box_mipmaps.hpp"
#include "tests/raster/builders.hpp"
#include "tests/raster/random/random_parts.hpp"
#include "texunit/byte_arithmetic.hpp"
#include "texunit/presets.hpp"

namespace twofold::test {
namespace {

/// Fragments that a frame makes at most, about: what a state costs.
constexpr double most_fragments = 8000.0;

CustomSettings random_custom(Dice& dice) {
    CustomSettings s;
    if (dice.chance(0.5)) s.filter_weight_bits = dice.integer(1, 16);
    if (dice.chance(0.5)) s.filter_rounding = dice.up_to(FilterRounding::once);
    if (dice.chance(0.5)) s.product_rounding = dice.up_to(ProductRounding::shift);
    if (dice.chance(0.5)) s.register_bits = dice.integer(8, 24);
    if (dice.chance(0.5)) s.vertex_color = dice.up_to(VertexColorRounding::real);
    if (dice.chance(0.3)) s.texel_bits = dice.integer(4, 16);
    if (dice.chance(0.3)) s.snap_bits = dice.integer(0, 12);
    if (dice.chance(0.3)) s.snap_bias = dice.one_of({0.0, 0.5, -0.25, 1.0 / 32});
    if (dice.chance(0.3)) s.framebuffer_bits = dice.one_of({0, 0, 4, 5, 6, 7, 8});
    return s;
}

FastOptions options_of(std::uint64_t number) {
    constexpr std::array threads{1, 2, 7};
    const std::uint64_t round = number / (all_presets.size() + 1);
    return {threads[round % 3], round / 3 % 4 != 3};
}

/// Most pictures are tiny; tiles of 64 pixels begin and end within others.
std::pair<int, int> random_size(Dice& dice) {
    const double kind = dice.unit();
    if (kind < 0.6) return {dice.integer(1, 24), dice.integer(1, 24)};
    if (kind < 0.75) return {dice.integer(60, 70), dice.integer(1, 12)};
    if (kind < 0.85) return {dice.integer(1, 12), dice.integer(60, 70)};
    if (kind < 0.97) return {dice.integer(40, 72), dice.integer(40, 72)};
    return {dice.integer(100, 160), dice.integer(70, 130)};
}

/// Where the format has no alpha, that which drawing stores: passes can draw the picture then.
ByteImage random_picture(Dice& dice, const Frame& frame) {
    const FormatBits format = bits_of(frame.color_format);
    ByteImage image{frame.width, frame.height, {}};
    for (int i = 0; i < frame.width * frame.height; ++i) {
        image.pixels.push_back(byte_color(random_color(dice)));
        if (!format.has_alpha)
            image.pixels.back().a = static_cast<std::uint8_t>(rn8(format.stored_alpha));
    }
    return image;
}

/// Any with alpha 0, or one of bytes: what a scene file can say.
Vec4 random_clear_color(Dice& dice, ColorFormat format) {
    Vec4 color = random_color(dice);
    if (!bits_of(format).has_alpha || dice.chance(0.4))
        color.w = 0.0;
    else
        for (int c = 0; c < 4; ++c) color[c] = rn8(color[c]) / 255.0;
    return color;
}

Frame random_target(Dice& dice) {
    Frame frame;
    std::tie(frame.width, frame.height) = random_size(dice);
    if (dice.chance(0.1)) frame.clear_depth = dice.one_of({0.0, 0.5, 0.75, 0.9});
    if (dice.chance(0.3)) frame.color_format = dice.up_to(ColorFormat::xrgb1555_o);
    frame.clear_color = random_clear_color(dice, frame.color_format);
    frame.depth_bits = dice.one_of({16, 24, 24});
    if (dice.chance(0.1)) frame.initial_color = random_picture(dice, frame);
    return frame;
}

/// How many units and general combiner stages the preset's chip has.
struct Chip {
    int units, stages;
};

Chip chip_of(Preset preset) {
    return with_model(preset, [](const auto& m) {
        return Chip{m.texture_units, m.combiner_stages};
    });
}

View view_of_frame(Dice& dice, const Frame& frame) {
    return random_view(dice, frame.width, frame.height, dice.up_to(Space::perspective));
}

/// Passes with any state over one mesh, or over one each.
void add_any_passes(Dice& dice, Frame& frame, const Chip& chip) {
    for (int n = dice.integer(1, 3); n > 0; --n) frame.textures.push_back(random_texture(dice));
    const int passes = dice.chance(0.5) ? 1 : dice.integer(2, 4);
    const bool one_mesh = dice.chance(0.5);
    View view = view_of_frame(dice, frame);
    frame.meshes.push_back(random_mesh(dice, view, most_fragments / passes));
    for (int n = 0; n < passes; ++n) {
        if (n > 0 && !one_mesh) {
            view = view_of_frame(dice, frame);
            frame.meshes.push_back(random_mesh(dice, view, most_fragments / passes));
        }
        frame.passes.push_back({random_pass(dice, view, frame.textures, chip.units, chip.stages),
                                frame.meshes.size() - 1});
    }
}

/// Two MODULATE units of plain two-dimensional textures by the vertices' own coordinates.
TextureUnitState plain_unit(Dice& dice, std::size_t texture) {
    TextureUnitState unit;
    unit.texture = texture;
    unit.wrap_s = unit.wrap_t = dice.one_of({Wrap::clamp_to_edge, Wrap::repeat});
    if (dice.chance(0.1)) unit.min_filter = unit.mag_filter = Filter::nearest;
    return unit;
}

TextureUnitState face_unit(TexGen texgen, Face face, std::size_t texture, const View& view) {
    TextureUnitState unit;
    unit.texture = texture;
    unit.texgen = texgen_all(texgen);
    Mat4 inverse{1.0};
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) inverse[i][j] = view.modelview[j][i];
    unit.matrix = paraboloid_matrix(face, map_guard) * inverse;
    return unit;
}

/// What all passes over the surface have in common.
PassState common_state(Dice& dice, const View& view) {
    PassState state;
    state.modelview = view.modelview;
    state.projection = view.projection;
    state.window_space = view.space == Space::window;
    state.color = random_color(dice);
    if (dice.chance(0.7)) state.color.w = 1.0;
    state.cull = dice.one_of({CullFace::none, CullFace::back, CullFace::none});
    state.alpha_test = AlphaTest{CompareFunc::gequal, dice.one_of({0.5, 1.0, 0.25})};
    if (!dice.chance(0.15))
        state.depth_test =
            DepthTest{dice.one_of({CompareFunc::lequal, CompareFunc::lequal, CompareFunc::less}),
                      !dice.chance(0.1)};
    if (dice.chance(0.1)) state.perspective_correction = false;
    return state;
}

/// The four passes of the paper: front or back of the normal's map times front or back of the
/// reflection's.
void add_face_passes(Dice& dice, Frame& frame, const View& view) {
    const int size = dice.one_of({4, 8, 16, 17});
    for (int i = 0; i < 4; ++i) frame.textures.push_back(random_disc(dice, size, map_guard));
    const PassState common = common_state(dice, view);
    const int scale = dice.one_of({1, 1, 2, 4});
    constexpr std::array faces{Face::front, Face::back};
    for (std::size_t i = 0; i < 2; ++i)
        for (std::size_t j = 0; j < 2; ++j) {
            PassState state = common;
            state.units[0] = face_unit(TexGen::normal_map, faces[i], i, view);
            state.units[1] = face_unit(TexGen::reflection_map, faces[j], 2 + j, view);
            state.units[1]->env.rgb_scale = scale;
            frame.passes.push_back({state, 0});
        }
}

/// Several alpha-tested passes by the vertices' own coordinates.
void add_plain_passes(Dice& dice, Frame& frame, const View& view) {
    for (int i = 0; i < 3; ++i) frame.textures.push_back(random_texture(dice));
    const PassState common = common_state(dice, view);
    for (int n = dice.integer(1, 4); n > 0; --n) {
        PassState state = common;
        if (dice.chance(0.5)) state.alpha_test->reference = 1.0 / 255;
        state.units[0] = plain_unit(dice, dice.index(frame.textures.size()));
        if (!dice.chance(0.2)) state.units[1] = plain_unit(dice, dice.index(frame.textures.size()));
        for (auto& unit : state.units)
            if (unit && !frame.textures[*unit->texture].cube_faces.empty())
                unit->target = TextureTarget::cube_map;
        frame.passes.push_back({state, 0});
    }
}

/// C = Cs Cd + Cd or Cs + Cd where the object shows: doubles it.
PassState doubling_pass(Dice& dice, const PassState& common) {
    PassState state = common;
    state.units = {};
    state.alpha_test.reset();
    state.depth_test = DepthTest{CompareFunc::equal, false};
    state.blend = Blend{dice.one_of({BlendFactor::dst_color, BlendFactor::one}), BlendFactor::one};
    return state;
}

void add_paper_passes(Dice& dice, Frame& frame) {
    const bool faces = dice.chance(0.6);
    const View view = faces ? random_view(dice, frame.width, frame.height, Space::perspective)
                            : view_of_frame(dice, frame);
    frame.meshes.push_back(dice.chance(0.7) ? random_surface(dice, view, most_fragments / 4)
                                            : random_mesh(dice, view, most_fragments / 4));
    if (faces)
        add_face_passes(dice, frame, view);
    else
        add_plain_passes(dice, frame, view);
    if (dice.chance(0.2))
        frame.passes.push_back({doubling_pass(dice, frame.passes.front().state), 0});
    for (int n = dice.chance(0.35) ? dice.integer(1, 2) : 0; n > 0; --n)
        disturb(dice, frame.passes[dice.index(frame.passes.size())].state, view);
}

/// Those of bytes or floats whose sides inside the border are powers of two.
void give_mipmaps(Texture& texture) {
    if (!has_sides_to_halve(texture.width, texture.height, texture.border) ||
        !texture.cube_faces.empty() || std::holds_alternative<PackedTexels>(texture.texels))
        return;
    texture.mipmaps = box_mipmaps(texture.width, texture.height, texture.texels, texture.border);
}

void choose_levels(Dice& dice, TextureUnitState& unit) {
    unit.mip_filter = dice.one_of({MipFilter::nearest, MipFilter::linear, MipFilter::linear});
    if (dice.chance(0.3)) unit.min_filter = dice.up_to(Filter::linear);
    if (dice.chance(0.3)) unit.mag_filter = dice.up_to(Filter::linear);
    unit.lod_bias = dice.one_of({-33.0, -1.0, 0.0, 0.0, 0.5, 1.0, 1.75, 2.25, 3.5, 4.0});
}

}  // namespace

RandomState random_state_with_levels(std::uint64_t seed, std::uint64_t number) {
    RandomState state = random_state(seed, number);
    Dice dice(~seed, number);
    for (Texture& texture : state.frame.textures) give_mipmaps(texture);
    // One choice for all passes: only so do they share what is known of their alphas.
    for (std::size_t u = 0; u < max_units; ++u) {
        TextureUnitState choice;
        choose_levels(dice, choice);
        for (Pass& pass : state.frame.passes)
            if (auto& unit = pass.state.units[u]; unit && unit->target == choice.target) {
                unit->mip_filter = choice.mip_filter;
                unit->min_filter = choice.min_filter;
                unit->mag_filter = choice.mag_filter;
                unit->lod_bias = choice.lod_bias;
            }
    }
    return state;
}

RandomState random_state(std::uint64_t seed, std::uint64_t number) {
    Dice dice(seed, number);
    RandomState state;
    const std::size_t k = number % (all_presets.size() + 1);
    state.preset = k < all_presets.size() ? all_presets[k] : Preset::custom;
    state.options = options_of(number);
    if (state.preset == Preset::custom) state.custom = random_custom(dice);
    state.frame = random_target(dice);
    if (dice.chance(0.5))
        add_paper_passes(dice, state.frame);
    else
        add_any_passes(dice, state.frame, chip_of(state.preset));
    return state;
}

}  // namespace twofold::test
