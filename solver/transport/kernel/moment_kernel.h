// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>

#include "solver/transport/kernel/flush_denormals.h"
#include "solver/transport/kernel/lanes.h"
#include "solver/transport/kernel/sweep_kernel.h"

// Part of the kernel files, which are compiled once for each instruction set.
namespace etendue {
namespace {

/// Numbers of a row that are kept in registers for each direction of some orbits.
#ifdef __AVX512F__
constexpr int held_directions = 16;
#else
constexpr int held_directions = 8;
#endif

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

/// From the values at the directions of an orbit to the sums over it with the signs of each class, or from
/// sums over each class to the values at the directions: Walsh and Hadamard's transformation, by halves. Bit
/// a of a class and of a direction is that of mirror a.
template <int Size, int W>
ETENDUE_KERNEL_INLINE void change_signs(Lanes<W> (&values)[Size]) {
  ETENDUE_UNROLL
  for (int half = 1; half < Size; half *= 2) {
    ETENDUE_UNROLL
    for (int i = 0; i < Size / 2; ++i) {
      const int at = i / half * 2 * half + i % half;
      const Lanes<W> same = values[at], turned = values[at + half];
      values[at] = same + turned;
      values[at + half] = same - turned;
    }
  }
}

/// W numbers of the moments of `Rows` rows, and those of the directions' rows that belong to them. Orbits
/// have `Size` directions.
template <int Size, int Rows, int W>
class MomentRows {
 public:
  ETENDUE_KERNEL_MEMBER MomentRows(const MomentTaskOf<Real>& task, std::size_t row, std::size_t x)
      : task_(task),
        row_step_(static_cast<std::size_t>(task.moments) * task.row_length),
        moments_(task.moment_rows + row * row_step_ + x),
        at_(row * task.row_length + x) {}

  /// Orbits first ... first + Count - 1 from all moments.
  template <int Count>
  ETENDUE_KERNEL_MEMBER void expand(int first) const {
    Lanes<W> values[Count][Size] = {};
    ETENDUE_UNROLL
    for (int c = 0; c < Size; ++c)
      for (int k = task_.class_begin[c]; k < task_.class_begin[c + 1]; ++k) {
        const Lanes<W> moment = load_rows<Rows, W>(this->moment(k), row_step_);
        ETENDUE_UNROLL
        for (int o = 0; o < Count; ++o) values[o][c] += factor(first + o, k) * moment;
      }
    ETENDUE_UNROLL
    for (int o = 0; o < Count; ++o) {
      change_signs<Size, W>(values[o]);
      ETENDUE_UNROLL
      for (int r = 0; r < Size; ++r) store_lanes<W>(direction(first + o, r) + at_, values[o][r]);
    }
  }

  /// All moments gain from orbits first ... first + Count - 1.
  template <int Count>
  ETENDUE_KERNEL_MEMBER void collect(int first) const {
    Lanes<W> values[Count][Size];
    ETENDUE_UNROLL
    for (int o = 0; o < Count; ++o) {
      ETENDUE_UNROLL
      for (int r = 0; r < Size; ++r) values[o][r] = load_lanes<W>(direction(first + o, r) + at_);
      change_signs<Size, W>(values[o]);
    }
    ETENDUE_UNROLL
    for (int c = 0; c < Size; ++c)
      for (int k = task_.class_begin[c]; k < task_.class_begin[c + 1]; ++k) {
        Lanes<W> sum = load_rows<Rows, W>(moment(k), row_step_);
        ETENDUE_UNROLL
        for (int o = 0; o < Count; ++o) sum += factor(first + o, k) * values[o][c];
        store_rows<Rows, W>(moment(k), row_step_, sum);
      }
  }

  ETENDUE_KERNEL_MEMBER void fetch_radiance_ahead() const {
    for (int d = 0; d < task_.orbits * Size; ++d)
      __builtin_prefetch(task_.direction_rows[d] + at_ + radiance_ahead * task_.row_length);
  }

 private:
  ETENDUE_KERNEL_MEMBER Real* direction(int orbit, int r) const {
    return task_.direction_rows[Size * orbit + r];
  }
  ETENDUE_KERNEL_MEMBER Real factor(int orbit, int k) const {
    return task_.matrix[static_cast<std::ptrdiff_t>(k) * task_.orbits + orbit];
  }
  ETENDUE_KERNEL_MEMBER Real* moment(int k) const {
    return moments_ + static_cast<std::size_t>(task_.order[k]) * task_.row_length;
  }

  const MomentTaskOf<Real>& task_;
  std::size_t row_step_;
  Real* moments_;
  std::size_t at_;
};

template <int Size, int Rows, int W>
ETENDUE_KERNEL_INLINE void expand_rows(const MomentTaskOf<Real>& task, std::size_t row) {
  constexpr int block = held_directions / Size;
  for (std::size_t x = 0; x < task.row_length; x += W / Rows) {
    const MomentRows<Size, Rows, W> rows(task, row, x);
    int orbit = 0;
    for (; orbit + block <= task.orbits; orbit += block) rows.template expand<block>(orbit);
    for (; orbit < task.orbits; ++orbit) rows.template expand<1>(orbit);
  }
}

template <int Size, int Rows, int W>
ETENDUE_KERNEL_INLINE void collect_rows(const MomentTaskOf<Real>& task, std::size_t row) {
  constexpr int block = held_directions / Size;
  for (std::size_t x = 0; x < task.row_length; x += W / Rows) {
    const MomentRows<Size, Rows, W> rows(task, row, x);
    rows.fetch_radiance_ahead();
    int orbit = 0;
    for (; orbit + block <= task.orbits; orbit += block) rows.template collect<block>(orbit);
    for (; orbit < task.orbits; ++orbit) rows.template collect<1>(orbit);
  }
}

/// Rows of W numbers or more, or half as long.
template <int Size, int Rows, int W>
void expand_orbits(const MomentTaskOf<Real>& task) {
  std::size_t row = task.first_row;
  for (; row + Rows <= task.last_row; row += Rows) expand_rows<Size, Rows, W>(task, row);
  for (; row < task.last_row; ++row) expand_rows<Size, 1, W / Rows>(task, row);
}

template <int Size, int Rows, int W>
void collect_orbits(const MomentTaskOf<Real>& task) {
  std::size_t row = task.first_row;
  for (; row + Rows <= task.last_row; row += Rows) collect_rows<Size, Rows, W>(task, row);
  for (; row < task.last_row; ++row) collect_rows<Size, 1, W / Rows>(task, row);
}

template <int Rows, int W>
void moments_to_directions(const MomentTaskOf<Real>& task) {
  [[maybe_unused]] const FlushDenormals<Real> mode;
  task.orbit_size == 8 ? expand_orbits<8, Rows, W>(task) : expand_orbits<2, Rows, W>(task);
}

template <int Rows, int W>
void directions_to_moments(const MomentTaskOf<Real>& task) {
  [[maybe_unused]] const FlushDenormals<Real> mode;
  task.orbit_size == 8 ? collect_orbits<8, Rows, W>(task) : collect_orbits<2, Rows, W>(task);
}

template <int Rows, int W>
void set_moment_kernels(SweepKernelsOf<Real>& kernels) {
  kernels.moments_to_directions = moments_to_directions<Rows, W>;
  kernels.directions_to_moments = directions_to_moments<Rows, W>;
}

}  // namespace
}  // namespace etendue
