// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>

#include "solver/ordinates/lanes.h"
#include "solver/ordinates/sweep_kernel.h"
#include "solver/ordinates/tiny_as_zero.h"

// Part of the kernel files, which are compiled once for each instruction set.
namespace etendue {
namespace {

/// Whether a moment's harmonic has the same value in opposite directions, or the opposite one.
enum class Parity { even, odd };

/// Sums that are kept in registers while their factors run by.
constexpr int moment_block = 4;

/// Rows ahead whose radiance is asked for: one from each direction's array is more than the machine foresees.
constexpr std::size_t radiance_ahead = 4;

/// W numbers: of one row or, where rows are shorter, of two, `step` apart.
template <int Rows, int W>
ETENDUE_KERNEL_INLINE Lanes<W> load_rows(const Real* from, std::size_t step) {
  if constexpr (Rows == 1) {
    return load_lanes<W>(from);
  } else {
    return join(load_lanes<W / 2>(from), load_lanes<W / 2>(from + step));
  }
}

template <int Rows, int W>
ETENDUE_KERNEL_INLINE void store_rows(Real* to, std::size_t step, const Lanes<W>& values) {
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
  ETENDUE_KERNEL_MEMBER MomentRows(const MomentTaskOf<Real>& task, std::size_t row, std::size_t x)
      : task_(task),
        row_step_(static_cast<std::size_t>(task.moments) * task.row_length),
        moments_(task.moment_rows + row * row_step_ + x),
        at_(row * task.row_length + x) {}

  /// Pairs first ... first + Count - 1 from all moments.
  template <int Count>
  ETENDUE_KERNEL_MEMBER void expand(int first) const {
    Lanes<W> even[Count] = {}, odd[Count] = {};
    add_moments<Count>(first, 0, task_.even_moments, even);
    add_moments<Count>(first, task_.even_moments, task_.moments, odd);
    ETENDUE_UNROLL
    for (int p = 0; p < Count; ++p) {
      store_lanes<W>(direction(first + p) + at_, even[p] + odd[p]);
      store_lanes<W>(opposite(first + p) + at_, even[p] - odd[p]);
    }
  }

  /// Moments first ... first + Count - 1 of the order, all of one parity, gain from all directions.
  template <Parity parity, int Count>
  ETENDUE_KERNEL_MEMBER void collect(int first) const {
    Lanes<W> sum[Count];
    ETENDUE_UNROLL
    for (int k = 0; k < Count; ++k) sum[k] = load_rows<Rows, W>(moment(first + k), row_step_);
    for (int p = 0; p < task_.pairs; ++p) {
      const Lanes<W> there = load_lanes<W>(direction(p) + at_);
      const Lanes<W> back = load_lanes<W>(opposite(p) + at_);
      const Lanes<W> radiance = parity == Parity::even ? there + back : there - back;
      ETENDUE_UNROLL
      for (int k = 0; k < Count; ++k) sum[k] += factor(p, first + k) * radiance;
    }
    ETENDUE_UNROLL
    for (int k = 0; k < Count; ++k) store_rows<Rows, W>(moment(first + k), row_step_, sum[k]);
  }

  ETENDUE_KERNEL_MEMBER void fetch_radiance_ahead() const {
    for (int p = 0; p < task_.pairs; ++p) {
      __builtin_prefetch(direction(p) + at_ + radiance_ahead * task_.row_length);
      __builtin_prefetch(opposite(p) + at_ + radiance_ahead * task_.row_length);
    }
  }

 private:
  template <int Count>
  ETENDUE_KERNEL_MEMBER void add_moments(int first, int begin, int end, Lanes<W> (&sum)[Count]) const {
    for (int k = begin; k < end; ++k) {
      const Lanes<W> values = load_rows<Rows, W>(moment(k), row_step_);
      ETENDUE_UNROLL
      for (int p = 0; p < Count; ++p) sum[p] += factor(first + p, k) * values;
    }
  }

  ETENDUE_KERNEL_MEMBER Real* direction(int pair) const { return task_.direction_rows[2 * pair]; }
  ETENDUE_KERNEL_MEMBER Real* opposite(int pair) const { return task_.direction_rows[2 * pair + 1]; }
  ETENDUE_KERNEL_MEMBER Real factor(int pair, int k) const {
    return task_.matrix[static_cast<std::ptrdiff_t>(pair) * task_.moments + k];
  }
  ETENDUE_KERNEL_MEMBER Real* moment(int k) const {
    return moments_ + static_cast<std::size_t>(task_.order[k]) * task_.row_length;
  }

  const MomentTaskOf<Real>& task_;
  std::size_t row_step_;
  Real* moments_;
  std::size_t at_;
};

template <int Rows, int W>
ETENDUE_KERNEL_INLINE void expand_rows(const MomentTaskOf<Real>& task, std::size_t row) {
  for (std::size_t x = 0; x < task.row_length; x += W / Rows) {
    const MomentRows<Rows, W> rows(task, row, x);
    int p = 0;
    for (; p + moment_block <= task.pairs; p += moment_block) rows.template expand<moment_block>(p);
    for (; p < task.pairs; ++p) rows.template expand<1>(p);
  }
}

template <Parity parity, int Rows, int W>
ETENDUE_KERNEL_INLINE void collect_parity(const MomentRows<Rows, W>& rows, int first, int end) {
  for (; first + moment_block <= end; first += moment_block)
    rows.template collect<parity, moment_block>(first);
  if (first + 2 <= end) {
    rows.template collect<parity, 2>(first);
    first += 2;
  }
  if (first < end) rows.template collect<parity, 1>(first);
}

template <int Rows, int W>
ETENDUE_KERNEL_INLINE void collect_rows(const MomentTaskOf<Real>& task, std::size_t row) {
  for (std::size_t x = 0; x < task.row_length; x += W / Rows) {
    const MomentRows<Rows, W> rows(task, row, x);
    rows.fetch_radiance_ahead();
    collect_parity<Parity::even>(rows, 0, task.even_moments);
    collect_parity<Parity::odd>(rows, task.even_moments, task.moments);
  }
}

/// Rows of W numbers or more, or half as long.
template <int Rows, int W>
void moments_to_directions(const MomentTaskOf<Real>& task) {
  [[maybe_unused]] const TinyAsZero<Real> mode;
  std::size_t row = task.first_row;
  for (; row + Rows <= task.last_row; row += Rows) expand_rows<Rows, W>(task, row);
  for (; row < task.last_row; ++row) expand_rows<1, W / Rows>(task, row);
}

template <int Rows, int W>
void directions_to_moments(const MomentTaskOf<Real>& task) {
  [[maybe_unused]] const TinyAsZero<Real> mode;
  std::size_t row = task.first_row;
  for (; row + Rows <= task.last_row; row += Rows) collect_rows<Rows, W>(task, row);
  for (; row < task.last_row; ++row) collect_rows<1, W / Rows>(task, row);
}

template <int Rows, int W>
void set_moment_kernels(SweepKernelsOf<Real>& kernels) {
  kernels.moments_to_directions = moments_to_directions<Rows, W>;
  kernels.directions_to_moments = directions_to_moments<Rows, W>;
}

}  // namespace
}  // namespace etendue
