#include "factor/channel_passes.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "factor/simd_clones.hpp"
#include "texunit/ordered_sum.hpp"

namespace twofold {

namespace {

/// A value of each channel at every row or column, as three arrays; a channel that is not there
/// reads one of the others and is not looked at.
struct LaneArrays {
    std::array<const double*, 3> channel;

    [[gnu::always_inline]] ChannelLanes at(std::size_t i) const {
        return lanes_of(channel[0][i], channel[1][i], channel[2][i]);
    }
};

/// A part of the sample rows, and what a pass over it reads and writes.
struct SamplePart {
    RowReader read;
    LaneArrays weight, right_side;
    std::size_t first, end;
    ChannelLanes* sums;     ///< over the columns
    ChannelLanes* u;        ///< of all rows, where the pass sets it
    ChannelLanes* squares;  ///< of u, a sum of each 256 rows, left to right
};

/// A row of the part, weighted.
struct Row {
    const SamplePart& part;
    std::size_t i;
    const RunWeights& entries;
    std::size_t k;
    ChannelLanes weight;

    [[gnu::always_inline]] ChannelLanes times(const ChannelLanes* x) const {
        return weight * part.read.times(i, entries, k, x);
    }
    [[gnu::always_inline]] ChannelLanes right_side() const {
        return weight * part.right_side.at(i);
    }
    [[gnu::always_inline]] ChannelLanes u() const { return part.u[i]; }
    [[gnu::always_inline]] ChannelLanes set(const ChannelLanes& u) const {
        part.u[i] = u;
        part.squares[i / sum_block] += u * u;
        return u;
    }
};

/// Adds the rows times r to the sums of the columns. @param residual residual(row) gives r
template <class Residual>
[[gnu::always_inline]] inline void add_rows(const SamplePart& part, const Residual& residual) {
    for_rows(
        part.read, part.first, part.end,
        [&](std::size_t i, const RunWeights& entries, std::size_t k)
            __attribute__((always_inline)) {
                const Row row{part, i, entries, k, part.weight.at(i)};
                part.read.add(i, entries, k, row.weight * residual(row), part.sums);
            });
}

TWOFOLD_SIMD_CLONES
void add_normal(const SamplePart& part, const ChannelLanes* x) {
    add_rows(
        part, [&](const Row& row) __attribute__((always_inline)) { return row.times(x); });
}

TWOFOLD_SIMD_CLONES
void add_gradient(const SamplePart& part, const ChannelLanes* x) {
    add_rows(
        part, [&](const Row& row)
                  __attribute__((always_inline)) { return row.right_side() - row.times(x); });
}

TWOFOLD_SIMD_CLONES
void add_start(const SamplePart& part, const ChannelLanes* x) {
    add_rows(
        part, [&](const Row& row) __attribute__((always_inline)) {
            return row.set(row.right_side() - row.times(x));
        });
}

TWOFOLD_SIMD_CLONES
void add_step(const SamplePart& part, const ChannelLanes* x, const ChannelLanes& keep) {
    add_rows(
        part, [&](const Row& row) __attribute__((always_inline)) {
            return row.set(row.times(x) - keep * row.u());
        });
}

void add_part(PassKind kind, const SamplePart& part, const ChannelLanes* x,
              const ChannelLanes& keep) {
    switch (kind) {
        case PassKind::right_side:
            return;  // the systems have it
        case PassKind::normal:
            return add_normal(part, x);
        case PassKind::gradient:
            return add_gradient(part, x);
        case PassKind::start:
            return add_start(part, x);
        case PassKind::step:
            return add_step(part, x, keep);
    }
}

/// The rows of the regulariser, whose weight is 1 and right side 0, and what a pass over them reads
/// and writes.
struct RestPart {
    const SparseMatrix& rows;
    ChannelLanes* sums;     ///< over the columns
    ChannelLanes* u;        ///< of these rows, where the pass sets it
    ChannelLanes* squares;  ///< of u, a sum of each 256 rows
};

/// r of a row, from its product with x.
[[gnu::always_inline]] inline ChannelLanes residual_of(PassKind kind, const ChannelLanes& product,
                                                       const ChannelLanes& keep,
                                                       const ChannelLanes* u) {
    if (kind == PassKind::normal) return product;
    return kind == PassKind::step ? product - keep * *u : ChannelLanes{} - product;
}

TWOFOLD_SIMD_CLONES
void add_rest(PassKind kind, const RestPart& part, const ChannelLanes* x,
              const ChannelLanes& keep) {
    const bool sets_u = part.u != nullptr;
    for (std::size_t i = 0; i < part.rows.rows(); ++i) {
        const auto row = part.rows.row(i);
        ChannelLanes product;
        for (const MatrixEntry& e : row) product += e.value * x[e.column];
        const ChannelLanes r = residual_of(kind, product, keep, sets_u ? part.u + i : nullptr);
        for (const MatrixEntry& e : row) part.sums[e.column] += e.value * r;
        if (!sets_u) continue;
        part.u[i] = r;
        part.squares[i / sum_block] += r * r;
    }
}

/// Quotients of three arrays, beside each other ...
TWOFOLD_SIMD_CLONES
void divide(const LaneArrays& a, const std::vector<ChannelLanes>& b, ChannelLanes* quotients) {
    for (std::size_t j = 0; j < b.size(); ++j) quotients[j] = a.at(j) / b[j];
}

/// ... and of sums of two, back in three arrays.
TWOFOLD_SIMD_CLONES
void divide(const ChannelLanes* a, const ChannelLanes* more, const std::vector<ChannelLanes>& b,
            const std::array<double*, 3>& quotients) {
    for (std::size_t j = 0; j < b.size(); ++j) {
        const ChannelLanes quotient = (a[j] + more[j]) / b[j];
        for (std::size_t c = 0; c < 3; ++c) quotients[c][j] = quotient[c];
    }
}

/// @param of of(system) gives the array of a system
template <class Of>
LaneArrays arrays_of(const std::vector<const WeightedSystem*>& systems, const Of& of) {
    LaneArrays arrays{};
    for (std::size_t c = 0; c < 3; ++c)
        arrays.channel[c] = of(*systems[c < systems.size() ? c : 0]).data();
    return arrays;
}

bool sets_rows(PassKind kind) { return kind == PassKind::start || kind == PassKind::step; }

std::size_t runs_of(std::size_t rows) { return (rows + sum_block - 1) / sum_block; }

double tree_of(const std::vector<ChannelLanes>& sums, std::size_t channel) {
    BlockTree tree;
    for (const ChannelLanes& sum : sums) tree.add(sum[channel]);
    return tree.total();
}

/// The kind of the first system that asks for something.
std::optional<PassKind> first_kind(const std::vector<const RowPass*>& asked) {
    for (const RowPass* pass : asked)
        if (pass != nullptr) return pass->kind;
    return std::nullopt;
}

}  // namespace

struct ChannelPasses::Sums {
    std::vector<ChannelLanes> columns;  ///< without the regulariser's
    std::vector<ChannelLanes> squares;  ///< of runs of 256 sample rows, then of the others
};

ChannelPasses::ChannelPasses(std::vector<const WeightedSystem*> systems, int threads)
    : systems_(std::move(systems)),
      threads_(threads),
      scale_(matrix().columns()),
      x_(matrix().padded_columns()),
      rest_columns_(matrix().columns()) {
    const LaneArrays scale = arrays_of(
        systems_, [](const WeightedSystem& s) -> const Vector& { return s.column_scale(); });
    for (std::size_t j = 0; j < scale_.size(); ++j) scale_[j] = scale.at(j);
}

std::vector<PassResult> ChannelPasses::operator()(
    const std::vector<std::optional<RowPass>>& asked) {
    std::vector<PassResult> results(asked.size());
    Asked left(asked.size());
    for (std::size_t c = 0; c < left.size(); ++c)
        if (asked[c] && asked[c]->kind == PassKind::right_side)
            results[c] = {systems_[c]->gradient()};
        else if (asked[c])
            left[c] = &*asked[c];
    while (const auto kind = first_kind(left)) {
        Asked now(left.size());
        for (std::size_t c = 0; c < left.size(); ++c)
            if (left[c] != nullptr && left[c]->kind == *kind)
                now[c] = std::exchange(left[c], nullptr);
        const Sums sums = pass(*kind, now);
        std::array<Vector, 3> columns = scaled_columns(sums);
        for (std::size_t c = 0; c < now.size(); ++c)
            if (now[c] != nullptr)
                results[c] = {systems_[c]->without_null_vectors(std::move(columns[c])),
                              std::sqrt(tree_of(sums.squares, c))};
    }
    return results;
}

ChannelPasses::Sums ChannelPasses::pass(PassKind kind, const Asked& asked) {
    ChannelLanes keep{
        ChannelLanes::Values{-1.0, -1.0, -1.0, -1.0}};  // u = 0 + u of a system that waits
    for (std::size_t c = 0; c < asked.size(); ++c)
        if (asked[c] != nullptr) keep.at[c] = asked[c]->keep;
    if (sets_rows(kind)) u_.resize(matrix().rows());
    set_unknowns(asked);
    return row_pass(kind, keep);
}

/// D^-1 y of the systems that ask, 0 of the others.
void ChannelPasses::set_unknowns(const Asked& asked) {
    Vector zeros;
    LaneArrays y{};
    for (std::size_t c = 0; c < 3; ++c) {
        const bool asks = c < asked.size() && asked[c] != nullptr;
        if (!asks) zeros.resize(scale_.size());
        y.channel[c] = asks ? asked[c]->x->data() : zeros.data();
    }
    divide(y, scale_, x_.data());
}

std::array<Vector, 3> ChannelPasses::scaled_columns(const Sums& sums) const {
    std::array<Vector, 3> columns;
    for (Vector& channel : columns) channel.resize(scale_.size());
    divide(sums.columns.data(), rest_columns_.data(), scale_,
           {columns[0].data(), columns[1].data(), columns[2].data()});
    return columns;
}

ChannelPasses::Sums ChannelPasses::row_pass(PassKind kind, const ChannelLanes& keep) {
    Sums sums;
    std::vector<ChannelLanes> squares;
    sums.squares.resize(sets_rows(kind) ? runs_of(matrix().samples()) : 0);
    const LaneArrays weight = arrays_of(
        systems_, [](const WeightedSystem& s) -> const Vector& { return s.right().weight; });
    const LaneArrays right = arrays_of(
        systems_, [](const WeightedSystem& s) -> const Vector& { return s.right().right_side; });
    sums.columns = matrix().sum_samples<ChannelLanes>(
        [&](std::size_t first, std::size_t end, ChannelLanes* columns) {
            add_part(kind,
                     {matrix().reader(), weight, right, first, end, columns, u_.data(),
                      sums.squares.data()},
                     x_.data(), keep);
        },
        [&] { squares = regulariser_pass(kind, keep); }, threads_);
    sums.squares.insert(sums.squares.end(), squares.begin(), squares.end());
    return sums;
}

/// The pass over the regulariser's rows. @return the squares of its runs of rows
std::vector<ChannelLanes> ChannelPasses::regulariser_pass(PassKind kind, const ChannelLanes& keep) {
    const SparseMatrix& rows = matrix().regulariser();
    std::vector<ChannelLanes> squares(sets_rows(kind) ? runs_of(rows.rows()) : 0);
    ChannelLanes* const u = sets_rows(kind) ? u_.data() + matrix().samples() : nullptr;
    std::fill(rest_columns_.begin(), rest_columns_.end(), ChannelLanes{});
    add_rest(kind, {rows, rest_columns_.data(), u, squares.data()}, x_.data(), keep);
    return squares;
}

}  // namespace twofold
