#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "cli/commands.hpp"
#include "study/results_json.hpp"
#include "study/write_run.hpp"
#include "texunit/atomic_file.hpp"
#include "texunit/image_file.hpp"

namespace twofold {
namespace {

bool is_png(const std::string& path) {
    constexpr std::array<unsigned char, 4> magic{0x89, 'P', 'N', 'G'};
    const auto bytes = read_file(path, std::size_t{1} << 30);
    return bytes.size() >= magic.size() && std::equal(magic.begin(), magic.end(), bytes.begin());
}

void print_histogram(const PictureDifference& d) {
    for (std::size_t steps = 0; steps < d.histogram.size(); ++steps)
        if (d.histogram[steps] > 0)
            fmt::print("  {:>3} steps: {:>10} pixels\n", steps, d.histogram[steps]);
}

std::string place_of(const std::optional<std::pair<int, int>>& pixel) {
    return pixel ? fmt::format(", first at ({}, {})", pixel->first, pixel->second) : std::string{};
}

ExitCode compare_bytes(const CompareOptions& options, const CommonOptions& common) {
    const ByteImage a = read_png(options.a), b = read_png(options.b);
    const PictureDifference d = options.covered ? difference_where_covered(a, b) : difference(a, b);
    if (!options.diff.empty())
        write_file_atomically(options.diff,
                              encode_png(heat_map(a, b, std::clamp(d.max_steps, 8, 255))));
    if (common.json) {
        fmt::print("{}\n", to_json(d).dump(2));
    } else {
        fmt::print("{} of {} pixels differ{}; coverage differs at {}\n", d.differing_pixels,
                   d.pixels_compared, place_of(d.first_difference), d.coverage_differs);
        fmt::print("max {} steps, rms {:.4f} steps, PSNR {:.2f} dB\n", d.max_steps, d.rms_steps,
                   d.psnr_db);
        print_histogram(d);
    }
    return d.differing_pixels + d.coverage_differs == 0 ? ExitCode::ok : ExitCode::failure;
}

ExitCode compare_floats(const CompareOptions& options, const CommonOptions& common) {
    if (!options.diff.empty())
        throw Error(ExitCode::failure, "--diff: heat maps are made of PNG pictures only");
    const FloatImage a = read_float_image(options.a).image, b = read_float_image(options.b).image;
    const FloatDifference d = options.covered ? difference_where_covered(a, b) : difference(a, b);
    if (common.json)
        fmt::print("{}\n", to_json(d).dump(2));
    else
        fmt::print(
            "{} of {} samples in {} pixels differ{}; {} of them not finite; coverage differs at "
            "{}\nof the finite: max {:.6g}, rms {:.6g}, PSNR {:.2f} dB\n",
            d.differing_samples, d.samples_compared, d.differing_pixels,
            place_of(d.first_difference), d.without_distance, d.coverage_differs, d.max_abs, d.rms,
            d.psnr_db);
    return d.differing_samples + d.coverage_differs == 0 ? ExitCode::ok : ExitCode::failure;
}

}  // namespace

ExitCode compare_command(const CompareOptions& options, const CommonOptions& common) {
    if (!options.diff.empty() && !options.diff.ends_with(".png"))
        throw Error(ExitCode::failure, "--diff: '" + options.diff + "' must end in .png");
    if (!options.diff.empty()) prepare_folder_of(options.diff);
    const bool bytes = is_png(options.a) && is_png(options.b);
    return bytes ? compare_bytes(options, common) : compare_floats(options, common);
}

}  // namespace twofold
