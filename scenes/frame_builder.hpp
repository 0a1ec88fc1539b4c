#pragma once
#include <cstddef>
#include <map>
#include <string>

#include "scenes/frame.hpp"

namespace twofold {

/// Where the meshes and textures of a scene went in the frame.
struct FrameBuilder {
    const Scene& scene;
    Frame frame;
    std::map<std::string, std::size_t> meshes;
    std::map<std::string, std::size_t> textures;
    Mat4 view, projection;
};

/// What all first passes of an object have in common.
PassState object_state(const FrameBuilder& b, const FactoredObject& object);

}  // namespace twofold
