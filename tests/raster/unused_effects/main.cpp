// Draws a frame, then the same frame with effects declared that change nothing, for callgrind to
// count (run.sh): unused_effects; prints the name of each drawing in the order in which they are
// drawn.
#include <fmt/format.h>

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "bench/draw/drawing.hpp"
#include "raster/fast.hpp"
#include "raster/vector_width.hpp"

/// One frame and nothing else; run.sh counts what happens in here.
extern "C" __attribute__((noinline)) void counted_draw(const twofold::FastFrame& frame) {
    frame.draw();
}

namespace {

using namespace twofold;

constexpr int size = 256;

using Effect = std::pair<std::string, std::function<void(PassState&)>>;

/// Effects without effect. A size-wide scissor is the whole picture.
std::vector<Effect> idle_effects(const PassState& state) {
    std::vector<Effect> effects{
        {"nothing", [](PassState&) {}},
        {"blend ONE, ZERO", [](PassState& s) { s.blend = Blend{}; }},
        {"scissor of the whole picture",
         [](PassState& s) {
             s.scissor = Scissor{0, 0, size, size};
         }},
        {"dither of 8-bit channels", [](PassState& s) { s.dither = true; }}};
    if (!state.alpha_test)
        effects.push_back({"alpha test ALWAYS", [](PassState& s) {
                               s.alpha_test = AlphaTest{CompareFunc::always, 0.5};
                           }});
    if (!state.depth_test)
        effects.push_back({"depth test ALWAYS, no write", [](PassState& s) {
                               s.depth_test = DepthTest{CompareFunc::always, false};
                           }});
    if (state.units[0]->texgen == TexGenState{})
        effects.push_back({"NORMALIZE without normals", [](PassState& s) { s.normalize = true; }});
    return effects;
}

void draw(const Frame& frame, Preset preset) {
    const FastFrame fast = prepare_fast(frame, preset);
    fast.draw();  // memory and caches of the frame before
    counted_draw(fast);
}

/// A frame plain, then with each idle effect in all its passes.
void draw_all(const std::string& name, const Frame& frame) {
    for (const Preset preset : {Preset::nv17, Preset::gl13})
        for (const auto& [effect, declare] : idle_effects(frame.passes.front().state)) {
            Frame declared = frame;
            for (Pass& pass : declared.passes) declare(pass.state);
            fmt::print("{}, {}: {}\n", name, name_of(preset), effect);
            draw(declared, preset);
        }
}

}  // namespace

int main() try {
    limit_vectors("avx2");  // valgrind does not know AVX-512
    draw_all("four passes", bench::frame_of(bench::make_inputs("para4", 8, size)));
    Frame plain = bench::frame_of(bench::make_inputs("tex2-persp", 8, size));
    draw_all("two textures", plain);
    for (Pass& pass : plain.passes) pass.state.depth_test.reset();
    draw_all("no depth test", plain);
    return 0;
} catch (const std::exception& e) {
    fmt::print(stderr, "unused_effects: {}\n", e.what());
    return 2;
}
