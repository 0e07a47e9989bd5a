// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

#include "solver/transport/kernel/kernel_inline.h"

namespace etendue {

/// Polynomial space of the kernel.
enum class Basis { constant, linear };

/// The numbers that a sweep computes with: double, or float where it only serves an iteration.
enum class Scalar { double_precision, single_precision };

template <class Real>
inline constexpr Scalar scalar_of = sizeof(Real) == sizeof(double) ? Scalar::double_precision
                                                                   : Scalar::single_precision;

ETENDUE_KERNEL_INLINE constexpr int nodes_per_cell(Basis basis) { return basis == Basis::linear ? 4 : 1; }
ETENDUE_KERNEL_INLINE constexpr int nodes_per_face(Basis basis) { return basis == Basis::linear ? 3 : 1; }

/// All that a sweep reads of one cell, whatever the direction, lies together in one record of whole cache
/// lines: with one band and the linear basis two of them, or one of floats. Positions are in numbers;
/// `stride` is the number of bands rounded up to whole lanes, and the band is the fastest index.
///
/// A record begins with x, y, z of the outward area normals of faces 0, 1 and 2 [length^2]; that of face 3 is
/// minus their sum. Four numbers are read at each of x, y and z.
struct RecordLayout {
  std::size_t mass = 0;    ///< [stride] see below
  std::size_t source = 0;  ///< [node][stride] right-hand side of isotropic sources, times 12 if linear
  std::size_t length = 0;  ///< from one record to the next
};

// The mass is sigma_t V for constants. For the linear basis its size is alpha_mass of cell_balance.h, and its
// sign says which mass: consistent (beta_mass = alpha_mass) or, below zero, lumped (beta_mass = 0). Of
// complex numbers that is so for both parts, which have one sign.

ETENDUE_KERNEL_INLINE constexpr RecordLayout record_layout(Basis basis, int stride,
                                                           Scalar scalar = Scalar::double_precision) {
  const std::size_t line = scalar == Scalar::double_precision ? 8 : 16;
  const auto bands = static_cast<std::size_t>(stride);
  RecordLayout layout;
  // Wide lanes do not straddle cache lines.
  layout.mass = bands == 1 ? 10 : bands < 8 ? 12 : 16;
  layout.source = bands == 1 ? 12 : layout.mass + bands;
  layout.length =
      (layout.source + static_cast<std::size_t>(nodes_per_cell(basis)) * bands + line - 1) / line * line;
  return layout;
}

}  // namespace etendue
