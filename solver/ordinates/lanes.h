// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstring>

#include "solver/ordinates/kernel_inline.h"

namespace etendue {

/// W numbers that are computed side by side, and W integers that choose among them. Written out, because GCC
/// drops a vector size that depends on a template argument.
template <int W>
struct LanesOf;
template <>
struct LanesOf<1> {
  using type = double;
};
template <>
struct LanesOf<2> {
  typedef double type __attribute__((vector_size(16)));
  typedef long long choice __attribute__((vector_size(16)));
};
template <>
struct LanesOf<4> {
  typedef double type __attribute__((vector_size(32)));
  typedef long long choice __attribute__((vector_size(32)));
};
template <>
struct LanesOf<8> {
  typedef double type __attribute__((vector_size(64)));
  typedef long long choice __attribute__((vector_size(64)));
};
template <int W>
using Lanes = typename LanesOf<W>::type;
template <int W>
using LaneChoice = typename LanesOf<W>::choice;
static_assert(sizeof(Lanes<8>) == 8 * sizeof(double));

/// From any address, aligned or not.
template <int W>
ETENDUE_KERNEL_INLINE Lanes<W> load_lanes(const double* from) {
  Lanes<W> value;
  std::memcpy(&value, from, sizeof value);
  return value;
}

template <int W>
ETENDUE_KERNEL_INLINE void store_lanes(double* to, const Lanes<W>& value) {
  std::memcpy(to, &value, sizeof value);
}

ETENDUE_KERNEL_INLINE Lanes<2> join(double a, double b) { return Lanes<2>{a, b}; }
ETENDUE_KERNEL_INLINE Lanes<4> join(const Lanes<2>& a, const Lanes<2>& b) {
  return __builtin_shufflevector(a, b, 0, 1, 2, 3);
}
ETENDUE_KERNEL_INLINE Lanes<8> join(const Lanes<4>& a, const Lanes<4>& b) {
  return __builtin_shufflevector(a, b, 0, 1, 2, 3, 4, 5, 6, 7);
}

ETENDUE_KERNEL_INLINE double low_half(const Lanes<2>& a) { return a[0]; }
ETENDUE_KERNEL_INLINE double high_half(const Lanes<2>& a) { return a[1]; }
ETENDUE_KERNEL_INLINE Lanes<2> low_half(const Lanes<4>& a) { return __builtin_shufflevector(a, a, 0, 1); }
ETENDUE_KERNEL_INLINE Lanes<2> high_half(const Lanes<4>& a) { return __builtin_shufflevector(a, a, 2, 3); }
ETENDUE_KERNEL_INLINE Lanes<4> low_half(const Lanes<8>& a) {
  return __builtin_shufflevector(a, a, 0, 1, 2, 3);
}
ETENDUE_KERNEL_INLINE Lanes<4> high_half(const Lanes<8>& a) {
  return __builtin_shufflevector(a, a, 4, 5, 6, 7);
}

}  // namespace etendue
