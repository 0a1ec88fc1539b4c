#pragma once
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "scenes/scene.hpp"

/// The parts of a scene as JSON, every field written out; `scene_to_json` puts them together.
namespace twofold::scene_io {

using Json = nlohmann::ordered_json;

// All declared before the templates below, which find no later ones: their types are of another
// namespace.
Json json_of(Preset preset);
Json json_of(Vec3 v);
Json json_of(Vec4 v);
/// Row by row, as one writes a matrix.
Json json_of(const Mat4& matrix);
Json json_of(const ImageSpec& image);
Json json_of(const Camera& camera);
Json json_of(const DiscLight& light);
Json json_of(const DirectionalLight& light);
Json json_of(const EnvironmentSpec& environment);
Json json_of(const WhitePoint& white);
Json json_of(const FactorSettings& settings);
Json json_of(const BeckmannLobe& lobe);
Json json_of(const Brdf& brdf);
Json json_of(const MeshSpec& mesh);
Json json_of(const TextureImageSpec& image);
Json json_of(const TextureSpec& texture);
Json json_of(const FactoredObject& object);
Json json_of(const HistoricalObject& object);
Json json_of(const CustomSettings& custom);
Json json_of(const CombinerStage& stage);
Json json_of(const RegisterCombiners& combiners);
Json json_of(const Viewport& viewport);
Json json_of(const Fog& fog);
Json json_of(const Scissor& scissor);
Json json_of(const AlphaTest& test);
Json json_of(const DepthTest& test);
Json json_of(const Blend& blend);
Json json_of(const ScenePass& pass);

template <class T>
Json list_of(const T& values) {
    Json list = Json::array();
    for (const auto& value : values) list.push_back(json_of(value));
    return list;
}

template <class T>
Json map_of(const std::map<std::string, T>& values) {
    Json map = Json::object();
    for (const auto& [name, value] : values) map[name] = json_of(value);
    return map;
}

/// What can be switched off is null then.
template <class T>
Json optional_of(const std::optional<T>& value) {
    return value ? json_of(*value) : Json(nullptr);
}

}  // namespace twofold::scene_io
