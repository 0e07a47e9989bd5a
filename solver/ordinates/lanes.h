// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

// For the kernel files, which are compiled once for each instruction set: everything has internal linkage, so
// that the linker cannot hand one file's wide code to another's narrow machine.
#define ETENDUE_KERNEL_INLINE static inline __attribute__((always_inline))

namespace etendue {

/// W numbers that are computed side by side: one for each of W bands. Written out, because GCC drops a vector
/// size that depends on a template argument.
template <int W>
struct LanesOf;
template <>
struct LanesOf<1> {
  using type = double;
};
template <>
struct LanesOf<2> {
  typedef double type __attribute__((vector_size(16)));
};
template <>
struct LanesOf<4> {
  typedef double type __attribute__((vector_size(32)));
};
template <>
struct LanesOf<8> {
  typedef double type __attribute__((vector_size(64)));
};
template <int W>
using Lanes = typename LanesOf<W>::type;
static_assert(sizeof(Lanes<8>) == 8 * sizeof(double));

template <int W>
ETENDUE_KERNEL_INLINE Lanes<W> load_lanes(const double* from) {
  return *reinterpret_cast<const Lanes<W>*>(from);
}

template <int W>
ETENDUE_KERNEL_INLINE void store_lanes(double* to, Lanes<W> value) {
  *reinterpret_cast<Lanes<W>*>(to) = value;
}

}  // namespace etendue
