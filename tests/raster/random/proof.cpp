#include "tests/raster/random/proof.hpp"

#include <fmt/format.h>

#include "raster/fast_plan.hpp"
#include "raster/reference.hpp"
#include "tests/raster/random/shrink.hpp"
#include "tests/raster/random/state_scene.hpp"
#include "texunit/error.hpp"

namespace twofold::test {
namespace {

/// A picture, or why there is none.
struct Drawn {
    Framebuffer picture;
    std::string error;
};

Drawn drawn(const RandomState& state, const Renderer& render) {
    try {
        return {render(state), {}};
    } catch (const std::exception& e) {
        return {{}, e.what()};
    }
}

std::string options_text(const FastOptions& options) {
    return fmt::format("threads {}, passes {}", options.threads,
                       options.fuse ? "fused" : "one by one");
}

std::size_t index_count(const Frame& frame) {
    std::size_t count = 0;
    for (const Mesh& mesh : frame.meshes) count += mesh.indices.size();
    return count;
}

std::string mismatch_text(const RandomState& state, const PictureMismatch& mismatch) {
    const Frame& frame = state.frame;
    return fmt::format(
        "preset {}, {}, {} x {}, {} passes, {} indices: {} pixels differ, first ({}, {}): {}",
        name_of(state.preset), options_text(state.options), frame.width, frame.height,
        frame.passes.size(), index_count(frame), mismatch.pixels, mismatch.x, mismatch.y,
        mismatch.text);
}

/// Writes the state and says whether the file, read back, fails as well.
std::string written(const RandomState& state, const Renderer& found,
                    const std::filesystem::path& folder, const std::string& name) {
    const std::filesystem::path file = folder / (name + ".json");
    std::string text = "  " + file.string();
    try {
        for (const std::string& note : write_state(state, folder, name)) text += ", " + note;
        const bool fails = difference(read_state(state, file), by_reference, found).has_value();
        text += fails ? " (fails as well)\n" : " (does NOT fail: only the state itself does)\n";
    } catch (const std::exception& e) {
        text += fmt::format(" (no scene can say this state: {})\n", e.what());
    }
    return text;
}

}  // namespace

Framebuffer by_reference(const RandomState& state) {
    return render_reference(state.frame, state.preset, state.custom);
}

Framebuffer by_fast(const RandomState& state) {
    return render_fast(state.frame, state.preset, state.custom, state.options);
}

FastShare fast_share(const RandomState& state) {
    FastShare share;
    try {
        const auto routes =
            fast_routes(state.frame, state.preset, state.custom, state.options.fuse);
        for (const FastRoute& route : routes)
            share.by_vectors += route.scalar_fragments.empty() ? 1u : 0u;
        share.joined = routes.empty() ? 0 : routes.size() - routes.back().group - 1;
    } catch (const Error&) {
        // Neither pipeline draws such a frame.
    }
    return share;
}

std::optional<PictureMismatch> difference(const RandomState& state, const Renderer& expected,
                                          const Renderer& found) {
    const Drawn a = drawn(state, expected), b = drawn(state, found);
    if (a.error != b.error)
        return PictureMismatch{0, 0, 0, fmt::format("expected '{}', found '{}'", a.error, b.error)};
    return mismatch_of(a.picture, b.picture);
}

std::string failure_report(std::uint64_t seed, std::uint64_t number, const RandomState& state,
                           const PictureMismatch& mismatch, const Renderer& found,
                           const std::filesystem::path& folder) {
    const auto differs = [&](const RandomState& s) {
        return difference(s, by_reference, found).has_value();
    };
    const RandomState small = shrunk(state, differs);
    const std::string name = fmt::format("seed-{}-state-{}", seed, number);
    std::string text =
        fmt::format("seed {}, state {}: {}\n", seed, number, mismatch_text(state, mismatch));
    if (const auto rest = difference(small, by_reference, found))
        text += "  shrunk: " + mismatch_text(small, *rest) + "\n";
    return text + written(state, found, folder, name) +
           written(small, found, folder, name + "-small");
}

}  // namespace twofold::test
