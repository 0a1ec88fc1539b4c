#include "tests/fuzz/promises.hpp"
#include "texunit/image_file.hpp"

namespace twofold::hostile {
namespace {

/// The same bytes as a texture, which only PNG of 8 bits may become.
void check_texture(Input bytes) {
    reads(ExitCode::bad_file, [&] {
        const ByteImage image = decode_png(bytes, file_name);
        promise(image.pixels.size() ==
                    static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height),
                "pixels that are not width x height");
    });
}

}  // namespace

bool image(Input bytes) {
    check_texture(bytes);
    return reads(ExitCode::bad_file, [&] {
        const FloatImage image = decode_float_image(bytes, file_name).image;
        promise(image.samples.size() == static_cast<std::size_t>(image.width) *
                                            static_cast<std::size_t>(image.height) *
                                            static_cast<std::size_t>(image.channels),
                "samples that are not width x height x channels");
    });
}

}  // namespace twofold::hostile
