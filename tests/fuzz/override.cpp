#include "scenes/scene_file.hpp"
#include "tests/fuzz/promises.hpp"

namespace twofold::hostile {

bool override(Input bytes) {
    const std::string scene = R"({"camera": {"eye": [0, 0, 3]}, "meshes": {"q": {"quad": {}}},
        "textures": {"t": {"checkerboard": {}}},
        "passes": [{"mesh": "q", "units": [{"texture": "t"}]}]})";
    return reads(ExitCode::failure, [&] {
        static_cast<void>(parse_scene(scene, file_name, "/", {std::string(text_of(bytes))}));
    });
}

}  // namespace twofold::hostile
