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

/// Rows ahead whose radiance is asked for: one from each direction's array is more than the machine foresees.
constexpr std::size_t radiance_ahead = 4;

/// W numbers: of one row or, where rows are shorter, of two, `step` apart.
template <int Rows, int W>
ETENDUE_KERNEL_INLINE Lanes<W> load_rows(const double* from, std::size_t step) {
  if constexpr (Rows == 1) {
    return load_lanes<W>(from);
  } else {
    return join(load_lanes<W / 2>(from), load_lanes<W / 2>(from + step));
  }
}

template <int Rows, int W>
ETENDUE_KERNEL_INLINE void store_rows(double* to, std::size_t step, const Lanes<W>& values) {
  if constexpr (Rows == 1) {
    store_lanes<W>(to, values);
  } else {
    store_lanes<W / 2>(to, low_half(values));
    store_lanes<W / 2>(to + step, high_half(values));
  }
}

/// W numbers of the moments of `Rows` rows, and those of the directions' rows that belong to them.
template <int Rows, int W>
class MomentRows {
 public:
  ETENDUE_KERNEL_MEMBER MomentRows(const MomentTask& task, std::size_t row, std::size_t x)
      : task_(task),
        row_step_(static_cast<std::size_t>(task.moments) * task.row_length),
        moments_(task.moment_rows + row * row_step_ + x),
        at_(row * task.row_length + x) {}

  /// Directions first ... first + Count - 1 from all moments.
  template <int Count>
  ETENDUE_KERNEL_MEMBER void expand(int first) const {
    Lanes<W> sum[Count] = {};
    for (int k = 0; k < task_.moments; ++k) {
      const Lanes<W> values = load_rows<Rows, W>(moment(k), row_step_);
      ETENDUE_UNROLL
      for (int m = 0; m < Count; ++m)
        sum[m] += task_.matrix[static_cast<std::ptrdiff_t>(first + m) * task_.moments + k] * values;
    }
    ETENDUE_UNROLL
    for (int m = 0; m < Count; ++m) store_lanes<W>(task_.direction_rows[first + m] + at_, sum[m]);
  }

  /// Moments first ... first + Count - 1 gain from all directions.
  template <int Count>
  ETENDUE_KERNEL_MEMBER void collect(int first) const {
    Lanes<W> sum[Count];
    ETENDUE_UNROLL
    for (int k = 0; k < Count; ++k) sum[k] = load_rows<Rows, W>(moment(first + k), row_step_);
    for (int m = 0; m < task_.directions; ++m) {
      const Lanes<W> radiance = load_lanes<W>(task_.direction_rows[m] + at_);
      ETENDUE_UNROLL
      for (int k = 0; k < Count; ++k)
        sum[k] += task_.matrix[static_cast<std::ptrdiff_t>(m) * task_.moments + first + k] * radiance;
    }
    ETENDUE_UNROLL
    for (int k = 0; k < Count; ++k) store_rows<Rows, W>(moment(first + k), row_step_, sum[k]);
  }

  ETENDUE_KERNEL_MEMBER void fetch_radiance_ahead() const {
    for (int m = 0; m < task_.directions; ++m)
      __builtin_prefetch(task_.direction_rows[m] + at_ + radiance_ahead * task_.row_length);
  }

 private:
  ETENDUE_KERNEL_MEMBER double* moment(int k) const {
    return moments_ + static_cast<std::size_t>(k) * task_.row_length;
  }

  const MomentTask& task_;
  std::size_t row_step_;
  double* moments_;
  std::size_t at_;
};

template <int Rows, int W>
ETENDUE_KERNEL_INLINE void expand_rows(const MomentTask& task, std::size_t row) {
  for (std::size_t x = 0; x < task.row_length; x += W / Rows) {
    const MomentRows<Rows, W> rows(task, row, x);
    int m = 0;
    for (; m + moment_block <= task.directions; m += moment_block) rows.template expand<moment_block>(m);
    for (; m < task.directions; ++m) rows.template expand<1>(m);
  }
}

template <int Rows, int W>
ETENDUE_KERNEL_INLINE void collect_rows(const MomentTask& task, std::size_t row) {
  for (std::size_t x = 0; x < task.row_length; x += W / Rows) {
    const MomentRows<Rows, W> rows(task, row, x);
    rows.fetch_radiance_ahead();
    int k = 0;
    for (; k + moment_block <= task.moments; k += moment_block) rows.template collect<moment_block>(k);
    for (; k < task.moments; ++k) rows.template collect<1>(k);
  }
}

/// Rows of W numbers or more, or half as long.
template <int Rows, int W>
void moments_to_directions(const MomentTask& task) {
  std::size_t row = task.first_row;
  for (; row + Rows <= task.last_row; row += Rows) expand_rows<Rows, W>(task, row);
  for (; row < task.last_row; ++row) expand_rows<1, W / Rows>(task, row);
}

template <int Rows, int W>
void directions_to_moments(const MomentTask& task) {
  std::size_t row = task.first_row;
  for (; row + Rows <= task.last_row; row += Rows) collect_rows<Rows, W>(task, row);
  for (; row < task.last_row; ++row) collect_rows<1, W / Rows>(task, row);
}

template <int Rows, int W>
void set_moment_kernels(SweepKernels& kernels) {
  kernels.moments_to_directions = moments_to_directions<Rows, W>;
  kernels.directions_to_moments = directions_to_moments<Rows, W>;
}

}  // namespace
}  // namespace etendue
