#include "bench/deviations.hpp"

#include <array>
#include <string_view>

namespace twofold::bench {
namespace {

struct Entry {
    std::string_view driver;
    std::string_view check;        ///< how the check's name begins
    std::optional<Preset> preset;  ///< none: every preset
    Bound bound;
    std::string_view reason;
};

constexpr std::string_view last_vertex =
    "NVIDIA takes a quad's last vertex under either convention, which ARB_provoking_vertex allows";

/// 48 pixels are 3 references of 16 pixels, 64 are 4 functions of 16, 128 are those of two alphas.
constexpr std::array entries{
    Entry{"softpipe", "alpha test with reference 0.5", Preset::gl13, Bound{0, 64},
          "softpipe compares alpha as a float; OpenGL 1.3, 4.1.4 rounds alpha and reference to the "
          "framebuffer's bits first, which makes 0.5 the byte 128"},
    Entry{
        "llvmpipe", "alpha test with reference 0.5", Preset::float32, Bound{0, 64},
        "llvmpipe rounds alpha and reference to bytes, as OpenGL 1.3, 4.1.4 says; float32 compares "
        "floats by design"},
    Entry{"softpipe", "alpha test ", std::nullopt, Bound{0, 48},
          "softpipe compares alpha as a float, and its k / 255 of a texel is not the float nearest "
          "to "
          "k / 255, which the reference is"},
    Entry{"llvmpipe", "cube map, wraps", std::nullopt, Bound{99, 0},
          "llvmpipe keeps cube map lookups on their face whatever the wrap mode; OpenGL 1.3, 3.8.6 "
          "treats a face as any image, and so does softpipe"},
    Entry{"NVIDIA", "combine dot3_rgba", std::nullopt, Bound{255, 0},
          "NVIDIA scales the alpha of DOT3_RGBA by RGB_SCALE; we and Mesa by ALPHA_SCALE"},
    Entry{"NVIDIA", "alpha test with reference 0.5", Preset::gl13, Bound{0, 128},
          "NVIDIA makes 0.5 the byte 127; gl13 rounds the tie 127.5 to 128"},
    Entry{"NVIDIA", "alpha test with reference 0.5", Preset::float32, Bound{0, 64},
          "NVIDIA compares bytes, 0.5 as 127; float32 compares floats by design"},
    Entry{"NVIDIA", "flat quads, first", std::nullopt, Bound{255, 0}, last_vertex},
    Entry{"NVIDIA", "flat quad_strip, first", std::nullopt, Bound{255, 0}, last_vertex}};

bool meets(const Entry& entry, const Driver& driver, const std::string& check, Preset preset) {
    return driver.name == entry.driver && check.starts_with(entry.check) &&
           entry.preset.value_or(preset) == preset;
}

}  // namespace

std::optional<Deviation> known_deviation(const Driver& driver, const std::string& check,
                                         Preset preset) {
    for (const Entry& entry : entries)
        if (meets(entry, driver, check, preset))
            return Deviation{std::string(entry.reason), entry.bound};
    return std::nullopt;
}

}  // namespace twofold::bench
