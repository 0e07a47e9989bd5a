// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>

#include "solver/transport/kernel/lanes.h"

namespace etendue {
namespace {

// A packet is C cells of one level times B neighbouring bands, side by side in C B lanes: cell j's band b is
// lane j B + b. These functions bring numbers that lie together in memory, cell by cell, into lanes and back.

/// Chunks of B numbers from C places, one behind the other.
template <int C, int B>
ETENDUE_KERNEL_INLINE Lanes<C * B> gather_chunks(const Real* const* from, std::ptrdiff_t at) {
  if constexpr (C == 1) {
    return load_lanes<B>(from[0] + at);
  } else {
    return join(gather_chunks<C / 2, B>(from, at), gather_chunks<C / 2, B>(from + C / 2, at));
  }
}

/// The chunk of cell j.
template <int C, int B>
ETENDUE_KERNEL_INLINE Lanes<B> chunk(const Lanes<C * B>& lanes, int j) {
  if constexpr (C == 1) {
    return lanes;
  } else {
    return j < C / 2 ? chunk<C / 2, B>(low_half(lanes), j) : chunk<C / 2, B>(high_half(lanes), j - C / 2);
  }
}

/// Rows of four numbers, one for each cell, into four packets of one number for each cell, and back.
template <int C>
struct Rows;

template <>
struct Rows<4> {
  ETENDUE_KERNEL_INLINE void to_lanes(const Lanes<4> (&row)[4], Lanes<4> (&out)[4]) {
    const Lanes<4> a = __builtin_shufflevector(row[0], row[1], 0, 4, 2, 6);
    const Lanes<4> b = __builtin_shufflevector(row[0], row[1], 1, 5, 3, 7);
    const Lanes<4> c = __builtin_shufflevector(row[2], row[3], 0, 4, 2, 6);
    const Lanes<4> d = __builtin_shufflevector(row[2], row[3], 1, 5, 3, 7);
    out[0] = __builtin_shufflevector(a, c, 0, 1, 4, 5);
    out[1] = __builtin_shufflevector(b, d, 0, 1, 4, 5);
    out[2] = __builtin_shufflevector(a, c, 2, 3, 6, 7);
    out[3] = __builtin_shufflevector(b, d, 2, 3, 6, 7);
  }
  ETENDUE_KERNEL_INLINE void from_lanes(const Lanes<4> (&lanes)[4], Lanes<4> (&row)[4]) {
    to_lanes(lanes, row);
  }
};

template <>
struct Rows<8> {
  // The cells j and j + 4 share a register, so that the four by four transposition serves twice.
  ETENDUE_KERNEL_INLINE void to_lanes(const Lanes<4> (&row)[8], Lanes<8> (&out)[4]) {
    const Lanes<8> paired[4] = {join(row[0], row[4]), join(row[1], row[5]), join(row[2], row[6]),
                                join(row[3], row[7])};
    transpose_halves(paired, out);
  }
  ETENDUE_KERNEL_INLINE void from_lanes(const Lanes<8> (&lanes)[4], Lanes<4> (&row)[8]) {
    Lanes<8> paired[4];
    transpose_halves(lanes, paired);
    for (int j = 0; j < 4; ++j) {
      row[j] = low_half(paired[j]);
      row[j + 4] = high_half(paired[j]);
    }
  }

 private:
  ETENDUE_KERNEL_INLINE void transpose_halves(const Lanes<8> (&row)[4], Lanes<8> (&out)[4]) {
    const Lanes<8> a = __builtin_shufflevector(row[0], row[1], 0, 8, 2, 10, 4, 12, 6, 14);
    const Lanes<8> b = __builtin_shufflevector(row[0], row[1], 1, 9, 3, 11, 5, 13, 7, 15);
    const Lanes<8> c = __builtin_shufflevector(row[2], row[3], 0, 8, 2, 10, 4, 12, 6, 14);
    const Lanes<8> d = __builtin_shufflevector(row[2], row[3], 1, 9, 3, 11, 5, 13, 7, 15);
    out[0] = __builtin_shufflevector(a, c, 0, 1, 8, 9, 4, 5, 12, 13);
    out[1] = __builtin_shufflevector(b, d, 0, 1, 8, 9, 4, 5, 12, 13);
    out[2] = __builtin_shufflevector(a, c, 2, 3, 10, 11, 6, 7, 14, 15);
    out[3] = __builtin_shufflevector(b, d, 2, 3, 10, 11, 6, 7, 14, 15);
  }
};

/// Whether a packet holds one band of enough cells that transposing whole rows beats fetching single numbers.
template <int C, int B>
constexpr bool transposes = B == 1 && C >= 4;

/// B lanes of one value.
template <int B>
ETENDUE_KERNEL_INLINE Lanes<B> repeat(Real value) {
  if constexpr (B == 1) {
    return value;
  } else {
    return value - Lanes<B>{};
  }
}

/// out[f], in lane j, is row[j][f].
template <int C>
ETENDUE_KERNEL_INLINE void spread_rows(const Lanes<4> (&row)[C], Lanes<C> (&out)[4]) {
  if constexpr (transposes<C, 1>) {
    Rows<C>::to_lanes(row, out);
  } else {
    static_assert(C == 2);
    for (int f = 0; f < 4; ++f) out[f] = join(row[0][f], row[1][f]);
  }
}

}  // namespace
}  // namespace etendue
