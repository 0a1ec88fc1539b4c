#pragma once
#include <cstddef>

namespace twofold {

/// A value of each channel, red, green and blue, beside each other, and a fourth that is not looked
/// at: what the channels do in one pass. Every operation is elementwise, so that a channel has the
/// bits it has alone.
struct alignas(32) ChannelLanes {
    using Values = double __attribute__((vector_size(32)));
    Values at{};

    double operator[](std::size_t channel) const { return at[channel]; }
    [[gnu::always_inline]] ChannelLanes& operator+=(const ChannelLanes& b) {
        at += b.at;
        return *this;
    }
};

/// Beside each other by halves: g++ 12 puts four values together through memory.
[[gnu::always_inline]] inline ChannelLanes lanes_of(double red, double green, double blue) {
    using Half = double __attribute__((vector_size(16)));
    return {__builtin_shufflevector(Half{red, green}, Half{blue, 0.0}, 0, 1, 2, 3)};
}

[[gnu::always_inline]] inline ChannelLanes operator+(const ChannelLanes& a, const ChannelLanes& b) {
    return {a.at + b.at};
}
[[gnu::always_inline]] inline ChannelLanes operator-(const ChannelLanes& a, const ChannelLanes& b) {
    return {a.at - b.at};
}
[[gnu::always_inline]] inline ChannelLanes operator*(const ChannelLanes& a, const ChannelLanes& b) {
    return {a.at * b.at};
}
[[gnu::always_inline]] inline ChannelLanes operator/(const ChannelLanes& a, const ChannelLanes& b) {
    return {a.at / b.at};
}
[[gnu::always_inline]] inline ChannelLanes operator*(double a, const ChannelLanes& b) {
    return {a * b.at};
}

}  // namespace twofold
