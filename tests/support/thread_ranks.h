// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <barrier>
#include <bit>
#include <functional>
#include <memory>
#include <thread>
#include <vector>

#include "base/parallel/rank_group.h"

namespace etendue::test {

/// Ranks that are threads of this process: each brings its array, and takes what it needs from all.
class ThreadRanks {
 public:
  explicit ThreadRanks(int count) : barrier_(count), arrays_(static_cast<std::size_t>(count)) {
    for (int rank = 0; rank < count; ++rank) members_.push_back(std::make_unique<Member>(*this, rank));
  }

  /// Calls it for each rank in a thread of its own.
  void run(const std::function<void(RankGroup&)>& program) {
    std::vector<std::jthread> threads;
    for (const auto& member : members_) threads.emplace_back([&] { program(*member); });
  }

 private:
  struct Member : RankGroup {
    Member(ThreadRanks& all, int rank) : group(all), number(rank) {}

    int rank() const override { return number; }
    int count() const override { return static_cast<int>(group.members_.size()); }
    int threads() const override { return 1; }
    RankTraffic traffic() const override { return {}; }
    void sum_tree(std::span<const SumNode> nodes, std::span<const std::span<const double>> own,
                  std::span<double> sum) override {
      std::vector<double> all;
      for (const auto& array : own) all.insert(all.end(), array.begin(), array.end());
      std::vector<std::size_t> seen(group.arrays_.size(), 0), first;
      for (const SumNode& node : nodes)
        first.push_back(seen[static_cast<std::size_t>(node.rank)]++ * sum.size());
      group.exchange(number, all, sum.size(), [&](std::size_t i) {
        std::array<std::pair<SumNode, double>, 16> stack;
        std::size_t size = 0;
        for (std::size_t n = 0; n < nodes.size(); ++n) {
          stack[size++] = {nodes[n], group.arrays_[static_cast<std::size_t>(nodes[n].rank)][first[n] + i]};
          for (; size > 1 && are_siblings(stack[size - 2].first, stack[size - 1].first); --size)
            stack[size - 2] = {parent_of(stack[size - 2].first),
                               stack[size - 2].second + stack[size - 1].second};
        }
        ASSERT_EQ(size, 1u);
        sum[i] = stack[0].second;
      });
    }
    void merge(std::span<double> values) override {
      const std::vector<double> mine(values.begin(), values.end());
      group.exchange(number, mine, values.size(), [&](std::size_t i) {
        std::uint64_t bits = 0;
        for (const auto& array : group.arrays_) bits |= std::bit_cast<std::uint64_t>(array[i]);
        values[i] = std::bit_cast<double>(bits);
      });
    }
    bool any(bool value) override {
      const std::vector<double> mine{value ? 1.0 : 0.0};
      bool is = false;
      group.exchange(number, mine, group.arrays_.size(),
                     [&](std::size_t rank) { is = is || group.arrays_[rank][0] != 0; });
      return is;
    }
    bool meet(bool value) override { return any(value); }
    void bring(std::span<double> values, int from) override {
      const std::vector<double> mine(values.begin(), values.end());
      group.exchange(number, mine, values.size(),
                     [&](std::size_t i) { values[i] = group.arrays_[static_cast<std::size_t>(from)][i]; });
    }

    ThreadRanks& group;
    int number;
  };

  /// Shows its array to the others and calls `use(0)` ... `use(size - 1)` once it sees theirs.
  template <class Use>
  void exchange(int rank, std::span<const double> array, std::size_t size, const Use& use) {
    arrays_[static_cast<std::size_t>(rank)] = array;
    barrier_.arrive_and_wait();
    for (std::size_t i = 0; i < size; ++i) use(i);
    barrier_.arrive_and_wait();
  }

  std::barrier<> barrier_;
  std::vector<std::span<const double>> arrays_;  ///< [rank]
  std::vector<std::unique_ptr<Member>> members_;
};

}  // namespace etendue::test
