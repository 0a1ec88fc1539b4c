#pragma once
#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "study/metrics.hpp"

/// What a run has found, as plain values, and the page that shows it.
/// Pictures are whole PNG files; a number that is not finite is shown as missing.
namespace twofold {

struct ReportPicture {
    std::string name;  ///< "exact", a preset, or for a factor map "t1 front"
    std::vector<unsigned char> png;
    std::string hash;
};

struct ReportComparison {
    std::string picture, reference;       ///< names of two of the report's pictures
    PictureDifference difference;         ///< of `difference_where_covered`
    std::vector<unsigned char> heat_png;  ///< of `heat_map`; may be empty
    int heat_full_scale_steps = 0;        ///< as given to `heat_map`; 0 = not stated
};

struct ReportStep {
    std::string name;
    double seconds = 0.0;
};

/// How well one colour channel of a material was factored.
struct ReportChannelFit {
    std::string solver_status;
    int iterations = 0;
    double relative_residual = 0.0;
    std::vector<double> history;  ///< relative residual after each iteration
    double relative_rms = 0.0, log_rms = 0.0, median = 0.0, p95 = 0.0, psnr = 0.0;
    double scale_c = 0.0;
    std::vector<std::pair<std::string, std::size_t>> treated_samples;  ///< treatment and count
};

struct ReportMaterial {
    std::string name, brdf;
    std::string model;  ///< and its number of terms
    std::size_t passes = 0;
    int map_size = 0;  ///< texels along an edge
    int combiner_scale = 1;
    int doubling_passes = 0;
    std::array<double, 3> scale_color{};
    std::array<ReportChannelFit, 3> channels;  ///< red, green, blue
    std::vector<ReportPicture> maps;           ///< t1 front and back, t2 front and back
};

struct Report {
    std::string title, scene_path, version, command;
    std::vector<std::string> notes, warnings;
    double white = 0.0;  ///< the radiance displayed as 1.0
    std::string environment;
    double averaging_cost = 0.0;  ///< relative error of averaging the environment to fewer lights
    std::vector<ReportPicture> pictures;
    std::vector<ReportComparison> comparisons;
    std::vector<ReportMaterial> materials;
    std::vector<ReportStep> steps;
    std::vector<std::pair<std::string, std::string>> preset_sentences;  ///< preset and sentence
    std::vector<std::pair<std::string, std::string>> provenance;  ///< what and its hash or source
};

/// The result in one sentence: how far the most limited preset is from `exact`, and what the
/// factorisation and the 8-bit arithmetic each do to that alone.
std::string summary_sentence(const Report& report);

/// One HTML file that needs no network: pictures, data, style and script are inside.
std::string report_html(const Report& report);

}  // namespace twofold
