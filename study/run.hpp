#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "raster/renderer.hpp"
#include "scenes/exact_picture.hpp"
#include "scenes/lighting.hpp"
#include "study/metrics.hpp"

/// One scene from file to findings: light it, draw it under every preset it names, compare.
namespace twofold {

struct RunStep {
    std::string name;
    double seconds = 0.0;  ///< wall time
};

/// One drawn picture; `name` is "exact" or a preset.
struct RunPicture {
    std::string name;
    Framebuffer picture;
};

/// Difference of two of the run's pictures where both are covered.
struct RunComparison {
    std::string picture;
    std::string reference;
    PictureDifference difference;
};

struct RunResult {
    Scene scene;
    Pipeline pipeline = Pipeline::fast;  ///< that drew the presets' pictures
    LitScene lit;
    std::map<std::string, double> averaging_cost;  ///< by material
    std::size_t turned_away = 0;                   ///< see ExactPicture
    std::vector<RunPicture> pictures;              ///< exact first if there are objects
    std::vector<RunComparison> comparisons;
    std::vector<RunStep> steps;
    std::vector<std::string> notes;
    std::vector<std::string> warnings;
};

/// @param listen   told of each step as it begins
/// @param pipeline changes no byte; only the reference fills the pictures' counters
RunResult run_scene(const Scene& scene, int threads, const StepListener& listen,
                    Pipeline pipeline = Pipeline::fast);

/// What the factorisation warns of, each with its material's name.
std::vector<std::string> warnings_of(const FactoredMaterials& materials);

/// The same, and what a scene's explicit passes are warned of: units that are on without a texture,
/// once each (T11).
std::vector<std::string> warnings_of(const Scene& scene, const FactoredMaterials& materials);

/// Notes about the environment and meshes, in words.
std::vector<std::string> notes_about(const LitScene& lit, const SceneAssets& assets);

}  // namespace twofold
