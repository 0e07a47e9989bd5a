// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

namespace etendue {

/// What a process has exchanged with others.
struct RankTraffic {
  double seconds = 0;          ///< in which it did so, or waited for them
  double bytes = 0;            ///< that it sent
  std::int64_t exchanges = 0;  ///< of all processes with all
};

/// A node of the binary tree in which parts of a sum are added, and the rank that has it: number `index` from
/// the left on its level; leaves are on level 0.
struct SumNode {
  int rank = 0;
  int level = 0;
  std::int32_t index = 0;
};

/// Whether two neighbouring nodes are the children of one.
inline bool are_siblings(const SumNode& left, const SumNode& right) {
  return left.level == right.level && left.index % 2 == 0 && right.index == left.index + 1;
}

inline SumNode parent_of(const SumNode& node) { return {node.rank, node.level + 1, node.index / 2}; }

/// Processes that solve one problem together, on one machine or on many. All of them do the same, with the
/// same values, but for the work that they divide among each other; then each calls the same functions here
/// in the same order with arrays of the same sizes. Each returns once it has what the others bring.
class RankGroup {
 public:
  virtual ~RankGroup() = default;

  virtual int rank() const = 0;  ///< of this process, from 0
  virtual int count() const = 0;
  /// Threads for this process where the case asks for none: the cores of its machine are shared with the
  /// others there.
  virtual int threads() const = 0;
  virtual RankTraffic traffic() const = 0;

  /// The sum of a tree (SumNode) of which each rank has some nodes: `nodes` are those of all ranks from left
  /// to right, which together make the whole tree, `own` the arrays of this rank's in the same order, of the
  /// size of `sum`. One of them may be `sum`.
  virtual void sum_tree(std::span<const SumNode> nodes, std::span<const std::span<const double>> own,
                        std::span<double> sum) = 0;
  /// Brings entries that one rank has, and that are zero with all others, to all. Bits stay as they are.
  virtual void merge(std::span<double> values) = 0;
  /// Whether it is true for any rank.
  virtual bool any(bool value) = 0;
  /// The same of processes that may have to wait long for each other: no core is kept busy meanwhile.
  virtual bool meet(bool value) = 0;
  /// Brings the values of one rank to all.
  virtual void bring(std::span<double> values, int from) = 0;

  /// The value of the first rank.
  double of_first(double value) {
    bring({&value, 1}, 0);
    return value;
  }
};

/// Which of many like things a process does where several share them: blocks of them in turns.
class RankShare {
 public:
  /// Null: all.
  explicit RankShare(const RankGroup* ranks)
      : rank_(ranks != nullptr ? static_cast<std::size_t>(ranks->rank()) : 0),
        count_(ranks != nullptr ? static_cast<std::size_t>(ranks->count()) : 1) {}

  bool has(std::size_t thing) const { return thing / block % count_ == rank_; }

 private:
  static constexpr std::size_t block = 64;

  std::size_t rank_, count_;
};

/// Whether it is true for any process of a group; null: for this one, which is alone.
inline bool any_of(RankGroup* ranks, bool value) { return ranks != nullptr ? ranks->any(value) : value; }

inline bool meet(RankGroup* ranks, bool value) { return ranks != nullptr ? ranks->meet(value) : value; }

/// Whether this process writes what all of a group find: the first does.
inline bool writes_results(const RankGroup* ranks) { return ranks == nullptr || ranks->rank() == 0; }

/// Numbers that are exchanged at a time.
inline constexpr std::size_t exchange_block = std::size_t{1} << 22;

/// Begin of the share of a rank in a block of so many numbers; the share ends where that of the next rank
/// begins. In an array each block of `exchange_block` numbers, and the last, has shares of its own.
inline std::size_t begin_of_share(std::size_t block, int rank, int ranks) {
  return block * static_cast<std::size_t>(rank) / static_cast<std::size_t>(ranks);
}

/// Calls `use(first, size)` for each block of an array of so many numbers.
template <class Use>
void for_each_block(std::size_t numbers, const Use& use) {
  for (std::size_t first = 0; first < numbers; first += exchange_block)
    use(first, std::min(exchange_block, numbers - first));
}

}  // namespace etendue
