// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "solver/transport/order/sweep_tiles.h"

namespace etendue {

/// Cells that have all that they wait for. Those of the tiles that are open are given back together in the
/// order of their numbers: along the space-filling curve, so that neighbours in the order are neighbours in
/// memory. The others are kept until their tile is opened.
class ReadyCells {
 public:
  ReadyCells(std::size_t cells, const SweepTiles& tiles)
      : tiles_(tiles),
        step_of_(static_cast<std::size_t>(tiles.count())),
        bits_(cells / 64 + 1),
        filled_(bits_.size() / 64 + 1),
        next_(cells),
        first_(step_of_.size()) {}

  /// Forgets all cells, and takes the tiles in the order of this direction.
  void begin(const Vec3& direction) {
    sequence_ = tiles_.along(direction);
    step_ = -1;
    count_ = 0;
    std::fill(bits_.begin(), bits_.end(), 0);
    std::fill(filled_.begin(), filled_.end(), 0);
    std::fill(first_.begin(), first_.end(), none);
    for (std::size_t step = 0; step < sequence_.size(); ++step)
      step_of_[static_cast<std::size_t>(sequence_[step])] = static_cast<std::int32_t>(step);
  }

  /// Opens the tile of the next step; false where there is none.
  bool open_next() {
    if (++step_ == static_cast<std::int32_t>(sequence_.size())) return false;
    const std::size_t tile = static_cast<std::size_t>(sequence_[static_cast<std::size_t>(step_)]);
    for (std::uint32_t cell = first_[tile]; cell != none; cell = next_[cell]) set(cell);
    return true;
  }

  void add(std::uint32_t cell) {
    const auto tile = static_cast<std::size_t>(tiles_.of_cell(cell));
    if (step_of_[tile] > step_) {
      next_[cell] = first_[tile];
      first_[tile] = cell;
    } else {
      set(cell);
    }
  }

  /// Puts those of open tiles behind the others in `cells` and forgets them.
  void move_to(std::vector<std::uint32_t>& cells) {
    const std::size_t before = cells.size();
    cells.resize(before + count_);
    std::uint32_t* next = cells.data() + before;
    for (std::size_t i = 0; i < filled_.size(); ++i)
      for (std::uint64_t words = std::exchange(filled_[i], 0); words != 0; words &= words - 1) {
        const std::size_t word = 64 * i + static_cast<std::size_t>(std::countr_zero(words));
        for (std::uint64_t bits = std::exchange(bits_[word], 0); bits != 0; bits &= bits - 1)
          *next++ =
              static_cast<std::uint32_t>(64 * word) + static_cast<std::uint32_t>(std::countr_zero(bits));
      }
    count_ = 0;
  }

 private:
  static constexpr std::uint32_t none = ~0U;

  void set(std::uint32_t cell) {
    const std::size_t word = cell / 64;
    bits_[word] |= std::uint64_t{1} << (cell % 64);
    filled_[word / 64] |= std::uint64_t{1} << (word % 64);
    ++count_;
  }

  const SweepTiles& tiles_;
  std::vector<std::int32_t> sequence_;
  std::vector<std::int32_t> step_of_;  ///< [tile]
  std::int32_t step_ = -1;
  std::size_t count_ = 0;              ///< cells in open tiles
  std::vector<std::uint64_t> bits_;    ///< of them
  std::vector<std::uint64_t> filled_;  ///< bit for each word of bits_ that is not zero
  std::vector<std::uint32_t> next_;    ///< [cell] the next one that waits for the same tile
  std::vector<std::uint32_t> first_;   ///< [tile] the first one that waits for it
};

}  // namespace etendue
