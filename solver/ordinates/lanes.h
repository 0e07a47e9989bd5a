// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

// For the kernel files, which are compiled once for each instruction set: everything has internal linkage, so
// that the linker cannot hand one file's wide code to another's narrow machine.
#define ETENDUE_KERNEL_INLINE static inline __attribute__((always_inline))

namespace etendue {

/// W numbers that are computed side by side: one for each of W bands.
template <int W>
struct LanesOf {
  using type = double __attribute__((vector_size(sizeof(double) * W)));
};
template <>
struct LanesOf<1> {
  using type = double;
};
template <int W>
using Lanes = typename LanesOf<W>::type;

template <int W>
ETENDUE_KERNEL_INLINE Lanes<W> load_lanes(const double* from) {
  return *reinterpret_cast<const Lanes<W>*>(from);
}

template <int W>
ETENDUE_KERNEL_INLINE void store_lanes(double* to, Lanes<W> value) {
  *reinterpret_cast<Lanes<W>*>(to) = value;
}

}  // namespace etendue
