"""Planted faults: one change of one place each, and the test sources that must notice it."""
from dataclasses import dataclass


@dataclass(frozen=True)
class Mutant:
    name: str
    fault: str            # in words
    file: str
    old: str              # occurs once in the file
    new: str
    tests: tuple          # sources of the test program
    also: tuple = ()      # sources compiled with the fault because they include the file
    flags: tuple = ()     # compiler flags of the fault
    only: str = ""        # test names to run: all but hidden ones unless given


def unit(name, fault, file, old, new, *tests, **more):
    return Mutant(name, fault, f"texunit/{file}", old, new,
                  tuple(f"tests/texunit/{t}_test.cpp" for t in tests), **more)


def raster(name, fault, file, old, new, *tests, **more):
    return Mutant(name, fault, f"raster/{file}", old, new,
                  tuple(f"tests/raster/{t}_test.cpp" for t in tests), **more)


def factor(name, fault, file, old, new, *tests, **more):
    return Mutant(name, fault, f"factor/{file}", old, new,
                  tuple(f"tests/factor/{t}_test.cpp" for t in tests), **more)


BYTES = [
    unit("product-rounding", "a b / 255 is rounded down at the middle", "byte_arithmetic.hpp",
         "const int t = a * b + 128;", "const int t = a * b + 127;", "byte_arithmetic"),
    unit("product-shift", "a b >> 8 in place of a b / 255", "byte_arithmetic.hpp",
         "return (t + (t >> 8)) >> 8;", "return (t - 128) >> 8;", "byte_arithmetic"),
    unit("lerp-rounding", "the filter's halves are cut", "byte_arithmetic.hpp",
         "(256 * p + (q - p) * w + 128) >> 8", "(256 * p + (q - p) * w) >> 8", "byte_arithmetic"),
    unit("sum-saturates", "a sum of two products wraps at 256", "byte_arithmetic.hpp",
         "return rounded < 255 ? rounded : 255;", "return rounded & 255;", "byte_arithmetic"),
    unit("byte-of-real", "255 x is cut, not rounded", "byte_arithmetic.hpp",
         "static_cast<int>(255.0 * x + 0.5)", "static_cast<int>(255.0 * x)", "byte_arithmetic"),
    unit("weight-rounds", "a filter weight is rounded instead of cut", "nv17.hpp",
         "static_cast<int>(steps * f)", "static_cast<int>(steps * f + 0.5)", "numeric_model"),
    unit("weight-256", "a fraction that rounded to 1 weighs 256 of 256", "nv17.hpp",
         "static_cast<int>(steps * f) : steps - 1", "static_cast<int>(steps * f) : steps",
         "numeric_model", "sample"),
    unit("half-bias", "-1/2 is -127", "nv17.hpp",
         "return (e > 0 ? e : 0) - 128;", "return (e > 0 ? e : 0) - 127;", "combiner",
         "numeric_model"),
    unit("half-scale", "half of an odd value is rounded down", "nv17.hpp", "return (x + 1) >> 1;",
         "return x >> 1;", "combiner", "numeric_model"),
    unit("color-weights", "an iterated colour's weights are held one by one, not together",
         "nv17.hpp", "256.0 * l2 / sum, 256 - n0)", "256.0 * l2 / sum, 256)",
         "colour_and_pixel_laws"),
    unit("depth-wraps", "depth 1 is not held back", "real_model.hpp",
         "return static_cast<std::uint32_t>(z < 1.0 ? z * steps + 0.5 : steps);",
         "return static_cast<std::uint32_t>(z * steps + 0.5) & ((1u << bits) - 1);",
         "colour_and_pixel_laws"),
]

NUMBERS = [
    unit("exp-term", "a term of exp's series is missing", "exact_math.hpp",
         "    sum = sum * r + 1.0 / 40320.0;\n", "    sum = sum * r;\n", "exact_math",
         only="exp is within*"),
    unit("log-low", "log adds no low part of ln 2", "exact_math.hpp",
         "(series + k * ln2_low)", "(series + k * 0.0)", "exact_math", only="log is within*"),
    unit("sum-sequential", "a block's lanes are added one after another", "ordered_sum.hpp",
         "    return ((lane[0] + lane[1]) + (lane[2] + lane[3])) +\n"
         "           ((lane[4] + lane[5]) + (lane[6] + lane[7]));",
         "    double sum = 0.0;\n    for (const double l : lane) sum += l;\n    return sum;",
         "ordered_sum"),
    unit("sum-lanes", "four lanes instead of eight", "ordered_sum.hpp",
         "lane[j] += term(first + i + j);\n    }", "lane[j & 3] += term(first + i + j);\n    }",
         "ordered_sum"),
    unit("sum-tree", "a subtree is added from the right", "ordered_sum.hpp",
         "        subtree_[level] = block_sum;\n", "        subtree_[level] = block_sum + 0x1p-50;\n",
         "ordered_sum"),
    unit("floor-truncates", "negative numbers become integers toward zero", "fixed.hpp",
         "static_cast<Integer>(std::floor(inside))", "static_cast<Integer>(inside)", "fixed"),
    unit("nan-payload", "a NaN keeps its payload in a hash", "fixed.hpp",
         "return x == x ? x : std::bit_cast<double>(canonical_nan_bits_f64);", "return x;",
         "fixed", "fnv1a"),
    unit("hash-order", "a word is hashed from its high byte", "fnv1a.hpp",
         "for (int shift = 0; shift < 32; shift += 8)", "for (int shift = 24; shift >= 0; shift -= 8)",
         "fnv1a"),
    unit("random-constant", "a shift of the random generator", "random.hpp", "(z ^ (z >> 27))",
         "(z ^ (z >> 26))", "random"),
    unit("nv1x-product", "a product of the transform engine is rounded, not cut",
         "nv1x_arithmetic.cpp", "significand_of(b) >> 23;", "significand_of(b) + (1u << 22) >> 23;",
         "nv1x_arithmetic"),
    unit("nv1x-sphere", "r_z does not pass through r_z + 1", "nv1x_arithmetic.cpp",
         "if (!is_z) return", "if (true || !is_z) return", "nv1x_arithmetic", "texgen"),
    Mutant("contraction", "sums of products are fused in the lighting sum", "factor/light_block.cpp",
           "namespace twofold {", "namespace twofold { ", ("hashes",),
           flags=("-O2", "-mfma", "-ffp-contract=fast")),
]

TEXTURES = [
    unit("q-zero", "0 / 0 stays what it is", "texel_address.hpp",
         "    if (!(u == u)) return Real{0};\n", "", "texel_address", "sample"),
    unit("far-texel", "a far coordinate is not held", "texel_address.hpp",
         "return u < -limit ? -limit : (u > limit ? limit : u);", "return u;", "texel_address",
         "sample"),
    unit("last-texel", "u = size is the texel behind the last", "texel_address.hpp",
         "if (i == size && wrap != Wrap::clamp_to_border) return size - 1;", "", "texel_address",
         "sample"),
    unit("texel-centre", "a footprint begins half a texel late", "texel_address.hpp",
         "limit_coordinate(u, size, wrap) - Real{0.5};", "limit_coordinate(u, size, wrap);",
         "texel_address", "sample"),
    unit("wrap-index", "REPEAT finds the neighbour of the last texel one too far",
         "texel_address.hpp", "return i < 0 ? i + size : i - size;",
         "return i < 0 ? i + size - 1 : i - size;", "texel_address", "sample"),
    unit("seam-side", "the rim belongs to the back", "paraboloid.cpp", "d.z >= 0.0 ? Face::front",
         "d.z > 0.0 ? Face::front", "paraboloid"),
    unit("opaque-rim", "alpha ends half a texel beyond the rim", "paraboloid.cpp",
         "<= 1.0 + 1.5 * texel", "<= 1.0 + 0.5 * texel", "paraboloid"),
    unit("level-tie", "half-way between two levels is the coarser", "mipmap.hpp",
         "return -static_cast<int>(std::floor(0.5 - lambda));",
         "return static_cast<int>(std::floor(0.5 + lambda));", "mipmap"),
    unit("dxt-thirds", "means of block colours are cut", "dxt.hpp",
         "return (wa * a + wb * b + n / 2) / n;", "return (wa * a + wb * b) / n;", "dxt"),
    unit("565-order", "red and blue of 5:6:5 change places", "texture_format.hpp",
         "{{{11, 5}, {5, 6}, {0, 5}, one}}", "{{{0, 5}, {5, 6}, {11, 5}, one}}", "texture_format"),
    unit("cube-tie", "y wins a tie against z only by being larger", "cube_map.hpp",
         "if (y >= z) return", "if (y > z) return", "cube_map"),
]

TRIANGLES = [
    raster("edge-rule", "every edge holds its points", "setup.hpp",
           "value >= (holds_its_points ? 0 : 1)", "value >= 0", "setup", "hard_coverage",
           also=("raster/reference.cpp",), only="*hold their points,R03*,R04*"),
    raster("edge-rule-right", "right edges hold their points, left ones do not", "setup.hpp",
           "left = dy < 0;", "left = dy > 0;", "setup"),
    raster("int32-edges", "edge functions in 32 bits", "setup.hpp",
           "return a * p.x + b * p.y + c; }",
           "return static_cast<std::int32_t>(static_cast<std::uint32_t>(a * p.x + b * p.y + c)); }",
           "hard_coverage", only="R11*"),
    raster("first-pixel", "the first pixel of a row is one late", "coverage.hpp",
           "return (x - half + (std::int64_t{1} << fraction_bits) - 1) >> fraction_bits;",
           "return (x - half + (std::int64_t{1} << fraction_bits)) >> fraction_bits;", "coverage"),
    raster("clip-order", "a cut edge is computed from the end that comes first", "clip.cpp",
           "da >= 0.0 ? between(a, b, da, db) : between(b, a, db, da)", "between(a, b, da, db)",
           "clip", "hard_cases"),
    raster("behind-the-eye", "w <= 0 is not cut", "clip.cpp", "return {c.w - smallest_w,",
           "return {1.0,", "clip", "hard_cases"),
    raster("depth-compare", "LESS takes equal depths", "fragment_ops.hpp",
           "return incoming < stored;", "return incoming <= stored;", "fragment_ops"),
    raster("no-depth-test", "no z test", "fragment.hpp", "if (!compare(test->func, z, stored)) {",
           "if (false) {", "hard_cases", "reference", also=("raster/reference.cpp",)),
    raster("saturate-factor", "SRC_ALPHA_SATURATE without the limit", "fragment_ops.hpp",
           "return in.source[3] < room ? in.source[3] : room;", "return in.source[3];",
           "fragment_ops"),
]

FACTORS = [
    factor("qmr-breakdown", "breakdowns are found by exact zeros", "qmr.cpp",
           "if (std::fabs(s.delta) <= t) return", "if (std::fabs(s.delta) <= 0.0) return",
           "qmr_small_systems", "qmr", only="*QMR ends*,*all 512*"),
    factor("qmr-residual", "the recurrence's residual is believed", "qmr.cpp",
           "if (!progress_->prefers(true_residual, start_residual_)) {", "if (false) {",
           "qmr_small_systems", "qmr", only="*a recurrence*,*all 512*"),
    factor("lsmr-rotation", "a rotation of LSMR has the wrong sign", "lsmr.cpp",
           "zeta_bar_ = -s_bar_ * zeta_bar_;", "zeta_bar_ = s_bar_ * zeta_bar_;", "lsmr", "solve"),
    factor("row-weight", "samples are weighted by the wrong mean", "channel_rows.cpp",
           "exact::pow(treated / channel.mean, row_weight)",
           "exact::pow(treated, row_weight)", "system"),
    factor("floor-off", "radiance is not raised before the logarithm", "channel_rows.cpp",
           "max(lowered(radiance, cap), floor);", "lowered(radiance, cap);", "system"),
    factor("smoothness-mean", "the mean of the neighbours counts the texel too", "system.cpp",
           "-scale / static_cast<double>(count - 1)", "-scale / static_cast<double>(count)",
           "system"),
    factor("fill-power", "the fill weighs by distance, not by its square", "first_guess.cpp",
           "value = 1.0 / value", "value = exact::pow(value, -0.5)", "first_guess"),
    factor("rim-owns-maximum", "a texel that no pass shows can be the maximum", "factor_map.cpp",
           "if (is_opaque(j, shape)) largest = max(largest, log_texels[j]);",
           "largest = max(largest, log_texels[j]);", "factor_map"),
    factor("quantiser-cuts", "a factor's bytes are cut", "factor_map.cpp",
           "to_fixed_half_up(255.0 * x, 0, 255)", "to_fixed(255.0 * x, 0, 255)", "factor_map"),
    factor("nan-check", "a NaN reaches the quantiser", "factor_map.cpp",
           "if (std::isfinite(value)) return;", "return;", "factor_map"),
    factor("solid-angle", "a row's solid angle is that of its upper edge", "environment.cpp",
           "exact::cos(exact::pi * (y + 1) / height)", "exact::cos(exact::pi * y / height)",
           "environment"),
    factor("below-horizon", "views from below the surface are lit", "lighting.cpp",
           "if (!(dot(at.n, at.v) > 0.0)) {", "if (false) {", "lighting"),
    factor("gauge-half", "one map takes the whole difference of the means", "gauge.cpp",
           "0.5 * (mean_over(first, x) - mean_over(second, x))",
           "mean_over(first, x) - mean_over(second, x)", "gauge"),
    factor("order-knots", "samples are put in order without their knots", "row_order.cpp",
           "    put_in_order(rows.knot, first, order);\n", "", "row_order"),
    factor("order-batch", "samples of a later batch are ordered by those of the first",
           "row_order.cpp", "rows.texel[map][first + k] - start", "rows.texel[map][k] - start",
           "row_order"),
    factor("merl-size", "a MERL file's size is not looked at", "merl_file.cpp",
           "if (bytes.size() != file_bytes)", "if (false)", "measured_data", only="D04*"),
]

FAST = [
    Mutant("fast-depth", "vectors let equal depths pass LESS", "raster/lane_math-inl.hpp",
           "case CompareFunc::less:\n            return hn::Lt(z, stored);",
           "case CompareFunc::less:\n            return hn::Not(hn::Lt(stored, z));", ("hashes",),
           also=("raster/cover_lanes.cpp", "raster/finish_lanes.cpp")),
    raster("fast-quotient", "vectors cut custom's products", "lane_rounding.hpp",
           "0.5 * one + 0.25", "0.25", "rounded_lanes"),
    raster("full-row", "a full row is placed as the one above it", "interpolate_lanes.cpp",
           "(out.places.at[i] >> tile_edge_bits) - t.y0;",
           "(out.places.at[i] >> tile_edge_bits) - t.y0 - 1;", "near_lanes"),
    raster("byte-product", "a product of bytes is cut on vectors", "shade_lanes.cpp",
           "hn::Set(U16(), 257)", "hn::Set(U16(), 256)", "near_lanes"),
    Mutant("fast-edge", "vectors leave out what lies on an edge", "raster/cover_lanes.cpp",
           "hn::Gt(e.outside(), hn::Set(d, -1))", "hn::Gt(e.outside(), hn::Zero(d))", ("hashes",)),
]

FILES = ("tests/image_file/atomic_file_test.cpp",)

CHECKS = [
    unit("self-check-fused", "the self-check is compiled with contraction", "self_check.cpp",
         "return a * a + b != T{0};", "return a * a + b != T{0} ;", "self_check",
         flags=("-O2", "-mfma", "-ffp-contract=fast")),
    Mutant("full-disk", "a write that fails is no error", "texunit/atomic_file.cpp",
           'if (count < 0) throw system_error(name, "cannot write", errno);',
           "if (count < 0) return;", FILES),
    Mutant("unflushed", "the temporary file is not renamed when all is written",
           "texunit/atomic_file.cpp", "    temporary.rename_to(path);\n", "", FILES),
]

MUTANTS = BYTES + NUMBERS + TEXTURES + TRIANGLES + FACTORS + FAST + CHECKS
