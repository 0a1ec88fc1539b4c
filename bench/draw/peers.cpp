#include "bench/draw/peers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <sstream>

#include "bench/draw/child.hpp"
#include "bench/draw/raw_array.hpp"
#include "texunit/error.hpp"
#include "texunit/number_text.hpp"

namespace twofold::bench {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

Words split(const std::string& line, char separator) {
    Words words;
    std::istringstream text(line);
    for (std::string word; std::getline(text, word, separator);) words.push_back(word);
    return words;
}

double number(const std::string& field, const std::string& text) {
    const auto value = parse_real(text);
    if (!value) throw Error(ExitCode::bad_file, fmt::format("peer_gl: {}: {}", field, text));
    return *value;
}

/// The one line below the heading.
std::map<std::string, std::string> csv_row(const std::string& printed) {
    const Words lines = split(printed, '\n');
    if (lines.size() != 2) throw Error(ExitCode::bad_file, "peer_gl: printed no CSV: " + printed);
    const Words names = split(lines[0], ','), values = split(lines[1], ',');
    if (names.size() != values.size())
        throw Error(ExitCode::bad_file, "peer_gl: heading and line differ: " + printed);
    std::map<std::string, std::string> row;
    for (std::size_t i = 0; i < names.size(); ++i) row[names[i]] = values[i];
    return row;
}

std::string run_peer(const fs::path& programs, const PeerDrawing& d, double seconds, Words further,
                     std::vector<std::pair<std::string, std::string>> environment) {
    Words command{(programs / "peer_gl").string(),
                  "--header",
                  "--variant",
                  d.drawing,
                  "--mesh",
                  d.squares == 0 ? "quad" : fmt::format("sphere:{}", d.squares),
                  "--size",
                  std::to_string(d.size),
                  "--seconds",
                  fmt::format("{:.3f}", seconds)};
    command.insert(command.end(), further.begin(), further.end());
    environment.emplace_back("LIBGL_ALWAYS_SOFTWARE", "1");
    environment.emplace_back("GALLIUM_DRIVER", d.driver);
    environment.emplace_back("LP_NUM_THREADS", std::to_string(d.threads == 1 ? 0 : d.threads));
    return run_child(command, environment).output;
}

std::uint8_t byte_of(float channel) {
    return static_cast<std::uint8_t>(std::clamp(channel, 0.0f, 1.0f) * 255.0f + 0.5f);
}

/// Of float RGBA, rows bottom up.
ByteImage top_down(const std::vector<Rgba32f>& pixels, int size) {
    const auto edge = static_cast<std::size_t>(size);
    ByteImage picture{size, size, {}};
    for (std::size_t y = edge; y-- > 0;)
        for (std::size_t x = 0; x < edge; ++x) {
            const Rgba32f& p = pixels[y * edge + x];
            picture.pixels.push_back({byte_of(p[0]), byte_of(p[1]), byte_of(p[2]), byte_of(p[3])});
        }
    return picture;
}

}  // namespace

PeerTimes time_peer(const fs::path& programs, const PeerDrawing& drawing, double seconds) {
    auto row = csv_row(run_peer(programs, drawing, seconds, {}, {{"GALLIVM_PERF", ""}}));
    if (row["renderer"] != drawing.driver)
        throw Error(ExitCode::bad_file, fmt::format("peer_gl: renderer: asked for {}, drew with {}",
                                                    drawing.driver, row["renderer"]));
    const auto seconds_of = [&](const std::string& name) { return 1e-3 * number(name, row[name]); };
    return {{seconds_of("best_cpu_ms"), 0.0, seconds_of("best_ms")}, seconds_of("first_cpu_ms")};
}

ByteImage dump_inputs(const fs::path& programs, const PeerDrawing& drawing,
                      const fs::path& folder) {
    fs::create_directories(folder);
    const fs::path raw = folder / "picture.f32x4";
    run_peer(programs, drawing, 0.0, {"--dump", folder.string(), "--raw", raw.string()},
             {{"GALLIVM_PERF", "no_aos_sampling"}});
    const auto edge = static_cast<std::size_t>(drawing.size);
    return top_down(read_array<Rgba32f>(raw, edge * edge), drawing.size);
}

double best_kernel(std::string_view printed) {
    double best = 0.0;
    for (const std::string& line : split(std::string(printed), '\n')) {
        Words words;
        std::istringstream text(line);
        for (std::string word; text >> word;) words.push_back(word);
        // The kernel's name, then: coords size ns/px cyc/px Mpix/s check.
        if (words.size() < 7 || words.back() != "same") continue;
        const auto last = words.end();
        if (last[-6] != "persp" || last[-5] != "1024") continue;
        const double seconds = 1e-9 * number("ns/px", last[-4]);
        if (best == 0.0 || seconds < best) best = seconds;
    }
    if (best == 0.0) throw Error(ExitCode::bad_file, "limit: printed no kernel that is checked");
    return best;
}

double time_limit(const fs::path& programs, double seconds) {
    const ChildResult run =
        run_child({(programs / "limit").string(), fmt::format("{:.3f}", seconds)});
    return best_kernel(run.output);
}

}  // namespace twofold::bench
