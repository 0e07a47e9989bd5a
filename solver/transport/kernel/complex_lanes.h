// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <type_traits>

#include "solver/transport/kernel/packet.h"

// For the kernel files only.
namespace etendue {
namespace {

/// Kind of the numbers of a sweep. Of complex ones two neighbouring bands are the real and the imaginary
/// part.
enum class Numbers { real, complex };

/// W complex numbers side by side.
template <int W>
struct ComplexLanes {
  Lanes<W> real;
  Lanes<W> imaginary;

  ETENDUE_KERNEL_MEMBER ComplexLanes& operator+=(const ComplexLanes& b) {
    real += b.real;
    imaginary += b.imaginary;
    return *this;
  }
};

template <int W>
ETENDUE_KERNEL_INLINE ComplexLanes<W> operator+(const ComplexLanes<W>& a, const ComplexLanes<W>& b) {
  return {a.real + b.real, a.imaginary + b.imaginary};
}
template <int W>
ETENDUE_KERNEL_INLINE ComplexLanes<W> operator-(const ComplexLanes<W>& a, const ComplexLanes<W>& b) {
  return {a.real - b.real, a.imaginary - b.imaginary};
}
template <int W>
ETENDUE_KERNEL_INLINE ComplexLanes<W> operator*(const ComplexLanes<W>& a, const ComplexLanes<W>& b) {
  return {a.real * b.real - a.imaginary * b.imaginary, a.real * b.imaginary + a.imaginary * b.real};
}

// Lanes deduce no W: what is real comes as any type that multiplies them.
template <int W, class Factor>
requires(!std::is_same_v<Factor, ComplexLanes<W>>) ETENDUE_KERNEL_INLINE ComplexLanes<W>
operator*(const Factor& a, const ComplexLanes<W>& b) {
  if constexpr (std::is_arithmetic_v<Factor>) {
    const Real factor = static_cast<Real>(a);
    return {factor * b.real, factor * b.imaginary};
  } else {
    return {a * b.real, a * b.imaginary};
  }
}
template <int W, class Part>
requires(!std::is_same_v<Part, ComplexLanes<W>>) ETENDUE_KERNEL_INLINE ComplexLanes<W>
operator+(const ComplexLanes<W>& a, const Part& b) { return {a.real + b, a.imaginary}; }

template <int W>
ETENDUE_KERNEL_INLINE ComplexLanes<W> reciprocal(const ComplexLanes<W>& a) {
  const Lanes<W> inverse = 1.0 / (a.real * a.real + a.imaginary * a.imaginary);
  return {a.real * inverse, -a.imaginary * inverse};
}

/// W numbers of either kind.
template <Numbers numbers, int W>
struct ValuesOf {
  using type = Lanes<W>;
};
template <int W>
struct ValuesOf<Numbers::complex, W> {
  using type = ComplexLanes<W>;
};
template <Numbers numbers, int W>
using Values = typename ValuesOf<numbers, W>::type;

/// Places in memory of one number.
template <Numbers numbers>
constexpr int places_of = numbers == Numbers::complex ? 2 : 1;

/// Pairs (real, imaginary) that lie one behind the other into lanes, and back.
template <int W>
ETENDUE_KERNEL_INLINE ComplexLanes<W> parted(const Lanes<2 * W>& pairs) {
  if constexpr (W == 1) {
    return {pairs[0], pairs[1]};
  } else if constexpr (W == 2) {
    return {__builtin_shufflevector(pairs, pairs, 0, 2), __builtin_shufflevector(pairs, pairs, 1, 3)};
  } else if constexpr (W == 4) {
    return {__builtin_shufflevector(pairs, pairs, 0, 2, 4, 6),
            __builtin_shufflevector(pairs, pairs, 1, 3, 5, 7)};
  } else {
    static_assert(W == 8);
    return {__builtin_shufflevector(pairs, pairs, 0, 2, 4, 6, 8, 10, 12, 14),
            __builtin_shufflevector(pairs, pairs, 1, 3, 5, 7, 9, 11, 13, 15)};
  }
}

template <int W>
ETENDUE_KERNEL_INLINE Lanes<2 * W> paired(const ComplexLanes<W>& a) {
  if constexpr (W == 1) {
    return join(a.real, a.imaginary);
  } else if constexpr (W == 2) {
    return __builtin_shufflevector(a.real, a.imaginary, 0, 2, 1, 3);
  } else if constexpr (W == 4) {
    return __builtin_shufflevector(a.real, a.imaginary, 0, 4, 1, 5, 2, 6, 3, 7);
  } else {
    static_assert(W == 8);
    return __builtin_shufflevector(a.real, a.imaginary, 0, 8, 1, 9, 2, 10, 3, 11, 4, 12, 5, 13, 6, 14, 7, 15);
  }
}

/// Two parts of the size of what is removed: the first in every cell, the second where the mass is
/// consistent. The record has a negative mass where it is lumped (cell_record.h), of which either part may be
/// zero.
template <class T>
struct CellMass {
  T alpha;
  T beta;
};

template <class T>
ETENDUE_KERNEL_INLINE CellMass<T> cell_mass(const T& recorded) {
  return {recorded < 0 ? -recorded : recorded, recorded < 0 ? T{} : recorded};
}

template <int W>
ETENDUE_KERNEL_INLINE CellMass<ComplexLanes<W>> cell_mass(const ComplexLanes<W>& recorded) {
  const Lanes<W> least = recorded.real < recorded.imaginary ? recorded.real : recorded.imaginary;
  const Lanes<W> none{};
  return {{recorded.real < 0 ? -recorded.real : recorded.real,
           recorded.imaginary < 0 ? -recorded.imaginary : recorded.imaginary},
          {least < 0 ? none : recorded.real, least < 0 ? none : recorded.imaginary}};
}

}  // namespace
}  // namespace etendue
