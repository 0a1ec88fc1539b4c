#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

/// Sums whose rounding depends on the number of terms and the terms alone, never on threads or
/// vectors (docs/exactness.md, section 3): blocks of 256 terms, eight lanes in a block, a binary
/// tree over blocks.
namespace twofold {

/// Terms in a block. Threads compute whole blocks.
inline constexpr std::size_t sum_block = 256;

/// Sum of term(first) ... term(first + count - 1), count <= 256, in the order of one block: term i
/// goes to lane i mod 8 (blocks start at multiples of 256, so i may be counted from the block's
/// start).
template <class Term>
double ordered_block_sum(std::size_t first, std::size_t count, Term&& term) {
    std::array<double, 8> lane{};
    std::size_t i = 0;
    for (; i + 8 <= count; i += 8) {
        for (std::size_t j = 0; j < 8; ++j) lane[j] += term(first + i + j);
    }
    for (std::size_t j = 0; i + j < count; ++j) lane[j] += term(first + i + j);
    return ((lane[0] + lane[1]) + (lane[2] + lane[3])) +
           ((lane[4] + lane[5]) + (lane[6] + lane[7]));
}

/// Sum of p[0 .. n-1], n <= 256, in the order of one block.
inline double ordered_block_sum(const double* p, std::size_t n) {
    return ordered_block_sum(0, n, [p](std::size_t i) { return p[i]; });
}

/// The tree over block sums, fed from left to right: neighbours are added level by level, and an
/// odd last one moves up unchanged. It holds one finished subtree for each bit set in the number of
/// blocks, as a binary counter does, so that no list of block sums is needed.
class BlockTree {
  public:
    /// Takes the sum of the next block.
    void add(double block_sum) {
        std::size_t level = 0;
        for (; (blocks_ >> level & 1) != 0; ++level) block_sum = subtree_[level] + block_sum;
        subtree_[level] = block_sum;
        ++blocks_;
    }

    /// Sum of all blocks so far; +0 for none.
    double total() const {
        std::size_t level = 0;
        while (level < subtree_.size() && (blocks_ >> level & 1) == 0) ++level;
        if (level == subtree_.size()) return 0.0;
        double sum = subtree_[level];
        for (++level; level < subtree_.size(); ++level) {
            if ((blocks_ >> level & 1) != 0) sum = subtree_[level] + sum;
        }
        return sum;
    }

  private:
    std::array<double, 64> subtree_{};
    std::uint64_t blocks_ = 0;
};

/// Sum of finished block sums in the order of the tree.
inline double tree_sum(std::span<const double> blocks) {
    BlockTree tree;
    for (const double block : blocks) tree.add(block);
    return tree.total();
}

/// Sum of term(0) ... term(n - 1); +0 for n = 0. Each term must be a double already: a product is
/// rounded once before it is added.
template <class Term>
double ordered_sum(std::size_t n, Term&& term) {
    BlockTree tree;
    for (std::size_t first = 0; first < n; first += sum_block) {
        const std::size_t count = n - first < sum_block ? n - first : sum_block;
        tree.add(ordered_block_sum(first, count, term));
    }
    return tree.total();
}

}  // namespace twofold
