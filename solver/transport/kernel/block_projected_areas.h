// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

// For the kernel files only.
#include <cstdint>

#include "solver/transport/kernel/cell_balance.h"
#include "solver/transport/kernel/packet.h"
#include "solver/transport/kernel/sweep_kernel.h"

namespace etendue {
namespace {

/// Projected areas of W consecutive cells of the order, lane j those of cell j: exactly zero on parallel
/// faces, for both of their sides. All bands share them.
template <int W>
ETENDUE_KERNEL_INLINE ProjectedAreas<Lanes<W>> block_projected_areas(const SweepTaskOf<Real>& task,
                                                                     const RecordLayout& layout,
                                                                     const SweepVisit* visits) {
  Lanes<4> seen[W];
  std::uint32_t parallel = 0;
  ETENDUE_UNROLL
  for (int j = 0; j < W; ++j) {
    const Real* normals = task.records + visited_cell(visits[j]) * layout.length;
    seen[j] = (task.direction[0] * load_lanes<4>(normals) + task.direction[1] * load_lanes<4>(normals + 3)) +
              task.direction[2] * load_lanes<4>(normals + 6);
    parallel |= visits[j].cell_and_parallel;
  }
  Lanes<W> a[4];
  spread_rows<W>(seen, a);
  a[3] = -((a[0] + a[1]) + a[2]);
  if (parallel >> visit_cell_bits != 0) [[unlikely]] {
    for (int f = 0; f < 4; ++f) {
      LaneChoice<W> keep{};
      for (int j = 0; j < W; ++j) keep[j] = (parallel_faces(visits[j]) >> f & 1) != 0 ? 0 : -1;
      a[f] = keep != 0 ? a[f] : Lanes<W>{};
    }
  }
  return projected_areas(a);
}

/// Projected areas of W cells, spread from the lanes of cells to those of packets.
template <int W>
class BlockProjectedAreas {
 public:
  ETENDUE_KERNEL_MEMBER explicit BlockProjectedAreas(const ProjectedAreas<Lanes<W>>& areas) {
    ETENDUE_UNROLL
    for (int f = 0; f < 4; ++f) {
      store_lanes<W>(outgoing_[f], areas.outgoing[f]);
      store_lanes<W>(incoming_[f], areas.incoming[f]);
    }
    store_lanes<W>(total_, areas.total);
  }

  /// Of the packet of C cells and B bands that begins with cell `first`.
  template <int C, int B>
  ETENDUE_KERNEL_MEMBER ProjectedAreas<Lanes<C * B>> of_packet(int first) const {
    LaneChoice<W> cells{};
    for (int lane = 0; lane < W; ++lane) cells[lane] = first + lane / B;
    ProjectedAreas<Lanes<C * B>> areas;
    ETENDUE_UNROLL
    for (int f = 0; f < 4; ++f) {
      areas.outgoing[f] = spread<C, B>(outgoing_[f], first, cells);
      areas.incoming[f] = spread<C, B>(incoming_[f], first, cells);
    }
    areas.total = spread<C, B>(total_, first, cells);
    return areas;
  }

 private:
  /// Numbers of the packet's cells, each in the lanes of its bands.
  template <int C, int B>
  ETENDUE_KERNEL_MEMBER static Lanes<C * B> spread(const Real* values, int first,
                                                   const LaneChoice<W>& cells) {
    if constexpr (C == 1) {
      return repeat<B>(values[first]);
    } else {
      static_assert(C * B == W);
      return chosen<W>(load_lanes<W>(values), cells);
    }
  }

  alignas(sizeof(Real) * W) Real outgoing_[4][W];
  alignas(sizeof(Real) * W) Real incoming_[4][W];
  alignas(sizeof(Real) * W) Real total_[W];
};

}  // namespace
}  // namespace etendue
