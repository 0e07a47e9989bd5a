// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstring>
#include <type_traits>

#include "solver/transport/kernel/kernel_inline.h"

// For the kernel files only, each of which is compiled for one kind of numbers.
namespace etendue {
namespace {

/// double or float
using Real = ETENDUE_KERNEL_REAL;
/// An integer of the same size.
using RealChoice = std::conditional_t<sizeof(Real) == sizeof(long long), long long, int>;

/// W numbers that are computed side by side, and W integers that choose among them. Written out, because GCC
/// drops a vector size that depends on a template argument.
template <int W>
struct LanesOf;
template <>
struct LanesOf<1> {
  using type = Real;
};
template <>
struct LanesOf<2> {
  typedef Real type __attribute__((vector_size(2 * sizeof(Real))));
  typedef RealChoice choice __attribute__((vector_size(2 * sizeof(Real))));
};
template <>
struct LanesOf<4> {
  typedef Real type __attribute__((vector_size(4 * sizeof(Real))));
  typedef RealChoice choice __attribute__((vector_size(4 * sizeof(Real))));
};
template <>
struct LanesOf<8> {
  typedef Real type __attribute__((vector_size(8 * sizeof(Real))));
  typedef RealChoice choice __attribute__((vector_size(8 * sizeof(Real))));
};
template <>
struct LanesOf<16> {
  typedef Real type __attribute__((vector_size(16 * sizeof(Real))));
  typedef RealChoice choice __attribute__((vector_size(16 * sizeof(Real))));
};
template <int W>
using Lanes = typename LanesOf<W>::type;
template <int W>
using LaneChoice = typename LanesOf<W>::choice;
static_assert(sizeof(Lanes<8>) == 8 * sizeof(Real));

/// From any address, aligned or not.
template <int W>
ETENDUE_KERNEL_INLINE Lanes<W> load_lanes(const Real* from) {
  Lanes<W> value;
  std::memcpy(&value, from, sizeof value);
  return value;
}

template <int W>
ETENDUE_KERNEL_INLINE void store_lanes(Real* to, const Lanes<W>& value) {
  std::memcpy(to, &value, sizeof value);
}

/// In each lane the value of the lane that is named there.
template <int W>
ETENDUE_KERNEL_INLINE Lanes<W> chosen(const Lanes<W>& values, const LaneChoice<W>& lanes) {
#if defined(__clang__)  // has only constant choices
  Lanes<W> result;
  for (int lane = 0; lane < W; ++lane) result[lane] = values[lanes[lane]];
  return result;
#else
  return __builtin_shuffle(values, lanes);
#endif
}

ETENDUE_KERNEL_INLINE Lanes<2> join(Real a, Real b) { return Lanes<2>{a, b}; }
ETENDUE_KERNEL_INLINE Lanes<4> join(const Lanes<2>& a, const Lanes<2>& b) {
  return __builtin_shufflevector(a, b, 0, 1, 2, 3);
}
ETENDUE_KERNEL_INLINE Lanes<8> join(const Lanes<4>& a, const Lanes<4>& b) {
  return __builtin_shufflevector(a, b, 0, 1, 2, 3, 4, 5, 6, 7);
}
ETENDUE_KERNEL_INLINE Lanes<16> join(const Lanes<8>& a, const Lanes<8>& b) {
  return __builtin_shufflevector(a, b, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
}

ETENDUE_KERNEL_INLINE Real low_half(const Lanes<2>& a) { return a[0]; }
ETENDUE_KERNEL_INLINE Real high_half(const Lanes<2>& a) { return a[1]; }
ETENDUE_KERNEL_INLINE Lanes<2> low_half(const Lanes<4>& a) { return __builtin_shufflevector(a, a, 0, 1); }
ETENDUE_KERNEL_INLINE Lanes<2> high_half(const Lanes<4>& a) { return __builtin_shufflevector(a, a, 2, 3); }
ETENDUE_KERNEL_INLINE Lanes<4> low_half(const Lanes<8>& a) {
  return __builtin_shufflevector(a, a, 0, 1, 2, 3);
}
ETENDUE_KERNEL_INLINE Lanes<4> high_half(const Lanes<8>& a) {
  return __builtin_shufflevector(a, a, 4, 5, 6, 7);
}
ETENDUE_KERNEL_INLINE Lanes<8> low_half(const Lanes<16>& a) {
  return __builtin_shufflevector(a, a, 0, 1, 2, 3, 4, 5, 6, 7);
}
ETENDUE_KERNEL_INLINE Lanes<8> high_half(const Lanes<16>& a) {
  return __builtin_shufflevector(a, a, 8, 9, 10, 11, 12, 13, 14, 15);
}

}  // namespace
}  // namespace etendue
