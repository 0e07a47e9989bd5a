// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/order/sweep_orders.h"

#include <algorithm>
#include <atomic>

#include "solver/transport/order/sweep_stopped.h"

namespace etendue {

SweepOrders::SweepOrders(const TetrahedralMesh& mesh, const DirectionSet& directions,
                         std::size_t cells_per_tile, LevelOrder levels, std::size_t bytes, int threads,
                         const std::function<bool()>& stops, const std::function<void(double)>& share,
                         const OwnPairs& own)
    : graph_(mesh),
      tiles_(mesh, cells_per_tile),
      directions_(directions),
      levels_(levels),
      orders_(static_cast<std::size_t>(directions.count() / 2)) {
  const auto pairs = static_cast<std::int32_t>(orders_.size());
  // All orders of a mesh are about as large: which are kept is decided beforehand, by their number.
  const std::size_t one = static_cast<std::size_t>(mesh.cell_count()) * sizeof(SweepVisit);
  kept_count_ = static_cast<int>(std::min(orders_.size(), bytes / std::max<std::size_t>(one, 1)));
  place_.assign(orders_.size(), not_kept);
  std::int32_t places = 0;
  for (std::size_t p = 0; p < orders_.size() && places < kept_count_; ++p)
    if (own.are_own.empty() || own.are_own[p] != 0) place_[p] = places++;
  visits_.reset(static_cast<SweepVisit*>(::operator new(static_cast<std::size_t>(places) * one)));
  std::vector<double> lagged(orders_.size(), 0), slots(orders_.size(), 0);
  const auto is_own = [&](std::size_t p) { return own.are_own.empty() || own.are_own[p] != 0; };
  const auto own_pairs =
      own.are_own.empty() ? static_cast<std::ptrdiff_t>(pairs) : std::ranges::count(own.are_own, 1);
  std::atomic<bool> stopped = false;
  std::int32_t made = 0;
#pragma omp parallel num_threads(threads)
  {
    SweepOrderMaker maker(graph_, tiles_, levels_);
    std::vector<SweepVisit> scratch;
#pragma omp for schedule(dynamic, 1)
    for (std::int32_t pair = 0; pair < pairs; ++pair) {
      if (!stopped && stops && stops()) stopped = true;
      const auto p = static_cast<std::size_t>(pair);
      if (stopped || !is_own(p)) continue;
      const bool is_kept = place_[p] != not_kept;
      if (!is_kept) scratch.resize(graph_.cell_count());
      SweepOrder order = maker.make(direction(pair), is_kept ? kept_visits(pair) : std::span(scratch));
      lagged[p] = static_cast<double>(order.lagged.size());
      slots[p] = order.slot_count;
      if (is_kept) orders_[p] = std::move(order);
      if (!share) continue;
#pragma omp critical(share_of_sweep_orders)
      share(static_cast<double>(++made) / static_cast<double>(own_pairs));
    }
  }
  if (any_of(own.ranks, stopped)) throw SweepStopped{};
  count_up(lagged, slots, own.ranks);
}

void SweepOrders::count_up(std::vector<double>& lagged, std::vector<double>& slots, RankGroup* ranks) {
  for (std::vector<double>* of_own : {&lagged, &slots})
    if (ranks != nullptr) ranks->merge(*of_own);
  lagged_start_.push_back(0);
  for (const double count : lagged)
    lagged_start_.push_back(lagged_start_.back() + static_cast<std::size_t>(count));
  largest_slot_count_ = static_cast<std::uint32_t>(*std::ranges::max_element(slots));
}

const SweepOrder& SweepOrders::of_pair(std::int32_t pair, std::unique_ptr<SweepOrderMaker>& maker,
                                       OwnedOrder& remade) const {
  const auto& kept = orders_[static_cast<std::size_t>(pair)];
  if (kept) return *kept;
  if (!maker) maker = std::make_unique<SweepOrderMaker>(graph_, tiles_, levels_);
  remade.visits.resize(graph_.cell_count());
  remade.order = maker->make(direction(pair), remade.visits);
  return remade.order;
}

std::span<SweepVisit> SweepOrders::kept_visits(std::int32_t pair) const {
  const std::size_t cells = graph_.cell_count();
  return {visits_.get() + static_cast<std::size_t>(place_[static_cast<std::size_t>(pair)]) * cells, cells};
}

const Vec3& SweepOrders::direction(std::int32_t pair) const {
  return directions_.direction(OrdinateIndex(std::int64_t{2} * pair));
}

}  // namespace etendue
