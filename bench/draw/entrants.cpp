#include "bench/draw/entrants.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <memory>
#include <sstream>

#include "bench/draw/child.hpp"
#include "bench/draw/drawing.hpp"
#include "bench/draw/machine.hpp"
#include "bench/draw/peers.hpp"
#include "raster/reference.hpp"

namespace twofold::bench {
namespace {

using SharedFrame = std::shared_ptr<const Frame>;

constexpr Rgba8 background{0, 0, 0, 0};

Framebuffer picture_of(const Frame& frame, const OurEntry& entry) {
    return entry.pipeline == Pipeline::reference
               ? render_reference(frame, entry.preset)
               : render_fast(frame, entry.preset, {}, entry.options);
}

PictureCheck check_picture(const Work& work, const OurEntry& entry, const Frame& frame,
                           const ByteImage& theirs) {
    PictureCheck check{work.title, entry.name, "llvmpipe", {}};
    const Framebuffer ours = picture_of(frame, entry);
    const auto empty = [&](std::size_t i) {
        return ours.bytes[i] == background && theirs.pixels[i] == background;
    };
    std::vector<bool> left_out(ours.bytes.size());
    for (std::size_t i = 0; i < left_out.size(); ++i) left_out[i] = empty(i);
    compare_pictures({ours.width, ours.height, ours.bytes}, theirs, background, left_out,
                     check.difference);
    return check;
}

Contestant reference_contestant(const OurEntry& entry, SharedFrame frame, double seconds) {
    return {entry.name, [=, preset = entry.preset] {
                return time_frames([&] { render_reference(*frame, preset); }, seconds, 1);
            }};
}

/// The child prints a FrameTimes.
Contestant baseline_contestant(const OurEntry& entry, const Settings& settings,
                               const Source& source) {
    const auto command = child_command(settings, source, entry.preset, settings.seconds);
    return {
        entry.name, [=] {
            std::istringstream printed(run_child(command, {{"TWOFOLD_SIMD", "baseline"}}).output);
            FrameTimes times;
            printed >> times.cpu >> times.cpu_median >> times.wall;
            return times;
        }};
}

Contestant our_contestant(const OurEntry& entry, const Settings& settings, const Source& source,
                          const SharedFrame& frame) {
    if (entry.baseline) return baseline_contestant(entry, settings, source);
    if (entry.pipeline == Pipeline::reference)
        return reference_contestant(entry, frame, settings.seconds);
    return fast_contestant(entry.name, frame, entry.preset, entry.options, settings.seconds);
}

/// limit measures seconds per pixel of a full picture.
Contestant limit_contestant(const PeerEntry& entry, const fs::path& programs, double pixels) {
    constexpr double seconds_per_kernel = 0.02;
    return {entry.name, [=] {
                const double seconds = pixels * time_limit(programs, seconds_per_kernel);
                return FrameTimes{seconds, 0.0, seconds};
            }};
}

Contestant peer_contestant(const PeerEntry& entry, const Settings& settings, const Work& work,
                           double pixels) {
    const fs::path programs = *settings.peers;
    if (entry.driver == "limit") return limit_contestant(entry, programs, pixels);
    const PeerDrawing drawing{entry.driver, entry.drawing, work.squares, work.size, entry.threads};
    return {entry.name, [=, seconds = settings.seconds] {
                return time_peer(programs, drawing, seconds).frame;
            }};
}

/// limit's kernels need AVX-512.
bool runs_here(const PeerEntry& entry) {
    if (entry.driver != "limit" || processor_has("avx512bw")) return true;
    std::cerr << "bench_draw: limit LEFT OUT: this processor has no AVX-512\n";
    return false;
}

/// The clear colour covers nothing, so a clear counts all of its pixels.
double pixels_of(const Frame& frame) {
    if (frame.passes.empty()) return static_cast<double>(frame.width) * frame.height;
    return covered_pixels(render_fast(frame, Preset::nv17).bytes);
}

}  // namespace

double covered_pixels(const std::vector<Rgba8>& pixels) {
    return static_cast<double>(
        std::count_if(pixels.begin(), pixels.end(), [](Rgba8 p) { return p != background; }));
}

bool PictureCheck::passed() const {
    const auto& d = difference;
    if (d.compared() + d.coverage == 0) return true;  // nothing but background
    const auto share = [&](std::size_t n) {
        return static_cast<double>(n) / static_cast<double>(d.compared() + d.coverage);
    };
    return share(d.steps[5]) <= 1e-3 && share(d.coverage) <= 2e-4;
}

Inputs load(const Source& source) {
    return source.dump.empty() ? make_inputs(source.drawing, source.squares, source.size)
                               : read_dump(source.dump);
}

std::vector<std::string> child_command(const Settings& settings, const Source& source,
                                       Preset preset, double seconds) {
    std::vector<std::string> command{settings.self.string(),
                                     "--child",
                                     source.drawing,
                                     std::to_string(source.squares),
                                     std::to_string(source.size),
                                     std::string(name_of(preset)),
                                     fmt::format("{:.3f}", seconds)};
    if (!source.dump.empty()) command.push_back(source.dump.string());
    return command;
}

Contestant fast_contestant(const std::string& name, SharedFrame frame, Preset preset,
                           FastOptions options, double seconds) {
    // The prepared frame refers to the frame, so they stay together.
    const std::pair drawing{frame, prepare_fast(*frame, preset, {}, options)};
    return {name, [=] { return time_frames(drawing.second.draw, seconds, 3); }};
}

SourceAndPicture make_source(const Settings& settings, const std::string& drawing, int squares,
                             int size) {
    SourceAndPicture result{{drawing, squares, size}, {}};
    if (!settings.peers) return result;
    result.source.dump = settings.scratch / fmt::format("{}-{}-{}", drawing, squares, size);
    result.picture =
        dump_inputs(*settings.peers, {"llvmpipe", drawing, squares, size}, result.source.dump);
    return result;
}

PreparedWork prepare(const Settings& settings, const Work& work) {
    const auto [source, theirs] = make_source(settings, work.drawing, work.squares, work.size);
    const auto frame = std::make_shared<const Frame>(frame_of(load(source)));
    const double pixels = pixels_of(*frame);
    PreparedWork result{
        {work.title, pixels, {}, work.duels, std::min(settings.rounds, work.most_rounds)}, {}};
    for (const OurEntry& entry : work.ours) {
        if (entry.baseline && !settings.baseline) continue;
        if (theirs && !entry.baseline)
            result.pictures.push_back(check_picture(work, entry, *frame, *theirs));
        result.contest.contestants.push_back(our_contestant(entry, settings, source, frame));
    }
    if (settings.peers)
        for (const PeerEntry& entry : work.peers)
            if (runs_here(entry))
                result.contest.contestants.push_back(
                    peer_contestant(entry, settings, work, pixels));
    return result;
}

}  // namespace twofold::bench
