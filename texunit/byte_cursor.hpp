#pragma once
#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

#include "texunit/error.hpp"

namespace twofold {

/// Little-endian values out of a file's bytes, never beyond their end. A jump or a read that would
/// leave them is an Error(bad_file) that names the file and the place.
class ByteCursor {
  public:
    ByteCursor(std::span<const unsigned char> bytes, std::string_view name)
        : bytes_(bytes), name_(name) {}

    std::size_t left() const { return bytes_.size() - at_; }
    const std::string& name() const { return name_; }

    void seek(std::uint64_t at) {
        if (at > bytes_.size()) fail(fmt::format("offset {} is past the end", at));
        at_ = static_cast<std::size_t>(at);
    }

    /// The next `count` bytes.
    std::span<const unsigned char> take(std::uint64_t count) {
        if (count > left()) fail(fmt::format("truncated: {} bytes wanted, {} left", count, left()));
        const auto taken = bytes_.subspan(at_, static_cast<std::size_t>(count));
        at_ += taken.size();
        return taken;
    }

    /// The next value of an integer or floating-point type.
    template <class T>
    T value() {
        using Bits = std::conditional_t<
            sizeof(T) == 8, std::uint64_t,
            std::conditional_t<sizeof(T) == 4, std::uint32_t,
                               std::conditional_t<sizeof(T) == 2, std::uint16_t, std::uint8_t>>>;
        std::uint64_t bits = 0;
        int shift = 0;
        for (const unsigned char byte : take(sizeof(T))) {
            bits |= std::uint64_t{byte} << shift;
            shift += 8;
        }
        return std::bit_cast<T>(static_cast<Bits>(bits));
    }

    [[noreturn]] void fail(std::string_view what) const {
        throw Error(ExitCode::bad_file,
                    fmt::format("{}: {} (at byte {} of {})", name_, what, at_, bytes_.size()));
    }

  private:
    std::span<const unsigned char> bytes_;
    std::string name_;
    std::size_t at_ = 0;
};

}  // namespace twofold
