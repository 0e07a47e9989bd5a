// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/ranks/mpi_rank_group.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <thread>

#include "base/parallel/thread_count.h"

namespace etendue {
namespace {

/// Processes on the machine of this one.
int processes_here() {
  MPI_Comm here = MPI_COMM_NULL;
  MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &here);
  int count = 1;
  MPI_Comm_size(here, &count);
  MPI_Comm_free(&here);
  return count;
}

}  // namespace

/// Counts the time and the bytes of an exchange while it lives.
class MpiRankGroup::Timed {
 public:
  Timed(RankTraffic& traffic, std::size_t numbers) : traffic_(traffic), begun_(MPI_Wtime()) {
    traffic_.bytes += static_cast<double>(numbers * sizeof(double));
    ++traffic_.exchanges;
  }
  ~Timed() { traffic_.seconds += MPI_Wtime() - begun_; }
  Timed(const Timed&) = delete;
  Timed& operator=(const Timed&) = delete;

 private:
  RankTraffic& traffic_;
  double begun_;
};

MpiRankGroup::MpiRankGroup() {
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &count_);
  const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  core_share_ = std::max(1, cores / processes_here());
  bound_cores_ = thread_count(0);
}

void MpiRankGroup::exchange_round(std::span<const SumNode> nodes, std::size_t round, const double* own,
                                  std::size_t size) {
  const auto ranks = static_cast<std::size_t>(count_);
  std::vector<int> sent(ranks), sent_from(ranks), received(ranks), received_at(ranks);
  std::vector<std::size_t> seen(ranks, 0);
  const int share = share_of(size, rank_);
  for (std::size_t node = 0; node < nodes.size(); ++node) {
    const auto rank = static_cast<std::size_t>(nodes[node].rank);
    if (seen[rank]++ != round) continue;
    received[rank] = share;
    received_at[rank] = static_cast<int>(node) * share;
  }
  for (int rank = 0; rank < count_ && own != nullptr; ++rank) {
    sent[static_cast<std::size_t>(rank)] = share_of(size, rank);
    sent_from[static_cast<std::size_t>(rank)] = static_cast<int>(begin_of(size, rank));
  }
  const Timed timed(traffic_, own != nullptr ? size - static_cast<std::size_t>(share) : 0);
  MPI_Alltoallv(own, sent.data(), sent_from.data(), MPI_DOUBLE, received_.data(), received.data(),
                received_at.data(), MPI_DOUBLE, MPI_COMM_WORLD);
}

void MpiRankGroup::add_nodes(std::span<const SumNode> nodes, std::size_t share) {
  struct Waiting {
    SumNode node;
    double* values;
  };
  std::vector<Waiting> stack;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    stack.push_back({nodes[i], received_.data() + i * share});
    while (stack.size() > 1 && are_siblings(stack[stack.size() - 2].node, stack.back().node)) {
      const double* const right = stack.back().values;
      stack.pop_back();
      for (std::size_t k = 0; k < share; ++k) stack.back().values[k] += right[k];
      stack.back().node = parent_of(stack.back().node);
    }
  }
}

void MpiRankGroup::sum_tree(std::span<const SumNode> nodes, std::span<const std::span<const double>> own,
                            std::span<double> sum) {
  const auto ranks = static_cast<std::size_t>(count_);
  std::vector<std::size_t> nodes_of(ranks, 0);
  for (const SumNode& node : nodes) ++nodes_of[static_cast<std::size_t>(node.rank)];
  std::vector<int> counts(ranks), at(ranks);
  for_each_block(sum.size(), [&](std::size_t first, std::size_t size) {
    const auto share = static_cast<std::size_t>(share_of(size, rank_));
    received_.resize(share * nodes.size());
    for (std::size_t round = 0; round < std::ranges::max(nodes_of); ++round)
      exchange_round(nodes, round, round < own.size() ? own[round].data() + first : nullptr, size);
    add_nodes(nodes, share);
    std::copy_n(received_.data(), share, sum.data() + first + begin_of(size, rank_));
    for (int rank = 0; rank < count_; ++rank) {
      counts[static_cast<std::size_t>(rank)] = share_of(size, rank);
      at[static_cast<std::size_t>(rank)] = static_cast<int>(begin_of(size, rank));
    }
    const Timed timed(traffic_, share * (ranks - 1));
    MPI_Allgatherv(MPI_IN_PLACE, 0, MPI_DOUBLE, sum.data() + first, counts.data(), at.data(), MPI_DOUBLE,
                   MPI_COMM_WORLD);
  });
}

// Zero has no bits: the union of all bits is the entry that one rank has, minus zero and NaN too.
void MpiRankGroup::merge(std::span<double> values) {
  static_assert(sizeof(double) == sizeof(std::uint64_t));
  for_each_block(values.size(), [&](std::size_t first, std::size_t size) {
    const Timed timed(traffic_, size);
    MPI_Allreduce(MPI_IN_PLACE, values.data() + first, static_cast<int>(size), MPI_UINT64_T, MPI_BOR,
                  MPI_COMM_WORLD);
  });
}

bool MpiRankGroup::any(bool value) {
  const Timed timed(traffic_, 1);
  int is = value ? 1 : 0;
  MPI_Allreduce(MPI_IN_PLACE, &is, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
  return is != 0;
}

bool MpiRankGroup::meet(bool value) {
  const Timed timed(traffic_, 1);
  int is = value ? 1 : 0, here = 0;
  MPI_Request request = MPI_REQUEST_NULL;
  MPI_Iallreduce(MPI_IN_PLACE, &is, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD, &request);
  for (MPI_Test(&request, &here, MPI_STATUS_IGNORE); here == 0; MPI_Test(&request, &here, MPI_STATUS_IGNORE))
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  return is != 0;
}

void MpiRankGroup::bring(std::span<double> values, int from) {
  for_each_block(values.size(), [&](std::size_t first, std::size_t size) {
    const Timed timed(traffic_, rank_ == from ? size : 0);
    MPI_Bcast(values.data() + first, static_cast<int>(size), MPI_DOUBLE, from, MPI_COMM_WORLD);
  });
}

}  // namespace etendue
