#include "bench/draw/works.hpp"

namespace twofold::bench {
namespace {

constexpr FastOptions fused{1, true}, literal{1, false}, two_threads{2, true};

const PeerEntry llvmpipe_para4{"llvmpipe, four passes", "llvmpipe", "para4"};
const PeerEntry llvmpipe_shader{"llvmpipe, one-pass shader", "llvmpipe", "glsl-rgba8"};

/// The perspective quad: nothing but filling.
Work quad() {
    return {"two textures, perspective quad",
            "tex2-persp",
            0,
            1024,
            {{"nv17", Preset::nv17},
             {"gl13", Preset::gl13},
             {"float32", Preset::float32},
             {"nv17, plain x86-64", Preset::nv17, fused, Pipeline::fast, true},
             {"gl13, plain x86-64", Preset::gl13, fused, Pipeline::fast, true}},
            {{"llvmpipe", "llvmpipe", "tex2-persp"}, {"limit's best kernel", "limit"}},
            {{"nv17", "llvmpipe", {1.5, 2.5}},
             {"gl13", "llvmpipe", {1.5, 2.5}},
             {"nv17", "limit's best kernel", {{}, 1 / 1.5}},
             {"gl13", "limit's best kernel", {{}, 1 / 1.5}},
             {"nv17, plain x86-64", "llvmpipe", {0.7, 1.0}},
             {"gl13, plain x86-64", "llvmpipe", {0.7, 1.0}},
             {"float32", "nv17", {1 / 2.0, 1 / 1.5}}}};
}

Work sphere_one_pass() {
    return {"20k sphere, two textures, one pass",
            "tex2-persp",
            sphere_20k,
            1024,
            {{"nv17", Preset::nv17}, {"gl13", Preset::gl13}},
            {{"llvmpipe", "llvmpipe", "tex2-persp"}},
            {{"nv17", "llvmpipe", {2.0, 4.0}}, {"gl13", "llvmpipe", {2.0, 4.0}}}};
}

Work sphere_four_passes() {
    return {"20k sphere, four passes",
            "para4",
            sphere_20k,
            1024,
            {{"nv17, literal", Preset::nv17, literal},
             {"gl13, literal", Preset::gl13, literal},
             {"nv17, fused", Preset::nv17, fused},
             {"gl13, fused", Preset::gl13, fused},
             {"float32, fused", Preset::float32, fused}},
            {llvmpipe_para4, llvmpipe_shader},
            {{"nv17, literal", llvmpipe_para4.name, {2.0, 3.0}},
             {"gl13, literal", llvmpipe_para4.name, {2.0, 3.0}},
             {"nv17, fused", llvmpipe_para4.name, {6.0, 12.0}},
             {"gl13, fused", llvmpipe_para4.name, {6.0, 12.0}},
             {"nv17, fused", llvmpipe_shader.name, {1.0, {}}},
             {"gl13, fused", llvmpipe_shader.name, {1.0, {}}},
             {"float32, fused", "nv17, fused", {1 / 2.0, 1 / 1.5}}}};
}

Work large_sphere() {
    return {"200k sphere, four passes",
            "para4",
            sphere_200k,
            1024,
            {{"nv17, fused", Preset::nv17, fused}, {"gl13, fused", Preset::gl13, fused}},
            {llvmpipe_para4},
            {{"nv17, fused", llvmpipe_para4.name, {3.0, 6.0}},
             {"gl13, fused", llvmpipe_para4.name, {3.0, 6.0}}}};
}

/// TinyGL, which draws little else, was measured at 1.9 times llvmpipe's speed.
Work nearest() {
    constexpr double tinygl = 1.9;
    return {"20k sphere, one nearest texture, depth",
            "tex1-nearest",
            sphere_20k,
            1024,
            {{"nv17", Preset::nv17}, {"gl13", Preset::gl13}},
            {{"llvmpipe / 1.9", "llvmpipe", "tex1-nearest"}},
            {{"nv17", "llvmpipe / 1.9", {1.0, 1.5}, false, tinygl},
             {"gl13", "llvmpipe / 1.9", {1.0, 1.5}, false, tinygl}}};
}

Work clear() {
    return {"clear",
            "clear",
            0,
            1024,
            {{"nv17", Preset::nv17}, {"gl13", Preset::gl13}},
            {{"llvmpipe", "llvmpipe", "clear"}},
            {{"nv17", "llvmpipe"}, {"gl13", "llvmpipe"}}};
}

/// What a second thread gains, by the wall clock.
Work threads(const std::string& title, const std::string& drawing, int squares) {
    return {title + ", 2048 x 2048, wall time",
            drawing,
            squares,
            2048,
            {{"nv17", Preset::nv17},
             {"nv17, 2 threads", Preset::nv17, two_threads},
             {"gl13", Preset::gl13},
             {"gl13, 2 threads", Preset::gl13, two_threads}},
            {},
            {{"nv17, 2 threads", "nv17", {1.7, 1.9}, true},
             {"gl13, 2 threads", "gl13", {1.7, 1.9}, true}}};
}

Work reference(const std::string& title, const std::string& drawing, int squares) {
    return {
        title + ", reference pipeline",
        drawing,
        squares,
        1024,
        {{"nv17, reference", Preset::nv17, {}, Pipeline::reference},
         {"gl13, reference", Preset::gl13, {}, Pipeline::reference}},
        {{"softpipe", "softpipe", drawing}},
        {{"nv17, reference", "softpipe", {2.0, 5.0}}, {"gl13, reference", "softpipe", {2.0, 5.0}}},
        3};
}

}  // namespace

std::vector<Work> all_works() {
    return {quad(),
            sphere_one_pass(),
            sphere_four_passes(),
            large_sphere(),
            nearest(),
            clear(),
            threads("perspective quad", "tex2-persp", 0),
            threads("20k sphere, four passes fused", "para4", sphere_20k),
            reference("perspective quad", "tex2-persp", 0),
            reference("20k sphere, four passes", "para4", sphere_20k)};
}

std::vector<Work> quick_works() { return {quad(), sphere_one_pass(), sphere_four_passes()}; }

}  // namespace twofold::bench
