#include "scenes/scene_file.hpp"
#include "tests/fuzz/promises.hpp"

namespace twofold::hostile {

/// What is read can be written, and what was written reads back to the same text.
bool scene(Input bytes) {
    std::optional<Scene> scene;
    const auto read = [&] { scene = parse_scene(text_of(bytes), file_name, "/"); };
    if (!reads(ExitCode::failure, read)) return false;
    const std::string written = scene_to_json(*scene);
    promise(scene_to_json(parse_scene(written, file_name, "/")) == written,
            "a scene that was written reads back as another");
    return true;
}

}  // namespace twofold::hostile
