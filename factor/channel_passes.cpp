#include "factor/channel_passes.hpp"

#include <array>
#include <cmath>

#include "factor/simd_clones.hpp"
#include "texunit/ordered_sum.hpp"

namespace twofold {

namespace {

/// A value of each channel at every row, as three arrays; a channel that is not there reads one of
/// the others and is not looked at.
struct RowValues {
    std::array<const double*, 3> channel;

    [[gnu::always_inline]] ChannelLanes at(std::size_t i) const {
        return lanes_of(channel[0][i], channel[1][i], channel[2][i]);
    }
};

/// A part of the sample rows, and what a pass over it reads and writes.
struct SamplePart {
    RowReader read;
    RowValues weight, right_side;
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

/// The same for a row of the regulariser, whose weight is 1 and right side 0.
ChannelLanes residual_of(PassKind kind, const ChannelLanes& product, const ChannelLanes& keep,
                         const ChannelLanes& u) {
    switch (kind) {
        case PassKind::right_side:
            break;
        case PassKind::normal:
            return product;
        case PassKind::gradient:
        case PassKind::start:
            return ChannelLanes{} - product;
        case PassKind::step:
            return product - keep * u;
    }
    return {};
}

/// A x of the regulariser.
TWOFOLD_SIMD_CLONES
void multiply(const SparseMatrix& regulariser, const ChannelLanes* x, ChannelLanes* product) {
    for (std::size_t i = 0; i < regulariser.rows(); ++i) {
        ChannelLanes sum;
        for (const MatrixEntry& e : regulariser.row(i)) sum += e.value * x[e.column];
        product[i] = sum;
    }
}

/// Adds A^T y of the regulariser.
TWOFOLD_SIMD_CLONES
void add_transposed(const SparseMatrix& regulariser, const ChannelLanes* y, ChannelLanes* sums) {
    for (std::size_t j = 0; j < regulariser.columns(); ++j) {
        ChannelLanes rest;
        for (const MatrixEntry& e : regulariser.column(j)) rest += e.value * y[e.column];
        sums[j] += rest;
    }
}

bool sets_rows(PassKind kind) { return kind == PassKind::start || kind == PassKind::step; }

std::size_t runs_of(std::size_t rows) { return (rows + sum_block - 1) / sum_block; }

double tree_of(const std::vector<ChannelLanes>& sums, std::size_t channel) {
    BlockTree tree;
    for (const ChannelLanes& sum : sums) tree.add(sum[channel]);
    return tree.total();
}

/// The kind of the first system that asks for something.
std::optional<PassKind> first_kind(const std::vector<std::optional<RowPass>>& asked) {
    for (const auto& pass : asked)
        if (pass) return pass->kind;
    return std::nullopt;
}

}  // namespace

struct ChannelPasses::Sums {
    std::vector<ChannelLanes> columns;
    std::vector<ChannelLanes> squares;  ///< of runs of 256 sample rows, then of the others
};

ChannelPasses::ChannelPasses(std::vector<const WeightedSystem*> systems, int threads)
    : systems_(std::move(systems)), threads_(threads) {}

std::vector<PassResult> ChannelPasses::operator()(
    const std::vector<std::optional<RowPass>>& asked) {
    std::vector<PassResult> results(asked.size());
    std::vector<std::optional<RowPass>> left = asked;
    for (std::size_t c = 0; c < left.size(); ++c)
        if (left[c] && left[c]->kind == PassKind::right_side) {
            results[c] = {systems_[c]->gradient()};
            left[c].reset();
        }
    while (const auto kind = first_kind(left)) {
        std::vector<std::optional<RowPass>> now(left.size());
        for (std::size_t c = 0; c < left.size(); ++c)
            if (left[c] && left[c]->kind == *kind) now[c] = std::exchange(left[c], std::nullopt);
        const Sums sums = pass(*kind, now);
        for (std::size_t c = 0; c < now.size(); ++c) {
            if (!now[c]) continue;
            Vector columns(sums.columns.size());
            for (std::size_t j = 0; j < columns.size(); ++j) columns[j] = sums.columns[j][c];
            results[c] = {systems_[c]->scaled_product(std::move(columns)),
                          std::sqrt(tree_of(sums.squares, c))};
        }
    }
    return results;
}

ChannelPasses::Sums ChannelPasses::pass(PassKind kind,
                                        const std::vector<std::optional<RowPass>>& asked) {
    ChannelLanes keep{
        ChannelLanes::Values{-1.0, -1.0, -1.0, -1.0}};  // u = 0 + u of a system that waits
    for (std::size_t c = 0; c < asked.size(); ++c)
        if (asked[c]) keep.at[c] = asked[c]->keep;
    const LogMatrix& matrix = systems_[0]->left().matrix;
    if (sets_rows(kind)) u_.resize(matrix.rows());
    const std::vector<ChannelLanes> x = unknowns(asked);
    Sums sums = sample_pass(kind, x, keep);
    add_regulariser(sums, kind, x, keep);
    return sums;
}

/// D^-1 y of the systems that ask, 0 of the others, beside each other.
std::vector<ChannelLanes> ChannelPasses::unknowns(
    const std::vector<std::optional<RowPass>>& asked) const {
    std::vector<ChannelLanes> lanes(systems_[0]->left().matrix.padded_columns());
    for (std::size_t c = 0; c < asked.size(); ++c) {
        if (!asked[c]) continue;
        const Vector x = systems_[c]->unknowns(asked[c]->x);
        for (std::size_t j = 0; j < x.size(); ++j) lanes[j].at[c] = x[j];
    }
    return lanes;
}

ChannelPasses::Sums ChannelPasses::sample_pass(PassKind kind, const std::vector<ChannelLanes>& x,
                                               const ChannelLanes& keep) {
    const LogMatrix& matrix = systems_[0]->left().matrix;
    Sums sums;
    sums.squares.resize(sets_rows(kind) ? runs_of(matrix.samples()) : 0);
    const auto values = [&](const Vector& (*of)(const ChannelRows&)) {
        RowValues rows{};
        for (std::size_t c = 0; c < 3; ++c)
            rows.channel[c] = of(systems_[c < systems_.size() ? c : 0]->right()).data();
        return rows;
    };
    const RowValues weight = values([](const ChannelRows& r) -> const Vector& { return r.weight; });
    const RowValues right =
        values([](const ChannelRows& r) -> const Vector& { return r.right_side; });
    sums.columns = matrix.sum_samples<ChannelLanes>(
        [&](std::size_t first, std::size_t end, ChannelLanes* columns) {
            add_part(kind,
                     {matrix.reader(), weight, right, first, end, columns, u_.data(),
                      sums.squares.data()},
                     x.data(), keep);
        },
        threads_);
    return sums;
}

void ChannelPasses::add_regulariser(Sums& sums, PassKind kind, const std::vector<ChannelLanes>& x,
                                    const ChannelLanes& keep) {
    const LogMatrix& matrix = systems_[0]->left().matrix;
    const SparseMatrix& regulariser = matrix.regulariser();
    std::vector<ChannelLanes> residual(regulariser.rows());
    std::vector<ChannelLanes> squares(sets_rows(kind) ? runs_of(residual.size()) : 0);
    multiply(regulariser, x.data(), residual.data());
    for (std::size_t i = 0; i < residual.size() && kind != PassKind::normal; ++i) {
        ChannelLanes* u = sets_rows(kind) ? &u_[matrix.samples() + i] : nullptr;
        residual[i] = residual_of(kind, residual[i], keep, u != nullptr ? *u : ChannelLanes{});
        if (u == nullptr) continue;
        *u = residual[i];
        squares[i / sum_block] += residual[i] * residual[i];
    }
    sums.squares.insert(sums.squares.end(), squares.begin(), squares.end());
    sums.columns.resize(matrix.columns());
    add_transposed(regulariser, residual.data(), sums.columns.data());
}

}  // namespace twofold
