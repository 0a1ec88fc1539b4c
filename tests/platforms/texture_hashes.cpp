#include "tests/platforms/preset_input.hpp"
#include "texunit/uploaded_texture.hpp"

namespace twofold::platforms {
namespace {

constexpr std::array<std::pair<const char*, TextureFormat>, 13> formats{
    {{"argb8888", TextureFormat::argb8888},
     {"xrgb8888", TextureFormat::xrgb8888},
     {"rgb565", TextureFormat::rgb565},
     {"argb1555", TextureFormat::argb1555},
     {"xrgb1555", TextureFormat::xrgb1555},
     {"argb4444", TextureFormat::argb4444},
     {"l8", TextureFormat::l8},
     {"a8", TextureFormat::a8},
     {"i8", TextureFormat::i8},
     {"la88", TextureFormat::la88},
     {"dxt1", TextureFormat::dxt1},
     {"dxt3", TextureFormat::dxt3},
     {"dxt5", TextureFormat::dxt5}}};

/// 20 x 12 texels of random bytes.
PackedTexels packed(TextureFormat format) {
    PackedTexels texels{format, {}};
    for (std::size_t i = 0; i < bytes_of(format, 20, 12); ++i)
        texels.bytes.push_back(static_cast<std::uint8_t>(random_u32(5, i)));
    return texels;
}

Hashes packing_hashes() {
    Hashes hashes;
    for (const auto& [name, format] : formats)
        if (format != TextureFormat::dxt3 && format != TextureFormat::dxt5)
            hashes.push_back(hash_of(fmt::format("pack/{}", name),
                                     pack(format, random_texels(6, 20 * 12), 20, 12)));
    return hashes;
}

}  // namespace

Hashes texture_hashes() {
    Hashes hashes = packing_hashes();
    append(hashes, over_presets([](const auto& m) {
               Hashes of_preset;
               for (const auto& [name, format] : formats)
                   of_preset.push_back(
                       hash_of(preset_name("decode", m, name), decode(m, packed(format), 20, 12)));
               return of_preset;
           }));
    return hashes;
}

}  // namespace twofold::platforms
