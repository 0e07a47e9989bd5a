// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>

#include "solver/ordinates/lanes.h"
#include "solver/ordinates/sweep_kernel.h"

// Part of the kernel files, which are compiled once for each instruction set.
namespace etendue {
namespace {

/// Sums that are kept in registers while their factors run by.
constexpr int moment_block = 4;

/// Directions first … first + Count - 1 of one row, W numbers of it, from all its moments.
template <int W, int Count>
ETENDUE_KERNEL_INLINE void expand_block(const MomentTask& task, const double* moments, std::size_t at,
                                        int first) {
  Lanes<W> sum[Count] = {};
  for (int k = 0; k < task.moments; ++k) {
    const Lanes<W> moment = load_lanes<W>(moments + static_cast<std::size_t>(k) * task.row_length);
    for (int m = 0; m < Count; ++m)
      sum[m] += task.matrix[static_cast<std::ptrdiff_t>(first + m) * task.moments + k] * moment;
  }
  for (int m = 0; m < Count; ++m) store_lanes<W>(task.direction_rows[first + m] + at, sum[m]);
}

/// Moments first … first + Count - 1 of one row, W numbers of it, gain from all directions.
template <int W, int Count>
ETENDUE_KERNEL_INLINE void collect_block(const MomentTask& task, double* moments, std::size_t at, int first) {
  Lanes<W> sum[Count];
  for (int k = 0; k < Count; ++k)
    sum[k] = load_lanes<W>(moments + static_cast<std::size_t>(first + k) * task.row_length);
  for (int m = 0; m < task.directions; ++m) {
    const Lanes<W> radiance = load_lanes<W>(task.direction_rows[m] + at);
    for (int k = 0; k < Count; ++k)
      sum[k] += task.matrix[static_cast<std::ptrdiff_t>(m) * task.moments + first + k] * radiance;
  }
  for (int k = 0; k < Count; ++k)
    store_lanes<W>(moments + static_cast<std::size_t>(first + k) * task.row_length, sum[k]);
}

template <int W>
void moments_to_directions(const MomentTask& task) {
  for (std::size_t row = task.first_row; row < task.last_row; ++row)
    for (std::size_t x = 0; x < task.row_length; x += W) {
      const double* moments =
          task.moment_rows + row * static_cast<std::size_t>(task.moments) * task.row_length + x;
      const std::size_t at = row * task.row_length + x;
      int m = 0;
      for (; m + moment_block <= task.directions; m += moment_block)
        expand_block<W, moment_block>(task, moments, at, m);
      for (; m < task.directions; ++m) expand_block<W, 1>(task, moments, at, m);
    }
}

template <int W>
void directions_to_moments(const MomentTask& task) {
  for (std::size_t row = task.first_row; row < task.last_row; ++row)
    for (std::size_t x = 0; x < task.row_length; x += W) {
      double* moments = task.moment_rows + row * static_cast<std::size_t>(task.moments) * task.row_length + x;
      const std::size_t at = row * task.row_length + x;
      int k = 0;
      for (; k + moment_block <= task.moments; k += moment_block)
        collect_block<W, moment_block>(task, moments, at, k);
      for (; k < task.moments; ++k) collect_block<W, 1>(task, moments, at, k);
    }
}

template <int W>
void set_moment_kernels(SweepKernels& kernels) {
  kernels.moments_to_directions = moments_to_directions<W>;
  kernels.directions_to_moments = directions_to_moments<W>;
}

}  // namespace
}  // namespace etendue
