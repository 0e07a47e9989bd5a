// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

// Sweeps of the active bands: those that are still iterated.
// Part of TransportSweep, for its source file alone.
#include <algorithm>
#include <utility>

#include "solver/transport/sweep/active_band_sweep.h"

namespace etendue {

namespace {

/// Whether both are lists of the same rows, of so many bands each: bands that scatter or mirror less than
/// others may have less to hand on.
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

template <class Real>
int TransportSweepOf<Real>::lanes() const {
  return active_band_sweep_ ? active_band_sweep_->sweep.cells_.stride() : cells_.stride();
}

template <class Real>
typename TransportSweepOf<Real>::ActiveBandSweep* TransportSweepOf<Real>::active_band_sweep(
    std::span<const char> active) {
  std::vector<int> bands = list(active);
  const int lanes = lane_stride(static_cast<int>(bands.size()));
  if (!can_sweep_active_bands_ || bands.empty() || lanes >= cells_.stride()) return nullptr;
  // The current sweep continues where bands leave it without saving lanes.
  if (active_band_sweep_ && active_band_sweep_->sweep.cells_.stride() <= lanes &&
      std::includes(active_band_sweep_->bands.begin(), active_band_sweep_->bands.end(), bands.begin(),
                    bands.end()))
    return active_band_sweep_.get();
  active_band_sweep_.reset();
  active_band_sweep_ = std::make_unique<ActiveBandSweep>(*this, std::move(bands));
  can_sweep_active_bands_ = same_rows(layout(), static_cast<std::size_t>(cells_.stride()),
                                      active_band_sweep_->sweep.layout(), active_band_sweep_->stride());
  if (!can_sweep_active_bands_) active_band_sweep_.reset();
  return active_band_sweep_.get();
}

template <class Real>
void TransportSweepOf<Real>::apply_linear(const TransportState& last, TransportState& next,
                                          std::span<const char> active) {
  ActiveBandSweep* some = active_band_sweep(active);
  if (some == nullptr) {
    active_band_sweep_.reset();
    apply_linear(last, next);
    return;
  }
  const auto stride = static_cast<std::size_t>(cells_.stride());
  const std::size_t rows = layout().total() / stride, width = some->stride();
  const std::vector<int>& bands = some->bands;
  const double* from = last.values().data();
  double* packed = some->last.values().data();
#pragma omp parallel for schedule(static) num_threads(threads_)
  for (std::size_t row = 0; row < rows; ++row)
    for (std::size_t i = 0; i < bands.size(); ++i)
      packed[row * width + i] = from[row * stride + static_cast<std::size_t>(bands[i])];
  const double before = some->sweep.processor_seconds_;
  some->sweep.apply_linear(some->last, some->next);
  processor_seconds_ += some->sweep.processor_seconds_ - before;
  band_sweep_count_ += static_cast<std::int64_t>(bands.size());
  const double* swept = some->next.values().data();
  double* to = next.values().data();
#pragma omp parallel for schedule(static) num_threads(threads_)
  for (std::size_t row = 0; row < rows; ++row) {
    std::fill_n(to + row * stride, stride, 0.0);
    for (std::size_t i = 0; i < bands.size(); ++i)
      to[row * stride + static_cast<std::size_t>(bands[i])] = swept[row * width + i];
  }
}

}  // namespace etendue
