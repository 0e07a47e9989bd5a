// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

#include "base/parallel/rank_group.h"

namespace etendue {

/// Runs of neighbouring batches of a sweep, the leaves of the tree in which they are summed: a power of two.
/// The batches of a section are added one after the other. The order depends neither on threads nor on ranks,
/// each of which takes neighbouring sections.
class BatchSections {
 public:
  explicit BatchSections(std::int32_t batches)
      : batches_(batches),
        count_(static_cast<std::int32_t>(
            std::bit_floor(static_cast<std::uint32_t>(std::clamp(batches, 1, most_sections))))) {}

  std::int32_t count() const { return count_; }
  std::int32_t begin(std::int32_t section) const {
    return static_cast<std::int32_t>(std::int64_t{batches_} * section / count_);
  }
  std::int32_t end(std::int32_t section) const { return begin(section + 1); }

  /// The first section of a rank; that of the next rank ends its own.
  std::int32_t first_of(int rank, int ranks) const {
    return static_cast<std::int32_t>(std::int64_t{count_} * rank / ranks);
  }
  std::int32_t first_batch_of(int rank, int ranks) const {
    return rank < ranks ? begin(first_of(rank, ranks)) : batches_;
  }
  /// The largest subtrees of which each rank has all sections, from left to right.
  std::vector<SumNode> nodes(int ranks) const {
    std::vector<SumNode> all;
    for (int rank = 0; rank < ranks; ++rank) {
      const std::size_t begin = all.size();
      for (std::int32_t s = first_of(rank, ranks); s < first_of(rank + 1, ranks); ++s) {
        all.push_back({rank, 0, s});
        while (all.size() > begin + 1 && are_siblings(all[all.size() - 2], all.back())) {
          all.pop_back();
          all.back() = parent_of(all.back());
        }
      }
    }
    return all;
  }

 private:
  /// With more sections more ranks find work, and sums wait for each other in more memory.
  static constexpr std::int32_t most_sections = 8;

  std::int32_t batches_;
  std::int32_t count_;
};

}  // namespace etendue
