#pragma once
#include <bit>
#include <cstdint>
#include <string_view>

#include "texunit/fixed.hpp"

namespace twofold {

/// FNV-1a hash of 64 bits, fed by type: integers little-endian by shifts, NaN in its canonical
/// pattern, -0 as it is. Feed fields, never structs or raw memory, and the hash is the same on
/// every platform. An image is width, height and channels as u32, then samples row by row from the
/// top, r g b a.
/// @source G. Fowler, L. C. Noll, K.-P. Vo, FNV hash; constants of the 64-bit variant
class Fnv1a {
  public:
    Fnv1a& u8(std::uint8_t byte) {
        hash_ = (hash_ ^ byte) * 0x100000001b3;
        return *this;
    }

    Fnv1a& u32(std::uint32_t x) {
        for (int shift = 0; shift < 32; shift += 8) u8(static_cast<std::uint8_t>(x >> shift));
        return *this;
    }

    Fnv1a& u64(std::uint64_t x) {
        for (int shift = 0; shift < 64; shift += 8) u8(static_cast<std::uint8_t>(x >> shift));
        return *this;
    }

    Fnv1a& f32(float x) { return u32(std::bit_cast<std::uint32_t>(canonical(x))); }
    Fnv1a& f64(double x) { return u64(std::bit_cast<std::uint64_t>(canonical(x))); }

    /// The bytes of `text`, without length or terminator.
    Fnv1a& text(std::string_view text) {
        for (const char c : text) u8(static_cast<std::uint8_t>(c));
        return *this;
    }

    std::uint64_t value() const { return hash_; }

  private:
    std::uint64_t hash_ = 0xcbf29ce484222325;
};

}  // namespace twofold
