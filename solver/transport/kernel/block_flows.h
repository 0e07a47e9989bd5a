// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

// For the kernel files only.
#include <cstdint>

#include "solver/transport/kernel/cell_balance.h"
#include "solver/transport/kernel/packet.h"
#include "solver/transport/kernel/sweep_kernel.h"

namespace etendue {
namespace {

/// The flows of W cells that stand one behind the other in the order, lane j those of cell j: exactly zero on
/// parallel faces, whichever side looks. All bands share them.
template <int W>
ETENDUE_KERNEL_INLINE FaceFlows<Lanes<W>> seen_faces(const SweepTaskOf<Real>& task,
                                                     const RecordLayout& layout, const SweepVisit* visits) {
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
  return face_flows(a);
}

/// The flows of W cells on their way from the lanes of cells to those of packets.
template <int W>
class BlockFlows {
 public:
  ETENDUE_KERNEL_MEMBER explicit BlockFlows(const FaceFlows<Lanes<W>>& flows) {
    ETENDUE_UNROLL
    for (int f = 0; f < 4; ++f) {
      store_lanes<W>(leaving_[f], flows.leaving[f]);
      store_lanes<W>(entering_[f], flows.entering[f]);
    }
    store_lanes<W>(total_, flows.total);
  }

  /// Of the packet of C cells and B bands that begins with cell `first`.
  template <int C, int B>
  ETENDUE_KERNEL_MEMBER FaceFlows<Lanes<C * B>> of_packet(int first) const {
    LaneChoice<W> cells{};
    for (int lane = 0; lane < W; ++lane) cells[lane] = first + lane / B;
    FaceFlows<Lanes<C * B>> flows;
    ETENDUE_UNROLL
    for (int f = 0; f < 4; ++f) {
      flows.leaving[f] = spread<C, B>(leaving_[f], first, cells);
      flows.entering[f] = spread<C, B>(entering_[f], first, cells);
    }
    flows.total = spread<C, B>(total_, first, cells);
    return flows;
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

  alignas(sizeof(Real) * W) Real leaving_[4][W];
  alignas(sizeof(Real) * W) Real entering_[4][W];
  alignas(sizeof(Real) * W) Real total_[W];
};

}  // namespace
}  // namespace etendue
