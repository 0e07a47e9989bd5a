// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <new>
#include <optional>
#include <span>
#include <vector>

#include "base/parallel/rank_group.h"
#include "solver/angular/sets/direction_set.h"
#include "solver/transport/order/sweep_order.h"

namespace etendue {

/// An order, and the memory of its visits.
struct OwnedOrder {
  std::vector<SweepVisit> visits;
  SweepOrder order;
};

/// The pairs of ordinates whose orders a rank makes.
struct OwnPairs {
  RankGroup* ranks = nullptr;  ///< null: this process alone makes all
  std::vector<char> are_own;   ///< [pair]; empty: all are
};

/// The sweep orders of a direction set, one for each pair of opposite ordinates. As many are kept as fit into
/// the memory that is allowed; the others, and those of other ranks, are made again whenever they are needed.
class SweepOrders {
 public:
  /// The mesh and the directions must outlive it. `bytes` bounds what is kept. Where `stops`, asked by all
  /// threads, says so, SweepStopped is thrown. `share` is called by one thread at a time with the share that
  /// is made.
  SweepOrders(const TetrahedralMesh& mesh, const DirectionSet& directions, std::size_t cells_per_tile,
              LevelOrder levels, std::size_t bytes, int threads, const std::function<bool()>& stops = {},
              const std::function<void(double)>& share = {}, const OwnPairs& own = {});

  /// The order of ordinate 2 `pair`; 2 `pair` + 1 walks it backwards. `remade` holds it if it was not kept;
  /// `maker`, null at first, is one of the calling thread.
  const SweepOrder& of_pair(std::int32_t pair, std::unique_ptr<SweepOrderMaker>& maker,
                            OwnedOrder& remade) const;

  /// As many as one process alone keeps.
  int kept_count() const { return kept_count_; }
  int pair_count() const { return static_cast<int>(orders_.size()); }
  /// Lagged faces of one pair, known for all pairs; and where they begin in the list of all.
  std::size_t lagged_count(std::int32_t pair) const {
    return lagged_start_[static_cast<std::size_t>(pair) + 1] - lagged_start_[static_cast<std::size_t>(pair)];
  }
  std::size_t lagged_start(std::int32_t pair) const { return lagged_start_[static_cast<std::size_t>(pair)]; }
  std::size_t lagged_total() const { return lagged_start_.back(); }
  std::uint32_t largest_slot_count() const { return largest_slot_count_; }
  /// Steps of every order: tiles.
  std::int32_t step_count() const { return tiles_.count(); }
  const WallSlots& walls() const { return graph_.walls(); }

 private:
  /// Visits are written for the first time where their order is made.
  struct Unwritten {
    void operator()(SweepVisit* memory) const { ::operator delete(memory); }
  };

  /// Where the lagged faces of each pair begin, and the most slots of all, from the numbers of each pair.
  void count_up(std::vector<double>& lagged, std::vector<double>& slots, RankGroup* ranks);
  const Vec3& direction(std::int32_t pair) const;  ///< of its first ordinate
  std::span<SweepVisit> kept_visits(std::int32_t pair) const;

  SweepGraph graph_;
  SweepTiles tiles_;
  const DirectionSet& directions_;
  LevelOrder levels_;
  std::unique_ptr<SweepVisit[], Unwritten> visits_;  ///< [place of a pair][cell]
  static constexpr std::int32_t not_kept = -1;
  std::vector<std::int32_t> place_;  ///< [pair] among those whose visits are kept, or not_kept
  std::vector<std::optional<SweepOrder>> orders_;
  std::vector<std::size_t> lagged_start_;
  std::uint32_t largest_slot_count_ = 0;
  int kept_count_ = 0;
};

}  // namespace etendue
