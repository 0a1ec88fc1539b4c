#include <catch2/catch.hpp>

#include "scenes/assets.hpp"
#include "scenes/frame.hpp"
#include "tests/scenes/scene_text.hpp"
#include "texunit/texture_limits.hpp"

/// The fixed function in scene files: short forms, overrides, limits, and what reaches the frame.

using namespace twofold;
using namespace twofold::scene_text;

namespace {

TextureUnitState unit_of(const std::string& unit) {
    return *parse(smallest, {"passes.0.units=[" + unit + "]"}).passes[0].state.units[0];
}

std::string pass_error(const std::string& field) {
    return error_of(smallest, {"passes.0." + field});
}

std::string unit_error(const std::string& unit) { return pass_error("units=[" + unit + "]"); }

std::string portion_error(const std::string& portion) {
    return pass_error(R"(combiners={"stages":[{"rgb":)" + portion + R"(}],"final":{}})");
}

std::string texture_error(const std::string& texture) {
    return error_of(smallest, {"textures.t=" + texture});
}

const std::string pass = "x.json: passes.0.";

}  // namespace

TEST_CASE("short forms of a unit say the same as the long ones") {
    CHECK(unit_of(R"({"filter":"nearest"})") ==
          unit_of(R"({"min_filter":"nearest","mag_filter":"nearest"})"));
    CHECK(unit_of(R"({"rgb_scale":4})") == unit_of(R"({"env":{"rgb_scale":4}})"));
    CHECK(unit_of(R"({"texgen":"eye_linear"})") ==
          unit_of(R"({"texgen":{"s":"eye_linear","t":"eye_linear","r":"eye_linear"}})"));
    CHECK(unit_of(R"({"texgen":"none"})") == TextureUnitState{});
    CHECK(unit_error(R"({"filter":"nearest","min_filter":"linear"})") ==
          pass + "units.0.filter: says the same as 'min_filter'");
    CHECK(unit_error(R"({"rgb_scale":2,"env":{"rgb_scale":2}})") ==
          pass + "units.0.rgb_scale: says the same as 'env.rgb_scale'");
}

TEST_CASE("overrides reach into the new fields") {
    const Scene scene =
        parse(smallest, {R"(passes.0.units=[{}])", "passes.0.units.0.env.mode=blend",
                         "passes.0.units.0.texgen.q=eye_linear", "passes.0.fog.mode=exp2",
                         "passes.0.blend.equation=max", "passes.0.dither=true",
                         "image.color_format=rgb565", "custom.register_bits=12"});
    const PassState& state = scene.passes[0].state;
    CHECK(state.units[0]->env.mode == TexEnvMode::blend);
    CHECK(state.units[0]->texgen.mode[3] == TexGen::eye_linear);
    CHECK(state.fog->mode == FogMode::exp2);
    CHECK(state.blend->equation == BlendEquation::max);
    CHECK(state.dither);
    CHECK(scene.image.color_format == ColorFormat::rgb565);
    CHECK(scene.custom.register_bits == 12);
}

TEST_CASE("a unit that cannot be is an error") {
    CHECK(unit_error(R"({"texgen":"eye_lineer"})") ==
          pass + "units.0.texgen: unknown value 'eye_lineer'; did you mean 'eye_linear'?");
    CHECK(unit_error(R"({"texgen":{"q":"normal_map"}})") ==
          pass + "units.0.texgen.q: q is not made from normals: none, object_linear or eye_linear");
    CHECK(unit_error(R"({"target":"rectangle","wrap_s":"repeat"})") ==
          pass + "units.0.target: a rectangle cannot repeat");
    CHECK(unit_error(R"({"target":"rectangle","mip_filter":"linear"})") ==
          pass + "units.0.target: a rectangle has one level and needs 'mip_filter' off");
    CHECK(unit_error("null,null,null,null,{}") == pass + "units: has 5 elements, not 0..4");
    CHECK(unit_error(R"({"env":{"combine_alpha":"dot3_rgb"}})").find("unknown value 'dot3_rgb'") !=
          std::string::npos);
    CHECK(error_of(smallest, {R"(textures.t.checkerboard={})",
                              R"(passes.0.units=[{"texture":"t","target":"cube_map"}])"}) ==
          pass + "units.0.target: the texture 't' is no cube map");
    CHECK(error_of(smallest, {R"(textures.t={"checkerboard":{},"border":1})",
                              R"(passes.0.units=[{"texture":"t","target":"rectangle"}])"}) ==
          pass + "units.0.target: a rectangle has no border, and the texture 't' has");
}

TEST_CASE("R18 only directions need an inverse of the modelview", "[hard][R18]") {
    const std::string singular = "passes.0.modelview=[0,0,0,0, 0,0,0,0, 0,0,0,0, 0,0,0,1]";
    for (const std::string mode : {"sphere_map", "normal_map", "reflection_map"})
        CHECK(error_of(smallest, {singular, R"(passes.0.units=[{"texgen":")" + mode + "\"}]"}) ==
              pass +
                  "modelview: its upper left 3x3 part has no inverse, which 'texgen' needs for "
                  "normals");
    for (const std::string mode : {"none", "object_linear", "eye_linear"})
        CHECK(error_of(smallest, {singular, R"(passes.0.units=[{"texgen":")" + mode + "\"}]"}) ==
              "accepted");
}

TEST_CASE("combiners that NV_register_combiners refuses are errors") {
    const std::string path = pass + "combiners.stages.0.rgb";
    CHECK(portion_error("{}") == "accepted");
    CHECK(portion_error(R"({"ab_output":"spare0","sum_output":"spare0"})") ==
          path + ": two outputs go to one register");
    CHECK(portion_error(R"({"ab_dot_product":true,"sum_output":"spare0"})") ==
          path + ".sum_output: a dot product leaves no sum: needs null");
    CHECK(portion_error(R"({"scale":"four","bias_by_negative_one_half":true})") ==
          path + ".bias_by_negative_one_half: goes with the scales one and two only");
    CHECK(portion_error(R"({"inputs":[{"source":"e_times_f"}]})").find("unknown value") !=
          std::string::npos);
    CHECK(portion_error(R"({"ab_output":"fog"})").find("unknown value 'fog'") != std::string::npos);
    CHECK(pass_error(R"(combiners={"stages":[],"final":{}})") ==
          pass + "combiners.stages: has 0 elements, not 1..8");
    CHECK(pass_error(R"(combiners={"stages":[{},{},{},{},{},{},{},{},{}],"final":{}})") ==
          pass + "combiners.stages: has 9 elements, not 1..8");
}

TEST_CASE("sizes and numbers of a pass have limits") {
    CHECK(pass_error(R"(scissor={"width":16385,"height":1})") ==
          pass + "scissor.width: 16385 is not in 0..16384");
    CHECK(pass_error(R"(scissor={"height":1})") == pass + "scissor: the field 'width' is missing");
    CHECK(pass_error(R"(fog={"mode":"linear","start":3,"end":3})") ==
          pass + "fog: 'start' and 'end' are equal, and linear fog divides by their difference");
    CHECK(error_of(smallest, {"image.depth_bits=20"}) ==
          "x.json: image.depth_bits: 20 is not one of 16, 24");
}

TEST_CASE("texels have as many bytes as their format asks for") {
    const std::string path = "x.json: textures.t.texels";
    CHECK(texture_error(R"({"texels":{"width":2,"height":1,"format":"rgb565","bytes":[1,2,3]}})") ==
          path + ".bytes: has 3 elements, not 4");
    CHECK(texture_error(R"({"texels":{"width":5,"height":4,"format":"dxt1","bytes":[]}})") ==
          path + ".bytes: has 0 elements, not 16");
    CHECK(texture_error(R"({"texels":{"width":65,"height":64,"format":"l8","bytes":[]}})") ==
          path + ": 65 x 64 are more than 4096 texels, which are for a file");
    CHECK(texture_error(R"({"texels":{"width":1,"height":1,"format":"l8","bytes":[256]}})") ==
          path + ".bytes.0: 256 is not in 0..255");
}

TEST_CASE("texels' base format is their format's unless it is said") {
    const auto base_format = [](const std::string& more) {
        const std::string texels =
            R"({"texels":{"width":1,"height":1,"format":"l8","bytes":[7]})" + more + "}";
        return parse(smallest, {"textures.t=" + texels}).textures.at("t").base_format;
    };
    CHECK(base_format("") == BaseFormat::luminance);
    CHECK(base_format(R"(,"base_format":"intensity")") == BaseFormat::intensity);
}

TEST_CASE("indices make whole primitives") {
    const auto error = [](const std::string& fields) {
        return error_of(smallest,
                        {R"(meshes.q={"vertices":{"positions":[[0,0,0]],)" + fields + "}}"});
    };
    CHECK(error(R"("primitive":"triangle_strip","indices":[0,0])") == "accepted");
    CHECK(error(R"("primitive":"quads","indices":[0,0,0])") ==
          "x.json: meshes.q.vertices.indices: has 3 elements, not a multiple of 4");
}

TEST_CASE("box mipmaps go down to one texel, the mean of the image") {
    const Scene scene =
        parse(smallest, {R"(textures.t={"checkerboard":{"width":4,"height":2},"mipmaps":"box"})"});
    const Texture texture = load_assets(scene).textures.at("t");
    REQUIRE(texture.mipmaps.size() == 2);
    CHECK(texture.mipmaps[0].width == 2);
    CHECK(texture.mipmaps[0].height == 1);
    CHECK(std::get<std::vector<Rgba32f>>(texture.mipmaps[1].texels) ==
          std::vector<Rgba32f>{{0.5F, 0.5F, 0.5F, 1.0F}});
    const Scene odd =
        parse(smallest, {R"(textures.t={"checkerboard":{"width":3},"mipmaps":"box"})"});
    CHECK_THROWS_AS(load_assets(odd), Error);
}

TEST_CASE("a border is counted by the image and halved on its own") {
    const Scene scene = parse(
        smallest,
        {R"(textures.t={"texels":{"width":4,"height":3,"format":"l8","bytes":[1,2,4,8, 16,32,64,128, 255,60,20,9]},)"
         R"("mipmaps":"box","border":1})"});
    const Texture texture = load_assets(scene).textures.at("t");
    CHECK(texture.border == 1);
    REQUIRE(texture.mipmaps.size() == 1);
    REQUIRE(texture.mipmaps[0].width == 3);
    REQUIRE(texture.mipmaps[0].height == 3);
    const auto& level = std::get<std::vector<Rgba32f>>(texture.mipmaps[0].texels);
    const std::array twice{2, 6, 16, 32, 96, 256, 510, 80, 18};
    for (std::size_t i = 0; i < twice.size(); ++i)
        CHECK(static_cast<double>(level[i][0]) == Approx(twice[i] / 510.0));
}

TEST_CASE("a border that cannot be is an error") {
    CHECK(error_of(smallest, {R"(textures.t={"checkerboard":{},"border":2})"}) ==
          "x.json: textures.t.border: 2 is not in 0..1");
    CHECK(error_of(smallest, {R"(textures.t={"texels":{"width":4,"height":4,"format":"dxt1",)"
                              R"("bytes":[0,0,0,0,0,0,0,0]},"border":1})"}) ==
          "x.json: textures.t.border: compressed texels have no border");
    const Scene thin =
        parse(smallest, {R"(textures.t={"checkerboard":{"width":2,"height":9},"border":1})"});
    CHECK_THROWS_WITH(load_assets(thin),
                      "texture 't': border: an image of 2 x 9 has nothing inside its border");
}

TEST_CASE("every face of a cube map has its own mipmaps") {
    std::string faces;
    for (int i = 0; i < 6; ++i)
        faces += std::string(i ? "," : "") +
                 R"({"texels":{"width":2,"height":2,"format":"l8","bytes":[)" +
                 std::to_string(40 * i) + ",0,0,0]}}";
    const Scene scene =
        parse(smallest, {R"(textures.c={"cube":{"faces":[)" + faces + R"(]},"mipmaps":"box"})"});
    const Texture cube = load_assets(scene).textures.at("c");
    REQUIRE(cube.mipmaps.size() == 1);
    REQUIRE(cube.cube_faces.size() == 5);
    for (std::size_t i = 0; i < 5; ++i) {
        const auto& levels = cube.cube_faces[i].mipmaps;
        REQUIRE(levels.size() == 1);
        CHECK(static_cast<double>(std::get<std::vector<Rgba32f>>(levels[0].texels)[0][0]) ==
              Approx(10.0 * static_cast<double>(i + 1) / 255.0));
    }
}

namespace {
/// The text of the error that drawing one textured quad under the preset gives, or "drawn".
std::string size_error(const std::string& texture, const std::string& target, Preset preset) {
    const Scene scene =
        parse(smallest, {"textures.t=" + texture,
                         R"(passes.0.units=[{"texture":"t","target":")" + target + "\"}]"});
    try {
        make_frame(scene, load_assets(scene), {}, preset);
    } catch (const Error& error) {
        return error.what();
    }
    return "drawn";
}

std::string board(int width, int height, const std::string& more = "") {
    return R"({"checkerboard":{"width":)" + std::to_string(width) + R"(,"height":)" +
           std::to_string(height) + "}" + more + "}";
}
}  // namespace

TEST_CASE("T09 nv17 refuses by name the texture sizes that the chip refuses", "[hard][T09]") {
    const auto nv17 = [](const std::string& texture, const std::string& target = "texture_2d") {
        return size_error(texture, target, Preset::nv17);
    };
    CHECK(nv17(board(1000, 500)) ==
          "x.json: textures.t: 1000 x 500: preset nv17 takes powers of two as sides up to 2048 for "
          "a texture_2d");
    CHECK(nv17(board(2048, 1)) == "drawn");
    CHECK(nv17(board(4096, 1)) ==
          "x.json: textures.t: 4096 x 1: preset nv17 takes powers of two as sides up to 2048 for a "
          "texture_2d");
    CHECK(nv17(board(1000, 500), "rectangle") == "drawn");
    CHECK(nv17(board(2048, 3), "rectangle") ==
          "x.json: textures.t: 2048 x 3: preset nv17 takes sides up to 2047 for a rectangle");
    CHECK(nv17(board(10, 4, R"(,"border":1)")) == "drawn");
    CHECK(nv17(board(8, 8, R"(,"border":1)")).find("6 x 6") != std::string::npos);
    for (const Preset preset : {Preset::ideal64, Preset::float32, Preset::gl13, Preset::coarse8})
        CHECK(size_error(board(1000, 500), "texture_2d", preset) == "drawn");
}

TEST_CASE("T09 cube maps of nv17 are larger where a texel has fewer bits", "[hard][T09]") {
    const auto limit = [](const Texels& texels) {
        return size_limit(Preset::nv17, TextureTarget::cube_map, {1, 1, texels})->largest;
    };
    CHECK(limit(std::vector<Rgba8>{}) == 512);
    for (const TextureFormat format :
         {TextureFormat::argb8888, TextureFormat::xrgb8888, TextureFormat::la88,
          TextureFormat::dxt3, TextureFormat::dxt5})
        CHECK(limit(PackedTexels{format, {}}) == 512);
    for (const TextureFormat format :
         {TextureFormat::rgb565, TextureFormat::argb4444, TextureFormat::i8, TextureFormat::dxt1})
        CHECK(limit(PackedTexels{format, {}}) == 1024);
}

TEST_CASE("the frame holds what the scene says of image, cube maps and four units") {
    const std::string face = R"({"checkerboard":{}})";
    std::string faces = face;
    for (int i = 0; i < 5; ++i) faces += "," + face;
    const Scene scene = parse(
        smallest, {"image.color_format=xrgb1555_o", "image.depth_bits=16", "image.clear_depth=0.5",
                   R"(textures.c={"cube":{"faces":[)" + faces + "]}}",
                   R"(passes.0.units=[null,null,null,{"texture":"c","target":"cube_map"}])"});
    const Frame frame = make_frame(scene, load_assets(scene), {}, Preset::nv17);
    CHECK(frame.color_format == ColorFormat::xrgb1555_o);
    CHECK(frame.depth_bits == 16);
    CHECK(frame.clear_depth == 0.5);
    CHECK(frame.textures.at(0).cube_faces.size() == 5);
    CHECK(frame.passes[0].state.units[3]->texture == 0U);
}
