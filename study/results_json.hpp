#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "raster/framebuffer.hpp"
#include "study/run.hpp"

/// Results as JSON. Numbers that are not finite become null; keys keep their order.
namespace twofold {

/// Everything about the factorisation: factors.json.
nlohmann::ordered_json factors_json(const Scene& scene, const LitScene& lit);

/// Everything that was found, times included: what `run --json` prints.
nlohmann::ordered_json run_json(const RunResult& run);

/// The scene with every field written out and, under `results`, the hash of everything that was
/// made: a scene file that reruns to the same bytes.
std::string manifest_json(const RunResult& run);

nlohmann::ordered_json to_json(const PictureDifference& difference);
nlohmann::ordered_json to_json(const FloatDifference& difference);
nlohmann::ordered_json to_json(const DrawCounters& counters);

/// How a channel was found: "black", the closed form's name, or how the solver ended.
std::string status_text(const FactoredLighting& lighting, std::size_t channel);

/// "t1" for the first product, "t1-2" for the second.
std::string map_name(const std::string& factor, std::size_t term);

/// Version of the program, such as "0.1.0".
std::string program_version();

}  // namespace twofold
