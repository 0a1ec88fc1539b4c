#include <catch2/catch.hpp>
#include <fstream>

#include "bench/draw/drawing.hpp"
#include "bench/draw/inputs.hpp"
#include "raster/reference.hpp"
#include "tests/temporary_folder.hpp"
#include "texunit/error.hpp"

using namespace twofold;
using namespace twofold::bench;

namespace {

const std::string identity =
    " 0x1p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x1p+0 0x0p+0 0x0p+0"
    " 0x0p+0 0x0p+0 0x1p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x1p+0\n";

const std::string manifest =
    "variant tex2-persp\nsize 8 8\nvertices 4\ntriangles 2\ntexture 2 2\ncube 1\n# a comment\n"
    "alpha_func GREATER 0.5\ndepth_func LEQUAL\ndepth_bits 24\ncull BACK\nclear 0 0 0 0\n"
    "color_bits 8 8 8 8\nmodelview" +
    identity + "projection" + identity + "texture0_front" + identity + "texture0_back" + identity +
    "texture1_front" + identity + "texture1_back" + identity;

template <class T>
void write_array(const std::filesystem::path& file, const std::vector<T>& values) {
    std::ofstream(file, std::ios::binary)
        .write(reinterpret_cast<const char*>(values.data()),
               static_cast<std::streamsize>(values.size() * sizeof(T)));
}

/// The dump of a white quad over the whole picture.
class QuadDump {
  public:
    QuadDump() {
        const std::vector<float> corners{-1, -1, 1, -1, 1, 1, -1, 1};
        std::vector<float> position, clip;
        for (std::size_t i = 0; i < 8; i += 2) {
            position.insert(position.end(), {corners[i], corners[i + 1], 0});
            clip.insert(clip.end(), {2 * corners[i], 2 * corners[i + 1], 0, 2});
        }
        write_text(manifest);
        write_array(folder_ / "position.f32x3", position);
        write_array(folder_ / "normal.f32x3", position);
        write_array(folder_ / "clip.f32x4", clip);
        write_array(folder_ / "uv0.f32x2", std::vector<float>(8, 0.5f));
        write_array(folder_ / "uv1.f32x2", std::vector<float>(8, 0.25f));
        write_array(folder_ / "color.u8x4", std::vector<Rgba8>(4, {255, 255, 255, 255}));
        write_array(folder_ / "index.u32", std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3});
        for (const char* name : {"0_front", "0_back", "1_front", "1_back"})
            write_array(folder_ / ("tex" + std::string(name) + ".rgba8"),
                        std::vector<Rgba8>(4, {255, 255, 255, 255}));
    }
    void write_text(const std::string& text) const {
        std::ofstream(folder_ / "manifest.txt") << text;
    }
    /// The manifest with its first `from` turned into `to`.
    void change(const std::string& from, const std::string& to) const {
        std::string text = manifest;
        text.replace(text.find(from), from.size(), to);
        write_text(text);
    }
    std::filesystem::path operator/(const std::string& name) const { return folder_ / name; }
    const std::filesystem::path& path() const { return folder_.path(); }

  private:
    TemporaryFolder folder_;
};

std::string complaint(const QuadDump& dump) {
    try {
        read_dump(dump.path());
    } catch (const Error& error) {
        CHECK(error.code() == ExitCode::bad_file);
        return error.what();
    }
    return "none";
}

}  // namespace

TEST_CASE("A peer's dump is read and drawn") {
    const QuadDump dump;
    const Inputs inputs = read_dump(dump.path());
    CHECK(inputs.drawing == "tex2-persp");
    CHECK(inputs.size == 8);
    CHECK(inputs.triangles() == 2);
    CHECK(inputs.mesh.texcoords[1][3] == Vec4(0.25, 0.25, 0.0, 1.0));
    CHECK(inputs.clip[2] == Vec4(2, 2, 0, 2));
    CHECK(inputs.texture_matrices[1][1] == Mat4{1.0});
    const Framebuffer picture = render_reference(frame_of(inputs), Preset::nv17);
    CHECK(picture.bytes == std::vector<Rgba8>(64, Rgba8{255, 255, 255, 255}));
}

TEST_CASE("A dump without a file is an error that names it") {
    const QuadDump dump;
    const std::string missing = GENERATE("manifest.txt", "position.f32x3", "uv1.f32x2",
                                         "clip.f32x4", "tex1_back.rgba8", "index.u32");
    std::filesystem::remove(dump / missing);
    CHECK_THAT(complaint(dump), Catch::Contains(missing));
}

TEST_CASE("A dump with an array of another size is an error that names file and sizes") {
    const QuadDump dump;
    SECTION("too short") {
        write_array(dump / "normal.f32x3", std::vector<float>(11));
        CHECK_THAT(complaint(dump), Catch::Contains("normal.f32x3: 44 bytes, not 48"));
    }
    SECTION("too long") {
        write_array(dump / "normal.f32x3", std::vector<float>(13));
        CHECK_THAT(complaint(dump), Catch::Contains("normal.f32x3"));
    }
    SECTION("empty") {
        write_array(dump / "tex0_front.rgba8", std::vector<Rgba8>{});
        CHECK_THAT(complaint(dump), Catch::Contains("tex0_front.rgba8: 0 bytes, not 16"));
    }
}

TEST_CASE("An index that names no vertex is an error") {
    const QuadDump dump;
    write_array(dump / "index.u32", std::vector<std::uint32_t>{0, 1, 2, 0, 2, 4});
    CHECK_THAT(complaint(dump), Catch::Contains("index.u32: 4 names none of 4 vertices"));
}

TEST_CASE("A manifest's wrong field is an error that names it") {
    struct Wrong {
        std::string from, to, text;
    };
    const auto wrong = GENERATE(
        Wrong{"vertices 4\n", "", "vertices: is missing"},
        Wrong{"vertices 4", "vertices -4", "vertices: -4 is not a number from 1"},
        Wrong{"vertices 4", "vertices 4x", "vertices: 4x is not a number"},
        Wrong{"vertices 4", "vertices 99999999999999999999", "vertices: 99999999999999999999"},
        Wrong{"vertices 4", "vertices", "vertices: has 0 values, not 1"},
        Wrong{"triangles 2", "triangles 0", "triangles: 0 is not"},
        Wrong{"size 8 8", "size 8 9", "size: 8 x 9 is no square"},
        Wrong{"texture 2 2", "texture 999999 999999", "texture: 999999"},
        Wrong{"modelview 0x1p+0", "modelview 1.0", "modelview: 1.0 is not a hexadecimal number"},
        Wrong{"modelview 0x1p+0", "modelview 0xzz", "modelview: 0xzz"},
        Wrong{"modelview 0x1p+0", "modelview", "modelview: has 15 values, not 16"},
        Wrong{"depth_func LEQUAL", "depth_func LESS", "depth_func: LESS is not LEQUAL"},
        Wrong{"cull BACK", "cull FRONT", "cull: FRONT is not BACK"});
    const QuadDump dump;
    dump.change(wrong.from, wrong.to);
    CHECK_THAT(complaint(dump), Catch::Contains("manifest.txt: " + wrong.text));
}

TEST_CASE("A drawing that is not known is an error that names it") {
    const QuadDump dump;
    dump.change("tex2-persp", "cube2");
    CHECK_THROWS_WITH(frame_of(read_dump(dump.path())), Catch::Contains("cube2"));
}

TEST_CASE("Inputs made without a peer cover their picture with every drawing") {
    const auto covered = [](const std::string& drawing, int squares) {
        const Frame frame = frame_of(make_inputs(drawing, squares, 32));
        const auto bytes = render_reference(frame, Preset::nv17).bytes;
        return 1024 - std::count(bytes.begin(), bytes.end(), Rgba8{});
    };
    CHECK(covered("tex2-persp", 0) == 1024);
    CHECK(covered("tex1-nearest", 0) == 1024);
    const auto sphere = covered("tex2-persp", 8);
    CHECK(sphere > 300);
    CHECK(covered("para4", 8) == sphere);
}
