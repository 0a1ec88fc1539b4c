#include "cli/commands.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "cli/console.hpp"
#include "scenes/object_passes.hpp"
#include "scenes/scene_file.hpp"
#include "study/pictures.hpp"
#include "study/results_json.hpp"
#include "study/write_run.hpp"
#include "texunit/atomic_file.hpp"
#include "texunit/image_file.hpp"

namespace twofold {
namespace {

using Json = nlohmann::ordered_json;

void print_json(const Json& json) { fmt::print("{}\n", json.dump(2)); }

bool all_converged(const FactoredMaterials& materials) {
    for (const auto& [name, lighting] : materials)
        for (const ChannelFit& fit : lighting.fit)
            if (fit.solver.status != SolverStatus::converged) return false;
    return true;
}

/// Shows the warnings; a solver that did not converge outweighs them.
ExitCode outcome(const FactoredMaterials& materials, const std::vector<std::string>& warnings,
                 Console& console) {
    for (const std::string& text : warnings) console.warn(text);
    if (!all_converged(materials)) return ExitCode::not_converged;
    return warnings.empty() ? ExitCode::ok : ExitCode::warning;
}

void print_comparisons(const RunResult& run) {
    fmt::print("{:<8} {:<8} {:>9} {:>9} {:>9} {:>5} {:>8} {:>8}\n", "picture", "against",
               "compared", "differ", "coverage", "max", "rms", "PSNR dB");
    for (const RunComparison& c : run.comparisons) {
        const PictureDifference& d = c.difference;
        fmt::print("{:<8} {:<8} {:>9} {:>9} {:>9} ", c.picture, c.reference, d.pixels_compared,
                   d.differing_pixels, d.coverage_differs);
        if (d.pixels_compared == 0)
            fmt::print("{:>5} {:>8} {:>8}\n", "-", "-", "-");
        else
            fmt::print("{:>5} {:>8.3f} {:>8.2f}\n", d.max_steps, d.rms_steps, d.psnr_db);
    }
}

/// What 8 bits leave of a channel of a product.
void print_loss(const std::string& name, const ProductTerm& term, std::size_t term_index,
                std::size_t c) {
    const ByteLoss &t1 = term.t1.loss[c], &t2 = term.t2.loss[c];
    fmt::print(
        "{} {}: {} and {}: {} and {} levels, {:.1f} and {:.1f} % vanished, {:.1f} and {:.1f} % "
        "clipped, vertex colour {:.4g} x {}\n",
        name, channel_name(c), map_name("t1", term_index), map_name("t2", term_index), t1.levels,
        t2.levels, 100.0 * t1.zero_share, 100.0 * t2.zero_share, 100.0 * t1.clipped_share,
        100.0 * t2.clipped_share, term.scale_color[static_cast<int>(c)], term.combiner_scale);
}

void print_scale(const FactoredMaterials& materials) {
    for (const auto& [name, lighting] : materials)
        for (std::size_t k = 0; k < lighting.terms.size(); ++k)
            for (std::size_t c = 0; c < 3; ++c) print_loss(name, lighting.terms[k], k, c);
}

void print_fit(const FactoredMaterials& materials) {
    for (const auto& [name, lighting] : materials) {
        fmt::print("{}: model {}, {} passes\n", name, name_of(lighting.model),
                   pass_count(lighting));
        for (std::size_t c = 0; c < 3; ++c) {
            const ChannelFit& f = lighting.fit[c];
            fmt::print(
                "{} {}: {} in {} iterations, relative rms {:.4f}, log rms {:.4f}, median {:.4f}, "
                "p95 {:.4f}, {:.2f} dB, c {:.4g}\n",
                name, channel_name(c), status_text(lighting, c), f.solver.iterations,
                f.relative_rms, f.log_rms, f.median, f.p95, f.psnr,
                lighting.terms[0].c[static_cast<int>(c)]);
        }
    }
}

void print_steps(const std::vector<RunStep>& steps) {
    double total = 0.0;
    for (const RunStep& s : steps) {
        fmt::print("{:<24} {:>8.3f} s\n", s.name, s.seconds);
        total += s.seconds;
    }
    fmt::print("{:<24} {:>8.3f} s\n", "total", total);
}

std::string lower_case_extension(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    for (char& c : extension)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return extension;
}

void write_picture(const std::filesystem::path& path, const Framebuffer& picture) {
    if (lower_case_extension(path) == ".png")
        write_file_atomically(path, encode_png(byte_image(picture)));
    else
        write_file_atomically(path, encode_exr(float_image(picture)));
}

/// Only the reference looks at every fragment and counts it.
Json picture_json(Preset preset, Pipeline pipeline, const Framebuffer& picture) {
    Json json = {
        {"preset", name_of(preset)}, {"pipeline", name_of(pipeline)}, {"hash", hash_of(picture)}};
    if (pipeline == Pipeline::reference) json["counters"] = to_json(picture.counters);
    return json;
}

}  // namespace

Pipeline pipeline_or_error(const std::string& name) {
    if (const auto pipeline = pipeline_named(name)) return *pipeline;
    throw Error(ExitCode::failure,
                fmt::format("--pipeline: no pipeline '{}'; there are: fast reference", name));
}

ExitCode run_command(const RunOptions& options, const CommonOptions& common) {
    const Pipeline pipeline = pipeline_or_error(options.pipeline);
    const Scene scene = read_scene(options.scene, common.overrides);
    const OutputFolder folder(options.output);
    Console console(common.quiet);
    const auto listen = [&](const std::string& step) { console.step(step); };
    RunResult run = run_scene(scene, common.threads, listen, pipeline);
    console.step("write report");
    const auto report = write_run(run, folder.path(), {options.scene, common.command_line});
    console.finish();
    if (common.json) {
        print_json(run_json(run));
    } else {
        print_fit(run.lit.materials);
        print_comparisons(run);
        print_steps(run.steps);
        fmt::print("report: {}\n", std::filesystem::absolute(report).lexically_normal().string());
    }
    return outcome(run.lit.materials, run.warnings, console);
}

ExitCode factor_command(const FactorOptions& options, const CommonOptions& common) {
    std::vector<std::string> overrides = common.overrides;
    if (!options.solver.empty()) overrides.push_back("factorization.solver=" + options.solver);
    const Scene scene = read_scene(options.scene, overrides);
    if (scene.objects.empty())
        throw Error(ExitCode::failure, options.scene + ": objects: there is nothing to factor");
    const OutputFolder folder(options.output);
    Console console(common.quiet);
    const LitScene lit =
        light_scene(scene, common.threads, [&](const std::string& step) { console.step(step); });
    write_factors(scene, lit, folder.path());
    console.finish();
    if (common.json) {
        print_json(factors_json(scene, lit));
    } else {
        print_fit(lit.materials);
        print_scale(lit.materials);
    }
    return outcome(lit.materials, warnings_of(lit.materials), console);
}

ExitCode render_command(const RenderOptions& options, const CommonOptions& common) {
    const Pipeline pipeline = pipeline_or_error(options.pipeline);
    const Scene scene = read_scene(options.scene, common.overrides);
    const Preset preset =
        options.preset.empty() ? scene.presets.front() : preset_or_error(options.preset);
    const std::string extension = lower_case_extension(options.output);
    if (extension != ".png" && extension != ".exr")
        throw Error(ExitCode::failure,
                    "--output: '" + options.output + "' must end in .png or .exr");
    prepare_folder_of(options.output);
    Console console(common.quiet);
    const SceneAssets assets = load_assets(scene);
    const LitScene lit =
        light_scene(scene, common.threads, [&](const std::string& step) { console.step(step); });
    console.step(fmt::format("draw {}", name_of(preset)));
    const Framebuffer picture = render(make_frame(scene, assets, lit.materials, preset), preset,
                                       scene.custom, {pipeline, common.threads});
    write_picture(options.output, picture);
    console.finish();
    if (common.json)
        print_json(picture_json(preset, pipeline, picture));
    else
        fmt::print("{} {} {}\n", name_of(preset), hash_of(picture), options.output);
    return outcome(lit.materials, warnings_of(scene, lit.materials), console);
}

}  // namespace twofold
