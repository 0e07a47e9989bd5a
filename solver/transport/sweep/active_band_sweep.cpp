// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/sweep/active_band_sweep.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "solver/problem/band_selection.h"
#include "solver/transport/sweep/transport_sweep.h"

namespace etendue {
namespace {

/// Whether both layouts have the same rows, of `stride_a` and `stride_b` bands. Bands that scatter or mirror
/// less than others may have fewer unknowns.
bool same_rows(const StateLayout& a, std::size_t stride_a, const StateLayout& b, std::size_t stride_b) {
  const auto same = [&](std::size_t StateLayout::*part) { return a.*part / stride_a == b.*part / stride_b; };
  return same(&StateLayout::fluence) && same(&StateLayout::moments) && same(&StateLayout::radiance) &&
         same(&StateLayout::irradiance) && same(&StateLayout::mirrors) && same(&StateLayout::lagged);
}

std::vector<int> list(std::span<const char> active) {
  std::vector<int> bands;
  for (std::size_t b = 0; b < active.size(); ++b)
    if (active[b]) bands.push_back(static_cast<int>(b));
  return bands;
}

}  // namespace

/// Sweep of a subset of the bands, with its states.
template <class Real>
struct ActiveBandSweep<Real>::Subset {
  Subset(const Discretization& wide, std::vector<int> wanted)
      : bands(std::move(wanted)),
        problem(wide.problem.of_bands(bands)),
        extinction(select_bands(wide.extinction, static_cast<std::size_t>(wide.cells.bands()), bands)),
        sweep(wide, problem, extinction, bands),
        last(sweep.layout()),
        next(sweep.layout()) {}

  std::size_t stride() const { return static_cast<std::size_t>(sweep.cells().stride()); }

  std::vector<int> bands;  ///< of the wide sweep
  Problem problem;
  std::vector<double> extinction;
  TransportSweepOf<Real> sweep;
  TransportState last;
  TransportState next;
};

template <class Real>
ActiveBandSweep<Real>::ActiveBandSweep(const Discretization& discretization, int threads)
    : d_(discretization), threads_(threads) {}

template <class Real>
ActiveBandSweep<Real>::~ActiveBandSweep() = default;

template <class Real>
void ActiveBandSweep<Real>::reset() {
  subset_.reset();
}

template <class Real>
int ActiveBandSweep<Real>::lanes() const {
  return subset_ ? subset_->sweep.cells().stride() : d_.cells.stride();
}

template <class Real>
typename ActiveBandSweep<Real>::Subset* ActiveBandSweep<Real>::subset_of(std::span<const char> active) {
  std::vector<int> bands = list(active);
  const int lanes = lane_stride(static_cast<int>(bands.size()));
  if (!is_possible_ || bands.empty() || lanes >= d_.cells.stride()) return nullptr;
  // The current sweep continues where bands leave it without saving lanes.
  if (subset_ && subset_->sweep.cells().stride() <= lanes &&
      std::includes(subset_->bands.begin(), subset_->bands.end(), bands.begin(), bands.end()))
    return subset_.get();
  subset_.reset();
  subset_ = std::make_unique<Subset>(d_, std::move(bands));
  is_possible_ = same_rows(d_.layout(), static_cast<std::size_t>(d_.cells.stride()), subset_->sweep.layout(),
                           subset_->stride());
  if (!is_possible_) subset_.reset();
  return subset_.get();
}

template <class Real>
bool ActiveBandSweep<Real>::apply_linear(const TransportState& last, TransportState& next,
                                         std::span<const char> active, SweepCost& cost) {
  Subset* some = subset_of(active);
  if (some == nullptr) return false;
  const auto stride = static_cast<std::size_t>(d_.cells.stride());
  const std::size_t rows = d_.layout().total() / stride, width = some->stride();
  const std::vector<int>& bands = some->bands;
  const double* from = last.values().data();
  double* packed = some->last.values().data();
#pragma omp parallel for schedule(static) num_threads(threads_)
  for (std::size_t row = 0; row < rows; ++row)
    for (std::size_t i = 0; i < bands.size(); ++i)
      packed[row * width + i] = from[row * stride + static_cast<std::size_t>(bands[i])];
  const double before = some->sweep.processor_seconds();
  some->sweep.apply_linear(some->last, some->next);
  cost.processor_seconds += some->sweep.processor_seconds() - before;
  cost.band_sweeps += static_cast<std::int64_t>(bands.size());
  const double* swept = some->next.values().data();
  double* to = next.values().data();
#pragma omp parallel for schedule(static) num_threads(threads_)
  for (std::size_t row = 0; row < rows; ++row) {
    std::fill_n(to + row * stride, stride, 0.0);
    for (std::size_t i = 0; i < bands.size(); ++i)
      to[row * stride + static_cast<std::size_t>(bands[i])] = swept[row * width + i];
  }
  return true;
}

template class ActiveBandSweep<double>;
template class ActiveBandSweep<float>;

}  // namespace etendue
