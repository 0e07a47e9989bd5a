// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>

#include "solver/transport/kernel/kernel_inline.h"

namespace etendue {

// While a direction is swept, the radiance of a cell stays in a slot until the cells behind it have read it.
// There are far fewer slots than cells, so they stay in cache.

/// Place of the radiance behind one of the faces of a cell: a slot, and the node in that slot which does not
/// lie on the face (3 for the slots of boundary faces, which hold the three values of the face). Packed into
/// 32 bits.
struct FaceCode {
  std::uint32_t slot = 0;
  std::uint32_t opposite = 0;
};

inline constexpr std::uint32_t opposite_bits = 3;

ETENDUE_KERNEL_INLINE constexpr std::uint32_t packed(FaceCode code) { return code.slot << 2 | code.opposite; }
ETENDUE_KERNEL_INLINE constexpr FaceCode unpacked(std::uint32_t code) {
  return {code >> 2, code & opposite_bits};
}

/// The node of a cell that is number k (0, 1, 2) on the face opposite node `opposite`.
ETENDUE_KERNEL_INLINE constexpr std::uint32_t face_node(std::uint32_t opposite, std::uint32_t k) {
  return k + (k >= opposite ? 1 : 0);
}

/// One visit of a sweep.
struct SweepVisit {
  /// The cell in the lower 28 bits, and above them a bit for each of its faces that is parallel to the
  /// direction, so that both sides of a face agree on it.
  std::uint32_t cell_and_parallel = 0;
  std::uint32_t slot = 0;       ///< where the cell leaves its radiance
  std::uint32_t faces[4] = {};  ///< packed FaceCode of what lies behind each face
};

inline constexpr int visit_cell_bits = 28;

/// Cells that a sweep order can number: one number is the idle cell's.
inline constexpr std::int64_t most_cells = (std::int64_t{1} << visit_cell_bits) - 1;

ETENDUE_KERNEL_INLINE constexpr std::uint32_t visited_cell(const SweepVisit& visit) {
  return visit.cell_and_parallel & ((std::uint32_t{1} << visit_cell_bits) - 1);
}

/// Bit f for face f.
ETENDUE_KERNEL_INLINE constexpr std::uint32_t parallel_faces(const SweepVisit& visit) {
  return visit.cell_and_parallel >> visit_cell_bits;
}

}  // namespace etendue
