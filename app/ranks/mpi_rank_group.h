// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <mpi.h>

#include <algorithm>
#include <vector>

#include "base/parallel/rank_group.h"

namespace etendue {

/// All processes of MPI. One thread of each calls it.
class MpiRankGroup : public RankGroup {
 public:
  MpiRankGroup();

  int rank() const override { return rank_; }
  int count() const override { return count_; }
  int threads() const override { return std::min(core_share_, bound_cores_); }
  RankTraffic traffic() const override { return traffic_; }
  /// Cores that the launcher has bound this process to, and its share of those of its machine.
  int bound_cores() const { return bound_cores_; }
  int core_share() const { return core_share_; }
  void sum_tree(std::span<const SumNode> nodes, std::span<const std::span<const double>> own,
                std::span<double> sum) override;
  void merge(std::span<double> values) override;
  bool any(bool value) override;
  bool meet(bool value) override;
  void bring(std::span<double> values, int from) override;

 private:
  class Timed;

  /// Sends each rank its share of a block of this rank's `round`-th node, and takes those of others.
  void exchange_round(std::span<const SumNode> nodes, std::size_t round, const double* own, std::size_t size);
  /// Adds the received shares of all nodes up, into that of the first.
  void add_nodes(std::span<const SumNode> nodes, std::size_t share);
  std::size_t begin_of(std::size_t block, int rank) const { return begin_of_share(block, rank, count_); }
  int share_of(std::size_t block, int rank) const {
    return static_cast<int>(begin_of(block, rank + 1) - begin_of(block, rank));
  }

  int rank_ = 0;
  int count_ = 1;
  int bound_cores_ = 1, core_share_ = 1;
  RankTraffic traffic_;
  std::vector<double> received_;  ///< [node][number of this rank's share of a block]
};

}  // namespace etendue
