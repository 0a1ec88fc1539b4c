#include "texunit/texture_limits.hpp"

#include <bit>

namespace twofold {
namespace {

/// Plain RGBA is stored with 32 bits, and so is LA88, which NV1x does not have.
bool stored_small(const Texture& texture) {
    const auto* packed = std::get_if<PackedTexels>(&texture.texels);
    if (packed == nullptr) return false;
    switch (packed->format) {
        case TextureFormat::rgb565:
        case TextureFormat::argb1555:
        case TextureFormat::xrgb1555:
        case TextureFormat::argb4444:
        case TextureFormat::l8:
        case TextureFormat::a8:
        case TextureFormat::i8:
        case TextureFormat::dxt1:
            return true;
        default:
            return false;
    }
}

}  // namespace

bool SizeLimit::allows(int side) const {
    return side >= 1 && side <= largest &&
           (!powers_of_two || std::has_single_bit(static_cast<unsigned>(side)));
}

std::optional<SizeLimit> size_limit(Preset preset, TextureTarget target, const Texture& texture) {
    if (preset != Preset::nv17) return std::nullopt;
    if (target == TextureTarget::rectangle) return SizeLimit{2047, false};
    if (target == TextureTarget::cube_map)
        return SizeLimit{stored_small(texture) ? 1024 : 512, true};
    return SizeLimit{2048, true};
}

}  // namespace twofold
