#include "scenes/scene_file.hpp"

#include <catch2/catch.hpp>

#include "tests/scenes/scene_text.hpp"

using namespace twofold;
using namespace twofold::scene_text;

namespace {

/// The error after the given change of the scene with one object.
std::string object_error(const std::string& change) { return error_of(one_object, {change}); }

/// The error after the given change of the scene with one pass.
std::string pass_error(const std::string& change) { return error_of(smallest, {change}); }

}  // namespace

TEST_CASE("an unknown field is an error that names file, path and the nearest field") {
    CHECK(object_error("materials.gold.cook_torrance.f1=0.5") ==
          "x.json: materials.gold.cook_torrance.f1: unknown field; did you mean 'f0'?");
    CHECK(object_error("camra.eye=[0,0,1]") ==
          "x.json: camra: unknown field; did you mean 'camera'?");
    CHECK(pass_error("passes.0.depth_tset={}") ==
          "x.json: passes.0.depth_tset: unknown field; did you mean 'depth_test'?");
    CHECK(pass_error("meshes.q.quad.size=1") == "x.json: meshes.q.quad.size: unknown field");
}

TEST_CASE("a number outside its range is an error that states number and range") {
    CHECK(object_error("image.width=1000000000") ==
          "x.json: image.width: 1000000000 is not in 1..16384");
    CHECK(object_error("image.height=0") == "x.json: image.height: 0 is not in 1..16384");
    CHECK(object_error("factorization.samples=1e12") ==
          "x.json: factorization.samples: 1000000000000.0 is not in 1..10000000");
    CHECK(object_error("factorization.map_size=3") ==
          "x.json: factorization.map_size: 3 is not in 4..512");
    CHECK(object_error("environment.cells=1048577") ==
          "x.json: environment.cells: 1048577 is not in 1..1048576");
    CHECK(object_error("camera.vertical_fov_degrees=180") ==
          "x.json: camera.vertical_fov_degrees: 180 is not in 0..180 (0 and 180 excluded)");
    CHECK(object_error("materials.gold.cook_torrance.f0=1") ==
          "x.json: materials.gold.cook_torrance.f0: 1 is not in 0..1 (1 excluded)");
    CHECK(object_error("image.background=[0,2,0]") ==
          "x.json: image.background.1: 2 is not in 0..1");
    CHECK(object_error("image.width=18446744073709551615") ==
          "x.json: image.width: 18446744073709551615 is not in 1..16384");
}

TEST_CASE("a value of the wrong kind is an error that shows it") {
    CHECK(object_error("image.width=\"8\"") == "x.json: image.width: '8' is not a number");
    CHECK(object_error("image.width=1.5") == "x.json: image.width: 1.5 is not a whole number");
    CHECK(object_error("image=[]") == "x.json: image: a list is not an object");
    CHECK(object_error("camera.eye=[1,2]") == "x.json: camera.eye: has 2 elements, not 3");
    CHECK(object_error("camera.eye=null") == "x.json: camera.eye: null is not a list");
    CHECK(object_error("title=7") == "x.json: title: 7 is not a text");
    CHECK(object_error("objects=7") == "x.json: objects: 7 is not a list");
    CHECK(object_error("materials=7") == "x.json: materials: 7 is not an object");
    CHECK(object_error("image.background=\"red\"") ==
          "x.json: image.background: 'red' is neither [r, g, b] nor one number");
    CHECK(object_error("factorization.column_scaling=1") ==
          "x.json: factorization.column_scaling: 1 is neither true nor false");
    CHECK(error_of("7") == "x.json: 7 is not an object");
    CHECK(pass_error("passes.0.units=[{\"rgb_scale\":3}]") ==
          "x.json: passes.0.units.0.rgb_scale: 3 is not one of 1, 2, 4");
}

TEST_CASE("a wrong name is an error that offers the nearest one") {
    CHECK(object_error("objects.0.mesh=suzane") ==
          "x.json: objects.0.mesh: no mesh named 'suzane'; did you mean 'suzanne'?");
    CHECK(object_error("objects.0.material=god") ==
          "x.json: objects.0.material: no material named 'god'; did you mean 'gold'?");
    CHECK(pass_error("passes.0.mesh=r") ==
          "x.json: passes.0.mesh: no mesh named 'r'; did you mean 'q'?");
    CHECK(pass_error("passes.0.units=[null,{\"texture\":\"wood\"}]") ==
          "x.json: passes.0.units.1.texture: no texture named 'wood'");
    CHECK(object_error("presets=[\"nv18\"]") ==
          "x.json: presets.0: no preset named 'nv18'; did you mean 'nv17'?");
    CHECK(object_error("presets=[\"gl13\",\"gl13\"]") ==
          "x.json: presets.1: 'gl13' is named twice");
    CHECK(pass_error("passes.0.cull=bakc") ==
          "x.json: passes.0.cull: unknown value 'bakc'; did you mean 'back'?");
    CHECK(object_error("factorization.view_knots=1") ==
          "x.json: factorization.view_knots: 1 is neither 0 nor in 2..256");
    CHECK(object_error("factorization.stagnation_window=-1") ==
          "x.json: factorization.stagnation_window: -1 is not in 0..100000");
    CHECK(object_error("factorization.keep_best=no") ==
          "x.json: factorization.keep_best: 'no' is neither true nor false");
    CHECK(object_error("factorization.solver=lsqr") ==
          "x.json: factorization.solver: unknown value 'lsqr'; did you mean 'lsmr'?");
}

TEST_CASE("R17 a camera whose picture is not defined is an error that names the field",
          "[hard][R17]") {
    CHECK(object_error("camera={\"near\":2,\"far\":2}") ==
          "x.json: camera.far: 2 is not greater than 'near', which is 2");
    CHECK(object_error("camera.near=200") ==
          "x.json: camera: 'far' 100 is not greater than 'near', which is 200");
    CHECK(object_error("camera.near=0") ==
          "x.json: camera.near: 0 is not in 0..1000000000 (0 excluded)");
    CHECK(object_error("camera={\"eye\":[1,2,3],\"target\":[1,2,3]}") ==
          "x.json: camera.target: is the same point as 'eye'");
    CHECK(object_error("camera.up=[0,0,-5]") ==
          "x.json: camera.up: is parallel to the direction from 'eye' to 'target'");
    CHECK(object_error("camera.up=[0,0,0]") == "x.json: camera.up: is zero");
}

TEST_CASE("R18 a modelview without inverse is an error only where normals need it", "[hard][R18]") {
    const std::string rank_0 = "[0,0,0,0, 0,0,0,0, 0,0,0,0, 0,0,0,1]";
    const std::string rank_2 = "[1,2,3,0, 4,5,6,0, 7,8,9,0, 0,0,0,1]";
    const std::string decimal = "[0.1,0.2,0.3,0, 0.4,0.5,0.6,0, 0.7,0.8,0.9,0, 0,0,0,1]";
    const std::string small = "[1e-6,0,0,0, 0,1e-6,0,0, 0,0,1e-6,0, 0,0,0,1]";
    const std::string texgen = R"(passes.0.units=[{"texgen":"reflection_map"}])";
    const std::string expected =
        "x.json: passes.0.modelview: its upper left 3x3 part has no inverse, which 'texgen' needs "
        "for normals";
    for (const std::string& matrix : {rank_0, rank_2, decimal}) {
        CHECK(error_of(smallest, {"passes.0.modelview=" + matrix, texgen}) == expected);
        CHECK(error_of(smallest, {"passes.0.modelview=" + matrix}) == "accepted");
    }
    CHECK(error_of(smallest, {"passes.0.modelview=" + small, texgen}) == "accepted");
}

TEST_CASE("a light without direction and lobes that do not sum to 1 are errors") {
    CHECK(object_error("environment.directional.0.direction=[0,0,0]") ==
          "x.json: environment.directional.0.direction: [0, 0, 0] is zero and has no direction");
    CHECK(object_error("materials.gold.cook_torrance.lobes=[{\"m\":0.1,\"weight\":0.5}]") ==
          "x.json: materials.gold.cook_torrance.lobes: the weights sum to 0.5, not 1");
}

TEST_CASE("a choice takes exactly one of its kinds") {
    CHECK(object_error("environment.latlong=a.hdr") ==
          "x.json: environment: has both 'latlong' and 'directional', needs one");
    CHECK(
        object_error("environment={}") ==
        "x.json: environment: needs one of: latlong, probe, cube_cross, cube_strip, cube_openexr, "
        "dual_paraboloid, painted, directional");
    CHECK(object_error("environment.repair=true") ==
          "x.json: environment.repair: belongs to a picture's file and there is none");
    const std::string pictured = "environment={\"probe\": \"e.exr\"}";
    CHECK(error_of(one_object, {pictured, "environment.guard=0.5"}) ==
          "x.json: environment.guard: belongs to 'dual_paraboloid'");
    CHECK(error_of(one_object, {pictured, "environment.orientation={\"up\":[0,0,2]}"}) ==
          "x.json: environment.orientation: 'forward' and 'up' span no plane");
    CHECK(error_of(one_object, {"environment={\"probe\": \"../e.exr\"}"})
              .find("environment.probe: '../e.exr' leads out") != std::string::npos);
    CHECK(object_error("meshes.suzanne={}") ==
          "x.json: meshes.suzanne: needs one of: file, sphere, quad, vertices");
}

TEST_CASE("a scene needs something to draw, and objects need light") {
    CHECK(error_of("{}") ==
          "x.json: needs at least one element in 'objects', 'historical' or 'passes'");
    CHECK(object_error("environment=null") ==
          "x.json: environment: is missing, and 'objects' are lit by it");
    CHECK(object_error("objects.0={\"mesh\":\"suzanne\"}") ==
          "x.json: objects.0: the field 'material' is missing");
}

TEST_CASE("vertices that do not fit together are errors") {
    const auto vertices_error = [](const std::string& fields) {
        return pass_error(R"(meshes.q={"vertices":{"positions":[[0,0,0],[1,0,0],[0,1,0]],)" +
                          fields + "}}");
    };
    const std::string path = "x.json: meshes.q.vertices.";
    CHECK(vertices_error(R"("indices":[0,1,2])") == "accepted");
    CHECK(vertices_error(R"("indices":[0,1,3])") == path + "indices.2: 3 is not in 0..2");
    CHECK(vertices_error(R"("indices":[0,1])") ==
          path + "indices: has 2 elements, not a multiple of 3");
    CHECK(vertices_error(R"("indices":[],"normals":[[0,0,1]])") ==
          path + "normals: has 1 elements, not 3");
    CHECK(vertices_error(R"("indices":[],"colors":[[0,0,1],[0,0],[0,0,1]])") ==
          path + "colors.1: has 2 elements, not 3..4");
}

TEST_CASE("a mesh without normals is an error where normals are needed") {
    const std::string vertices = R"({"vertices":{"positions":[[0,0,0]],"indices":[]}})";
    CHECK(object_error("meshes.suzanne=" + vertices) ==
          "x.json: objects.0.mesh: the mesh 'suzanne' has no normals, which are needed here");
    CHECK(error_of(smallest,
                   {"meshes.q=" + vertices, R"(passes.0.units=[{"texgen":"normal_map"}])"}) ==
          "x.json: passes.0.mesh: the mesh 'q' has no normals, which are needed here");
}

TEST_CASE("paths stay inside the scene's folder unless the scene names one") {
    CHECK(object_error("meshes.suzanne={\"file\":\"../a.ply\"}") ==
          "x.json: meshes.suzanne.file: '../a.ply' leads out of the scene's folder by '..'");
    CHECK(object_error("environment={\"latlong\":\"/a.hdr\"}") ==
          "x.json: environment.latlong: '/a.hdr' is absolute; only a scene with 'directory' may "
          "name such");
    CHECK(object_error("textures.t.file=") == "x.json: textures.t.file: is empty");
    CHECK(object_error("textures.t.file=\"a\\u0000b\"") ==
          "x.json: textures.t.file: 'a?b' has a control character");
    CHECK(error_of(one_object, {"directory=/data", "environment={\"latlong\":\"/a.hdr\"}"}) ==
          "accepted");
}

TEST_CASE("names that the author chooses are plain") {
    CHECK(object_error("meshes={\"a/b\":{\"quad\":{}}}") ==
          "x.json: meshes: the name 'a/b' is not made of 1 to 60 letters, digits, _ and -");
}

TEST_CASE("relative paths start at the scene file's folder, or at the one it names") {
    CHECK(parse_scene(smallest, "x.json", "/scenes").directory == "/scenes");
    CHECK(parse_scene(smallest, "x.json", "/scenes", {"directory=data"}).directory ==
          "/scenes/data");
    CHECK(parse_scene(smallest, "x.json", "/scenes", {"directory=/else"}).directory == "/else");
    CHECK(read_scene(folder / "two-passes.json").directory == folder.string());
}

TEST_CASE("a file that is missing or a folder is a bad file") {
    for (const auto& path : {folder / "no-such.json", folder}) {
        try {
            read_scene(path);
            FAIL("accepted");
        } catch (const Error& error) {
            CHECK(error.code() == ExitCode::bad_file);
            CHECK(std::string(error.what()) == path.string() + ": cannot be read");
        }
    }
}

TEST_CASE("a field that is not written has its default") {
    const Scene scene = parse(one_object);
    CHECK(scene.image.width == 1024);
    CHECK(scene.camera.eye == Vec3{0.0, 0.0, 3.0});
    CHECK(scene.environment->cells == 8192);
    CHECK(scene.white.percentile == 99.0);
    CHECK_FALSE(scene.white.radiance);
    CHECK(scene.factorization.map_size == 64);
    CHECK(scene.presets == std::vector(usual_presets.begin(), usual_presets.end()));
    CHECK_FALSE(parse(smallest).passes[0].own_matrices);
}

TEST_CASE("the method sets what the file does not say, whatever the order of fields") {
    const Scene scene =
        parse(one_object, {R"(factorization={"seam":0.25,"method":"letter","cap":3})"});
    CHECK(scene.factorization.method == Method::letter);
    CHECK(scene.factorization.seam == 0.25);
    CHECK(scene.factorization.cap == 3.0);
    CHECK(scene.factorization.smoothness == method_preset(Method::letter).smoothness);
    CHECK(scene.factorization.column_scaling == method_preset(Method::letter).column_scaling);
}

TEST_CASE("matrices are written row by row") {
    const Scene scene =
        parse(smallest, {"passes.0.projection=[1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16]"});
    const ScenePass& pass = scene.passes[0];
    CHECK(pass.own_matrices);
    CHECK(pass.state.projection[3][0] == 4.0);
    CHECK(pass.state.projection[0][3] == 13.0);
    CHECK(pass.state.modelview == Mat4{1.0});
}

TEST_CASE("all shipped scenes are read, and the files that they name are there") {
    for (const std::string& name : shipped) {
        INFO(name);
        const Scene scene = read_scene(folder / name);
        CHECK(scene.presets.size() == 4);
        CHECK_FALSE(scene.title.empty());
        for (const auto& [key, mesh] : scene.meshes)
            if (const auto* file = std::get_if<MeshFile>(&mesh))
                CHECK(std::filesystem::exists(folder / file->path));
        if (!scene.environment) continue;
        if (const auto* file = std::get_if<EnvironmentFile>(&scene.environment->source))
            CHECK(std::filesystem::exists(folder / file->path));
    }
}
