// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/sweep/transport_sweep.h"

#include <algorithm>
#include <stdexcept>

#include "base/parallel/processor_timer.h"
#include "solver/solution/angular_input.h"
#include "solver/solution/saved_state.h"
#include "solver/transport/sweep/batch_reduction.h"

namespace etendue {
namespace {

/// Cells whose source one thread forms at a time.
constexpr std::int32_t source_block = 1024;

/// Adds fluence, moments and irradiance of a state that is prescribed.
void add_prescribed(const SavedState& from, int bands, TransportState& state) {
  const auto count = static_cast<std::size_t>(bands);
  const auto stride = static_cast<std::size_t>(lane_stride(bands));
  const auto add = [&](const std::vector<double>& values, std::span<double> to) {
    if (values.size() / count != to.size() / stride)
      throw std::logic_error("the prescribed state has other moments");
    for (std::size_t row = 0; row * count < values.size(); ++row)
      for (std::size_t b = 0; b < count; ++b) to[row * stride + b] += values[row * count + b];
  };
  add(from.fluence, state.fluence());
  add(from.moments, state.moments());
  add(from.irradiance, state.irradiance());
}

}  // namespace

template <class Real>
template <class... Arguments>
TransportSweepOf<Real>::TransportSweepOf(std::in_place_t, const Arguments&... arguments)
    : discretization_(arguments..., scalar_of<Real>),
      threads_(discretization_.sweep_threads()),
      kernels_(choose_kernels<Real>(cells().basis(), cells().stride())),
      records_(cells().template make_records<Real>()),
      moments_(discretization_.moments, discretization_.schedule, kernels_),
      walls_(discretization_.walls),
      stop_(discretization_.options.stops),
      march_(discretization_, kernels_, records_, moments_, walls_, stop_),
      active_bands_(discretization_, threads_) {
  for (int t = 0; t < threads_; ++t)
    workspaces_.push_back(std::make_unique<BatchWorkspace<Real>>(discretization_, moments_.batch_length()));
}

template <class Real>
TransportSweepOf<Real>::TransportSweepOf(const Problem& problem, const DirectionSet& directions,
                                         std::span<const double> extinction, const SolveOptions& options,
                                         std::shared_ptr<const SweepOrders> known_orders)
    : TransportSweepOf(std::in_place, problem, directions, extinction, options, known_orders) {}

template <class Real>
template <class Other>
TransportSweepOf<Real>::TransportSweepOf(const TransportSweepOf<Other>& other)
    : TransportSweepOf(std::in_place, other.discretization()) {}

template <class Real>
TransportSweepOf<Real>::TransportSweepOf(const Discretization& wide, const Problem& problem,
                                         std::span<const double> extinction, std::span<const int> bands)
    : TransportSweepOf(std::in_place, wide, problem, extinction, bands) {}

template <class Real>
TransportSweepOf<Real>::TransportSweepOf(const Discretization& fine, const DirectionSet& directions)
    : TransportSweepOf(std::in_place, fine, directions) {}

template <class Real>
void TransportSweepOf<Real>::apply(const TransportState& last, TransportState& next, SweepRecord* record) {
  sweep_state({last, next, record, Emission::included});
  const AngularInput* input = discretization_.options.angular_input;
  if (input != nullptr && input->prescribed_state() != nullptr)
    add_prescribed(*input->prescribed_state(), cells().bands(), next);
}

template <class Real>
void TransportSweepOf<Real>::apply_linear(const TransportState& last, TransportState& next) {
  sweep_state({last, next, nullptr, Emission::left_out});
}

template <class Real>
void TransportSweepOf<Real>::apply_linear(const TransportState& last, TransportState& next,
                                          std::span<const char> active) {
  if (active_bands_.apply_linear(last, next, active, cost_)) return;
  active_bands_.reset();
  apply_linear(last, next);
}

template <class Real>
void TransportSweepOf<Real>::apply_to_unit_source(TransportState& next) {
  form_unit_source();
  sweep({TransportState(layout()), next, nullptr, Emission::left_out});
}

template <class Real>
void TransportSweepOf<Real>::sweep_state(const SweepPass& pass) {
  form_source(pass);
  march_.clear_census();
  sweep(pass, discretization_.options.keep_ordinates);
  if (RankGroup* ranks = discretization_.options.ranks) march_.merge_census(*ranks);
}

template <class Real>
std::vector<OrdinateRadiance> TransportSweepOf<Real>::radiance_along(const TransportState& last,
                                                                     std::span<const int> ordinates) {
  std::vector<char> only(static_cast<std::size_t>(directions().count()), 0);
  for (const int ordinate : ordinates) only[static_cast<std::size_t>(ordinate)] = 1;
  TransportState unused(layout());
  SweepRecord record;
  const SweepPass pass{last, unused, &record, Emission::included, only};
  form_source(pass);
  sweep(pass, ordinates);
  return std::move(record.radiance);
}

// Equations (11) and (13), multiplied by the mass of each cell as in (5).
template <class Real>
void TransportSweepOf<Real>::form_source(const SweepPass& pass) {
  const Discretization& d = discretization_;
  const DirectionalInput input(d);
  walls_.form_inflow(pass.last, pass.emission, threads_);
  const std::int32_t cells = mesh().cell_count();
#pragma omp parallel for schedule(static) num_threads(threads_)
  for (std::int32_t first = 0; first < cells; first += source_block) {
    const ProcessorTimer timer(cost_.processor_seconds);
    const std::int32_t end = std::min(cells, first + source_block);
    d.moments.form_source(pass.last, pass.emission, first, end, records_.data(), moments_.source());
    if (input.acts(pass.emission)) input.add_isotropic_source(first, end, records_.data());
  }
  discretization_.dense.form_source(pass.last, kernels_.matrix_product, threads_, cost_.processor_seconds);
  share_records();
}

template <class Real>
void TransportSweepOf<Real>::form_unit_source() {
  walls_.clear_inflow();
  discretization_.moments.form_unit_source(records_.data(), moments_.source());
  discretization_.dense.clear_source();
  share_records();
}

template <class Real>
void TransportSweepOf<Real>::share_records() {
  for (auto& work : workspaces_) std::copy_n(records_.data(), work->records.size(), work->records.data());
}

template <class Real>
void TransportSweepOf<Real>::sweep(const SweepPass& pass, std::span<const int> ordinates) {
  if (pass.record != nullptr) {
    march_.begin_record(*pass.record, ordinates);
    for (auto& work : workspaces_) work->begin_record(discretization_, *pass.record);
  }
  for (auto& work : workspaces_)
    for (auto& member : work->members) member.is_filled = false;
  march_batches(pass);
  if (pass.record != nullptr) {
    for (SectionSums& sums : *discretization_.waiting) sums.end_record();
    for (auto& work : workspaces_) work->end_record();
  }
  cost_.band_sweeps += cells().bands();
}

template <class Real>
void TransportSweepOf<Real>::march_batches(const SweepPass& pass) {
  BatchReduction<Real> reduction(discretization_, moments_, *discretization_.waiting, pass, threads_,
                                 cost_.processor_seconds);
  const std::int32_t begin = reduction.first_batch(), end = reduction.end_batch();
  for (std::int32_t first = begin; first < end && !stop_.is_set(); first += threads_) {
    const int batches = std::min(threads_, end - first);
#pragma omp parallel for schedule(static, 1) num_threads(batches)
    for (int t = 0; t < batches; ++t) {
      const ProcessorTimer timer(cost_.processor_seconds);
      march_.march(first + t, pass, *workspaces_[static_cast<std::size_t>(t)]);
    }
    if (stop_.is_set()) break;
    reduction.add(std::span(workspaces_).first(static_cast<std::size_t>(batches)));
    if (const auto& told = discretization_.options.sweep_share)
      told(static_cast<double>(first + batches - begin) / (end - begin));
  }
  reduction.finish(stop_.is_set());
}

template class TransportSweepOf<double>;
template class TransportSweepOf<float>;
template TransportSweepOf<float>::TransportSweepOf(const TransportSweepOf<double>&);

}  // namespace etendue
