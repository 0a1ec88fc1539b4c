#include "study/write_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "scenes/object_passes.hpp"
#include "study/pictures.hpp"
#include "study/report.hpp"
#include "study/results_json.hpp"
#include "texunit/atomic_file.hpp"
#include "texunit/error.hpp"
#include "texunit/image_file.hpp"

namespace twofold {
namespace {

void write_factor_map(const FactorMap& map, const std::string& stem,
                      const std::filesystem::path& folder) {
    const std::vector<Texture> real = faces_of(map.real), bytes = faces_of(map.bytes);
    for (std::size_t face = 0; face < real.size(); ++face) {
        const std::string name = fmt::format("{}-{}", stem, face_name(face, map.shape.form));
        write_file_atomically(folder / (name + ".exr"), encode_exr(float_image(real[face])));
        write_file_atomically(folder / (name + ".png"), encode_png(byte_image(bytes[face])));
    }
}

const Framebuffer& picture_named(const RunResult& run, const std::string& name) {
    for (const RunPicture& p : run.pictures)
        if (p.name == name) return p.picture;
    throw Error(ExitCode::failure, "no picture named " + name);
}

ReportComparison report_comparison(const RunResult& run, const RunComparison& c) {
    const int full_scale = std::clamp(c.difference.max_steps, 8, 64);
    const ByteImage heat = heat_map(byte_image(picture_named(run, c.picture)),
                                    byte_image(picture_named(run, c.reference)), full_scale);
    return {c.picture, c.reference, c.difference, encode_png(heat), full_scale};
}

ReportChannelFit report_fit(const FactoredLighting& lighting, std::size_t channel) {
    const ChannelFit& fit = lighting.fit[channel];
    const TreatedSamples& t = fit.counts;
    return {status_text(lighting, channel),
            fit.solver.iterations,
            fit.solver.relative_residual,
            fit.solver.history,
            fit.relative_rms,
            fit.log_rms,
            fit.median,
            fit.p95,
            fit.psnr,
            lighting.terms[0].c[static_cast<int>(channel)],
            {{"used", t.used},
             {"not finite, left out", t.non_finite},
             {"negative, raised to the floor", t.negative},
             {"zero, raised to the floor", t.zero},
             {"raised to the floor", t.floored},
             {"lowered to the cap", t.capped}}};
}

std::string brdf_name(const Brdf& brdf) {
    if (const auto* phong = std::get_if<ModifiedPhong>(&brdf))
        return fmt::format("modified Phong, N = {}", phong->exponent);
    if (const auto* measured = std::get_if<MeasuredBrdf>(&brdf))
        return fmt::format("measured, {}, {}", measured->source.path,
                           measured->source.fill == Fill::homomorphic ? "factored p(l) q(h) p(v)"
                                                                      : "interpolated");
    return fmt::format("Cook-Torrance, {} lobes", std::get<CookTorrance>(brdf).lobes.size());
}

ReportMaterial report_material(const RunResult& run, const std::string& name,
                               const FactoredLighting& lighting) {
    const ProductTerm& first = lighting.terms[0];
    const Rgb& s = first.scale_color;
    ReportMaterial m{name,
                     brdf_name(run.scene.materials.at(name)),
                     fmt::format("{}, {} terms", name_of(lighting.model), lighting.terms.size()),
                     pass_count(lighting),
                     first.t2.shape.size,
                     first.combiner_scale,
                     lighting.doubling_passes,
                     {s.x, s.y, s.z},
                     {},
                     {}};
    for (std::size_t c = 0; c < 3; ++c) m.channels[c] = report_fit(lighting, c);
    for (std::size_t k = 0; k < lighting.terms.size(); ++k)
        for (const auto& [label, map] :
             {std::pair{"t1", &lighting.terms[k].t1}, std::pair{"t2", &lighting.terms[k].t2}})
            for (std::size_t face = 0; const Texture& image : faces_of(map->bytes))
                m.maps.push_back(
                    {fmt::format("{} {}", map_name(label, k), face_name(face++, map->shape.form)),
                     encode_png(byte_image(image)), hash_of(image)});
    return m;
}

std::string environment_text(const RunResult& run) {
    if (!run.scene.environment) return "none";
    const auto count = run.lit.lights.lights.size();
    if (const auto* file = std::get_if<EnvironmentFile>(&run.scene.environment->source))
        return fmt::format("{}, {} x {} averaged to {} lights", file->path,
                           run.lit.lights.report.width, run.lit.lights.report.height, count);
    if (run.lit.lights.picture)
        return fmt::format("painted, {} x {} averaged to {} lights", run.lit.lights.report.width,
                           run.lit.lights.report.height, count);
    return fmt::format("{} directional lights", count);
}

std::vector<std::string> report_notes(const RunResult& run) {
    std::vector<std::string> notes = run.notes;
    if (run.turned_away > 0)
        notes.push_back(
            fmt::format("exact: at {} pixels the interpolated normal faces away from the eye; v is "
                        "taken at the horizon there",
                        run.turned_away));
    return notes;
}

std::vector<std::pair<std::string, std::string>> provenance(const RunResult& run) {
    std::vector<std::pair<std::string, std::string>> rows{
        {"program", "twofold " + program_version()}};
    const FactorSettings& s = run.scene.factorization;
    if (!run.scene.objects.empty())
        rows.emplace_back("factorisation",
                          fmt::format("method {}, solver {}, {} samples, {} held out",
                                      name_of(s.method), name_of(s.solver), s.samples, s.held_out));
    return rows;
}

Report make_report(const RunResult& run, const RunOrigin& origin) {
    Report report;
    report.title = run.scene.title;
    report.scene_path = origin.scene_path;
    report.version = program_version();
    report.command = origin.command;
    report.notes = report_notes(run);
    report.warnings = run.warnings;
    report.white = run.lit.white;
    report.environment = environment_text(run);
    for (const auto& [name, cost] : run.averaging_cost)
        report.averaging_cost = std::max(report.averaging_cost, cost);
    for (const RunPicture& p : run.pictures)
        report.pictures.push_back({p.name, encode_png(byte_image(p.picture)), hash_of(p.picture)});
    for (const RunComparison& c : run.comparisons)
        report.comparisons.push_back(report_comparison(run, c));
    for (const auto& [name, lighting] : run.lit.materials)
        report.materials.push_back(report_material(run, name, lighting));
    for (const RunStep& s : run.steps) report.steps.push_back({s.name, s.seconds});
    for (const Preset p : run.scene.presets)
        report.preset_sentences.emplace_back(std::string(name_of(p)), exactness_sentence(p));
    report.provenance = provenance(run);
    return report;
}

}  // namespace

OutputFolder::OutputFolder(std::filesystem::path path) : path_(std::move(path)) {
    std::error_code error;
    made_here_ = std::filesystem::create_directories(path_, error);
    if (error || !std::filesystem::is_directory(path_))
        throw Error(ExitCode::bad_file, path_.string() + ": cannot be made a folder: " +
                                            (error ? error.message() : "it is a file"));
    remove_stale_temporaries(path_);
}

OutputFolder::~OutputFolder() {
    std::error_code ignored;
    if (made_here_) std::filesystem::remove(path_, ignored);  // does nothing unless it is empty
}

void prepare_folder_of(const std::filesystem::path& file) {
    const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
    if (!std::filesystem::is_directory(folder))
        throw Error(ExitCode::bad_file,
                    fmt::format("{}: there is no folder {}", file.string(), folder.string()));
    remove_stale_temporaries(folder);
}

void write_factors(const Scene& scene, const LitScene& lit, const std::filesystem::path& folder) {
    for (const auto& [name, lighting] : lit.materials) {
        for (std::size_t k = 0; k < lighting.terms.size(); ++k) {
            write_factor_map(lighting.terms[k].t1, name + "-" + map_name("t1", k), folder);
            write_factor_map(lighting.terms[k].t2, name + "-" + map_name("t2", k), folder);
        }
    }
    write_file_atomically(folder / "factors.json", factors_json(scene, lit).dump(2) + "\n");
}

std::filesystem::path write_run(const RunResult& run, const std::filesystem::path& folder,
                                const RunOrigin& origin) {
    for (const RunPicture& p : run.pictures) {
        write_file_atomically(folder / (p.name + ".png"), encode_png(byte_image(p.picture)));
        write_file_atomically(folder / (p.name + ".exr"), encode_exr(float_image(p.picture)));
    }
    write_factors(run.scene, run.lit, folder);
    write_file_atomically(folder / "manifest.json", manifest_json(run));
    const std::filesystem::path report = folder / "report.html";
    write_file_atomically(report, report_html(make_report(run, origin)));
    return report;
}

}  // namespace twofold
