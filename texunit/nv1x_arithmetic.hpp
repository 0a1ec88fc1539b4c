#pragma once
#include <cstdint>

/// Vertex arithmetic of the NV1x and NV2x transform engines on binary32 bit patterns: truncation
/// toward zero, sums of up to four terms aligned at once, reciprocals from a seed table and two
/// Newton steps. Denormals count as zero. All in unsigned integers, so every platform computes the
/// same bits.
/// @source public NV1x model of envytools (nvhw/pgraph_celsius_xfrm.c, nvhw/xf.c), restated
namespace twofold::nv1x {

using Word = std::uint32_t;

/// Product, cut toward zero. 0 times anything is +0, infinity loses its sign, overflow is the
/// largest finite number.
Word mul(Word a, Word b);

/// Sum of four terms in one 32-bit accumulator, cut; not the same as adding in pairs. Unused terms
/// are 0.
Word sum(Word a, Word b, Word c = 0, Word d = 0);

/// 1 / a to 2^-21.2 relative.
Word reciprocal(Word a);

/// The form used for clip w: its exponent is held within 63..191, so 1/0 is 2^64.
Word clip_reciprocal(Word w);

/// 1 / sqrt(|a|) to 7.31e-7 relative.
Word reciprocal_sqrt(Word a);

/// The same three of NV2x (version 2 of the public model): seeds rounded to nearest instead of cut,
/// and a clip reciprocal whose exponent is held loses its fraction. To 2.28e-7 and 3.13e-7
/// relative.
Word reciprocal_v2(Word a);
Word clip_reciprocal_v2(Word w);
Word reciprocal_sqrt_v2(Word a);

/// Colour component to byte: cut to 13 fraction bits, times 255, halves up, by sign for NaN and
/// infinity.
int float_to_byte(Word a);

/// The 22-bit rounding that red, green and blue (not alpha) go through before float_to_byte.
Word round_to_22_bits(Word a);

}  // namespace twofold::nv1x

namespace twofold {

/// The vertex operations of IeeeArithmetic with the NV1x chip's arithmetic.
struct Nv1xArithmetic {
    using Word = nv1x::Word;

    static Word from_double(double x);
    static double to_double(Word x);
    static Word negate(Word a) { return a ^ 0x80000000u; }
    static Word mul(Word a, Word b) { return nv1x::mul(a, b); }
    static Word sum(Word a, Word b) { return nv1x::sum(a, b); }
    static Word sum(Word a, Word b, Word c) { return nv1x::sum(a, b, c); }
    static Word sum(Word a, Word b, Word c, Word d) { return nv1x::sum(a, b, c, d); }
    static Word reciprocal(Word a) { return nv1x::reciprocal(a); }
    static Word clip_reciprocal(Word w) { return nv1x::clip_reciprocal(w); }
    /// 1/w leaves the chip's transform engine without its low 8 bits.
    static Word emitted_reciprocal(Word rw) { return rw & ~Word{0xff}; }
    static Word reciprocal_sqrt(Word a) { return nv1x::reciprocal_sqrt(a); }

    /// The chip makes r + (0,0,1) for SPHERE_MAP first and takes 1 off again for REFLECTION_MAP, so
    /// r_z loses its low bits near 0.
    static Word reflect(Word scaled, Word e, bool is_z);
};

/// The same with the reciprocals of NV2x.
struct Nv2xArithmetic : Nv1xArithmetic {
    static Word reciprocal(Word a) { return nv1x::reciprocal_v2(a); }
    static Word clip_reciprocal(Word w) { return nv1x::clip_reciprocal_v2(w); }
    /// 1/w stays whole. Inferred: perspective captures of NV2A fit exact coordinates within 5e-5
    /// texel, which 16 bits of it would not give.
    static Word emitted_reciprocal(Word rw) { return rw; }
    static Word reciprocal_sqrt(Word a) { return nv1x::reciprocal_sqrt_v2(a); }
};

}  // namespace twofold
