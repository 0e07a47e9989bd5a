// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/sweep/batch_reduction.h"

#include <algorithm>

#include "base/parallel/processor_timer.h"
#include "base/parallel/rank_group.h"
#include "solver/transport/order/sweep_stopped.h"

namespace etendue {
namespace {

/// Numbers that one thread adds up at a time, and those of them that stay in the first cache meanwhile.
constexpr std::int64_t thread_block = 16384;
constexpr std::size_t cached_block = 512;
/// Rows of moments that one thread adds up at a time.
constexpr std::int64_t reduced_rows = 64;

/// Calls `use(first, end)` for blocks of so many numbers.
template <class Use>
void in_blocks(std::size_t numbers, int threads, double& seconds, const Use& use) {
  const auto size = static_cast<std::int64_t>(numbers);
#pragma omp parallel for schedule(static) num_threads(threads) if (size > thread_block)
  for (std::int64_t first = 0; first < size; first += thread_block) {
    const ProcessorTimer timer(seconds);
    use(static_cast<std::size_t>(first), static_cast<std::size_t>(std::min(size, first + thread_block)));
  }
}

/// sum = from or, where it is begun, sum += from; from = 0
template <class Number>
void move_sum(double* sum, Number* from, std::size_t size, bool is_begun) {
  if (is_begun)
    for (std::size_t i = 0; i < size; ++i) sum[i] += from[i];
  else
    for (std::size_t i = 0; i < size; ++i) sum[i] = from[i];
  std::fill_n(from, size, Number{});
}

}  // namespace

template <class Real>
BatchReduction<Real>::BatchReduction(const Discretization& discretization, MomentOperators<Real>& moments,
                                     WaitingSections& waiting, const SweepPass& pass, int threads,
                                     double& seconds)
    : d_(discretization),
      moments_(moments),
      waiting_(waiting),
      pass_(pass),
      sums_(SummedArrays::of(pass)),
      ranks_(discretization.options.ranks),
      threads_(threads),
      seconds_(seconds),
      sections_(discretization.schedule.batch_count()),
      section_(ranks_ != nullptr ? sections_.first_of(ranks_->rank(), ranks_->count()) : 0),
      end_section_(ranks_ != nullptr ? sections_.first_of(ranks_->rank() + 1, ranks_->count())
                                     : sections_.count()),
      next_batch_(sections_.begin(section_)) {
  for (const std::span<double> part : parts_by_ordinate())
    if (ranks_ != nullptr) std::ranges::fill(part, 0.0);
}

template <class Real>
std::array<std::span<double>, 3> BatchReduction<Real>::parts_by_ordinate() const {
  return {pass_.next.radiance(), pass_.next.mirrors(), pass_.next.lagged()};
}

template <class Real>
SummedArrays BatchReduction<Real>::arrays(std::size_t place, bool with_moments) {
  if (place == 0) return sums_;
  if (waiting_.size() < place) waiting_.resize(place);
  return waiting_[place - 1].arrays(sums_, with_moments);
}

template <class Real>
void BatchReduction<Real>::add(Workspaces workspaces) {
  while (!workspaces.empty()) {
    const std::int32_t end = sections_.end(section_);
    const auto count = std::min(workspaces.size(), static_cast<std::size_t>(end - next_batch_));
    const bool begins = next_batch_ == sections_.begin(section_);
    const bool ends = next_batch_ + static_cast<std::int32_t>(count) == end;
    add_portion({workspaces.first(count), begins, ends});
    if (ends) end_section();
    next_batch_ += static_cast<std::int32_t>(count);
    workspaces = workspaces.subspan(count);
  }
}

template <class Real>
void BatchReduction<Real>::add_portion(const Portion& portion) {
  using Workspace = BatchWorkspace<Real>;
  add_arrays<Real>(portion, &SummedArrays::fluence, [](Workspace& work) { return work.fluence.data(); });
  add_moments(portion);
  add_arrays<double>(portion, &SummedArrays::irradiance,
                     [](Workspace& work) { return work.irradiance.data(); });
  if (pass_.record == nullptr) return;
  add_arrays<Real>(portion, &SummedArrays::net_flux, [](Workspace& work) { return work.net_flux.data(); });
  add_arrays<double>(portion, &SummedArrays::exitance, [](Workspace& work) { return work.exitance.data(); });
  add_arrays<double>(portion, &SummedArrays::meters, [](Workspace& work) { return work.meters.data(); });
  add_arrays<double>(portion, &SummedArrays::source_products,
                     [](Workspace& work) { return work.source_products.data(); });
  add_arrays<double>(portion, &SummedArrays::absorbed, [](Workspace& work) { return work.absorbed.data(); });
}

template <class Real>
template <class Number, class ArrayOf>
void BatchReduction<Real>::add_arrays(const Portion& portion, std::span<double> SummedArrays::*array,
                                      const ArrayOf& array_of) {
  const std::size_t place = stack_.size();
  const std::span<double> section = arrays(place, false).*array;
  const bool to_sibling = portion.ends && completes_pair();
  const std::span<double> sibling = to_sibling ? arrays(place - 1, false).*array : section;
  // A section of one batch needs no place of its own.
  const bool passes = to_sibling && portion.begins && portion.workspaces.size() == 1;
  in_blocks(section.size(), threads_, seconds_, [&](std::size_t begin, std::size_t end) {
    for (std::size_t first = begin; first < end; first += cached_block) {
      const std::size_t count = std::min(cached_block, end - first);
      double* const sum = (passes ? sibling : section).data() + first;
      bool is_begun = passes || !portion.begins;
      for (const auto& work : portion.workspaces) {
        move_sum(sum, array_of(*work) + first, count, is_begun);
        is_begun = true;
      }
      for (std::size_t i = 0; i < count && to_sibling && !passes; ++i) sibling[first + i] += sum[i];
    }
  });
}

template <class Real>
void BatchReduction<Real>::add_moments(const Portion& portion) {
  const auto rows = static_cast<std::int64_t>(d_.moments.row_count());
  if (rows == 0) return;
  const bool to_sibling = completes_pair();
  const std::size_t place = to_sibling ? stack_.size() - 1 : stack_.size();
  const std::span<double> to = portion.ends ? arrays(place, true).moments : std::span<double>();
#pragma omp parallel for schedule(static) num_threads(threads_)
  for (std::int64_t first = 0; first < rows; first += reduced_rows) {
    const ProcessorTimer timer(seconds_);
    const auto begin = static_cast<std::size_t>(first);
    const auto end = static_cast<std::size_t>(std::min(rows, first + reduced_rows));
    for (std::size_t t = 0; t < portion.workspaces.size(); ++t)
      moments_.directions_to_moments(begin, end, next_batch_ + static_cast<std::int32_t>(t),
                                     portion.workspaces[t]->rows);
    if (portion.ends) moments_.move_sums(begin, end, to, to_sibling);
  }
}

template <class Real>
void BatchReduction<Real>::end_section() {
  const bool completes = completes_pair();
  SumNode node{0, 0, section_++};
  if (completes) {
    node = parent_of(stack_.back());
    stack_.pop_back();
  }
  while (!stack_.empty() && are_siblings(stack_.back(), node)) {
    add_to_lower(stack_.size());
    node = parent_of(stack_.back());
    stack_.pop_back();
  }
  stack_.push_back(node);
}

template <class Real>
void BatchReduction<Real>::add_to_lower(std::size_t place) {
  const auto from = arrays(place, true).list(), to = arrays(place - 1, true).list();
  for (std::size_t i = 0; i < from.size(); ++i)
    in_blocks(from[i].size(), threads_, seconds_, [&](std::size_t first, std::size_t end) {
      for (std::size_t at = first; at < end; ++at) to[i][at] += from[i][at];
    });
}

template <class Real>
void BatchReduction<Real>::finish(bool stops) {
  if (any_of(ranks_, stops)) throw SweepStopped{};
  if (ranks_ == nullptr) return;
  const std::vector<SumNode> nodes = sections_.nodes(ranks_->count());
  std::vector<std::span<const double>> own(stack_.size());
  for (std::size_t i = 0; i < sums_.list().size(); ++i) {
    for (std::size_t place = 0; place < own.size(); ++place) own[place] = arrays(place, true).list()[i];
    ranks_->sum_tree(nodes, own, sums_.list()[i]);
  }
  for (const std::span<double> part : parts_by_ordinate()) ranks_->merge(part);
  if (pass_.record == nullptr) return;
  for (OrdinateRadiance& kept : pass_.record->radiance) ranks_->merge(kept.values);
}

template class BatchReduction<double>;
template class BatchReduction<float>;

}  // namespace etendue
