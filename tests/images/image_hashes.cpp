// Hashes of every stage of every shipped scene, drawn small: image_hashes SCENES_DIR [THREADS]
//
// The fast pipeline draws every preset too and has to give the same bytes and values: what it draws
// has no hashes of its own, and a line is printed only where it differs.
// One line a stage: scene, stage, hash. A build whose arithmetic is not exact names the first stage
// that differs. tests/images/hashes.txt pins the output; it changes only with a preset's or a
// method's version.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <vector>

#include "raster/fast.hpp"
#include "raster/reference.hpp"
#include "scenes/frame.hpp"
#include "scenes/scene_file.hpp"
#include "study/pictures.hpp"
#include "study/run.hpp"
#include "texunit/fnv1a.hpp"

namespace {

using namespace twofold;

/// Small enough for an unoptimised build under a sanitizer, large enough to reach every branch.
const std::vector<std::string> object_overrides{"image.width=120",
                                                "image.height=90",
                                                "environment.cells=512",
                                                "factorization.map_size=16",
                                                "factorization.samples=12000",
                                                "factorization.held_out=1000"};

std::vector<std::filesystem::path> scenes_in(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> scenes;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (entry.path().extension() == ".json" && entry.path().stem().extension() != ".schema")
            scenes.push_back(entry.path());
    std::stable_sort(scenes.begin(), scenes.end());
    return scenes;
}

Scene small_scene(const std::filesystem::path& path) {
    const bool has_objects = !read_scene(path).objects.empty();
    return read_scene(
        path, has_objects ? object_overrides
                          : std::vector<std::string>{object_overrides[0], object_overrides[1]});
}

std::string hash_of(const DistantLights& lights) {
    Fnv1a hash;
    for (std::size_t k = 0; k < lights.size(); ++k)
        hash.f64(lights.x[k])
            .f64(lights.y[k])
            .f64(lights.z[k])
            .f64(lights.r[k])
            .f64(lights.g[k])
            .f64(lights.b[k]);
    return fmt::format("{:016x}", hash.value());
}

std::string hash_of(const std::array<ChannelFit, 3>& fit) {
    Fnv1a hash;
    for (const ChannelFit& f : fit) {
        for (const double residual : f.solver.history) hash.f64(residual);
        hash.f64(f.relative_rms).f64(f.log_rms).f64(f.median).f64(f.p95);
    }
    return fmt::format("{:016x}", hash.value());
}

/// The values before they became bytes: binary64, or what the preset's framebuffer holds.
std::string hash_of_values(const Framebuffer& picture) {
    Fnv1a hash;
    for (const auto& value : picture.values)
        for (const double c : value) hash.f64(c);
    return fmt::format("{:016x}", hash.value());
}

constexpr std::array every_preset{Preset::ideal64, Preset::float32, Preset::gl13,  Preset::nv2x,
                                  Preset::nv17,    Preset::coarse8, Preset::custom};

bool same(const Framebuffer& a, const Framebuffer& b) {
    return twofold::hash_of(a) == twofold::hash_of(b) && hash_of_values(a) == hash_of_values(b);
}

/// Every preset by both pipelines, whichever presets the scene names; a line for each way of the
/// fast one that does not give the reference's bytes and values. There is none in hashes.txt.
void print_strays(const std::string& name, const Scene& scene, const FactoredMaterials& materials,
                  int threads) {
    const SceneAssets assets = load_assets(scene);
    for (const Preset preset : every_preset) {
        const Frame frame = make_frame(scene, assets, materials, preset);
        const Framebuffer expected = render_reference(frame, preset, scene.custom);
        for (const bool fuse : {true, false})
            if (!same(expected, render_fast(frame, preset, scene.custom, {threads, fuse})))
                fmt::print("{} {}: fast with {} passes DIFFERS\n", name, name_of(preset),
                           fuse ? "fused" : "single");
    }
}

void print_run(const std::string& scene, const RunResult& run) {
    if (!run.scene.objects.empty())
        fmt::print("{} lights {}\n", scene, hash_of(run.lit.lights.lights));
    for (const auto& [name, lighting] : run.lit.materials) {
        fmt::print("{} {}:solve {}\n", scene, name, hash_of(lighting.fit));
        fmt::print("{} {}:t1 {}\n", scene, name, twofold::hash_of(lighting.terms[0].t1));
        fmt::print("{} {}:t2 {}\n", scene, name, twofold::hash_of(lighting.terms[0].t2));
    }
    for (const RunPicture& p : run.pictures) {
        fmt::print("{} {}:values {}\n", scene, p.name, hash_of_values(p.picture));
        fmt::print("{} {}:bytes {}\n", scene, p.name, twofold::hash_of(p.picture));
    }
}

}  // namespace

int main(int argc, char** argv) try {
    if (argc < 2 || argc > 3) {
        fmt::print(stderr, "usage: image_hashes SCENES_DIR [THREADS]\n");
        return 2;
    }
    const int threads = argc == 3 ? std::atoi(argv[2]) : 1;
    for (const auto& path : scenes_in(argv[1])) {
        const std::string name = path.stem().string();
        const RunResult run = run_scene(small_scene(path), threads, {});
        print_run(name, run);
        print_strays(name, run.scene, run.lit.materials, threads);
    }
    for (const auto& path : scenes_in(std::filesystem::path(argv[1]) / "probes"))
        print_strays(path.stem().string(), read_scene(path), {}, threads);
    return 0;
} catch (const std::exception& e) {
    fmt::print(stderr, "image_hashes: {}\n", e.what());
    return 2;
}
