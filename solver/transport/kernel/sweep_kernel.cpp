// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Compiled once for each instruction set and for double and float (ETENDUE_KERNEL_REAL), with
// ETENDUE_KERNEL_NAME naming the one function that is visible and ETENDUE_KERNEL_LANES saying how many
// numbers its registers hold. Nothing in here may come from a header that other files share as code
// (kernel_inline.h says why).
#include "solver/transport/kernel/sweep_kernel.h"

#include "solver/transport/kernel/block_projected_areas.h"
#include "solver/transport/kernel/cell_balance.h"
#include "solver/transport/kernel/complex_lanes.h"
#include "solver/transport/kernel/flush_denormals.h"
#include "solver/transport/kernel/moment_kernel.h"
#include "solver/transport/kernel/packet.h"
#include "solver/transport/kernel/positivity_fixup.h"
#include "solver/transport/kernel/product_kernel.h"
#include "solver/transport/kernel/visited_cells.h"

namespace etendue {
namespace {

/// B neighbouring bands of each cell, from the place that `from` names for cell j.
template <int C, int B, class From>
ETENDUE_KERNEL_INLINE Lanes<C * B> gather_from(const From& from, std::ptrdiff_t at) {
  const Real* place[C];
  ETENDUE_UNROLL
  for (int j = 0; j < C; ++j) place[j] = from(j);
  return gather_chunks<C, B>(place, at);
}

/// The same of B numbers, real or complex.
template <Numbers numbers, int C, int B, class From>
ETENDUE_KERNEL_INLINE Values<numbers, C * B> gather_values(const From& from, std::ptrdiff_t at) {
  if constexpr (numbers == Numbers::real) {
    return gather_from<C, B>(from, at);
  } else {
    return parted<C * B>(gather_from<C, 2 * B>(from, at));
  }
}

/// Keeps B numbers of each of N nodes of all cells.
template <Numbers numbers, int C, int B, int N, class Cells>
ETENDUE_KERNEL_INLINE void keep_values(const Cells& packet, std::ptrdiff_t stride, std::ptrdiff_t band,
                                       const Values<numbers, C * B> (&u)[N]) {
  constexpr int places = places_of<numbers> * B;
  Lanes<C * places> stored[N];
  ETENDUE_UNROLL
  for (int i = 0; i < N; ++i) {
    if constexpr (numbers == Numbers::real) {
      stored[i] = u[i];
    } else {
      stored[i] = paired<C * B>(u[i]);
    }
  }
  ETENDUE_UNROLL
  for (int j = 0; j < C; ++j) {
    ETENDUE_UNROLL
    for (int i = 0; i < N; ++i)
      packet.template keep<places>(j, i * stride + band, chunk<C, places>(stored[i], j));
  }
}

/// Whether rows of one real number for each node and cell are read and written as a whole.
template <Numbers numbers, int C, int B>
constexpr bool transposes_rows = numbers == Numbers::real&& transposes<C, B>;

/// Right-hand side of the isotropic sources at the four nodes of each cell.
template <Numbers numbers, int C, int B, class Cells>
ETENDUE_KERNEL_INLINE void load_source(const Cells& packet, std::ptrdiff_t stride, std::ptrdiff_t band,
                                       Values<numbers, C * B> (&out)[4]) {
  if constexpr (transposes_rows<numbers, C, B>) {
    Lanes<4> row[C];
    ETENDUE_UNROLL
    for (int j = 0; j < C; ++j) row[j] = load_lanes<4>(packet.source(j));
    Rows<C>::to_lanes(row, out);
  } else {
    ETENDUE_UNROLL
    for (int i = 0; i < 4; ++i)
      out[i] = gather_values<numbers, C, B>([&](int j) { return packet.source(j); }, i * stride + band);
  }
}

/// The nodes of the face opposite a node in the first three lanes.
alignas(4 * sizeof(Real)) constexpr RealChoice face_nodes[4][4] = {
    {1, 2, 3, 0}, {0, 2, 3, 1}, {0, 1, 3, 2}, {0, 1, 2, 3}};

/// Radiance at the three vertices of face f, as the cells behind those faces left it.
template <Numbers numbers, int C, int B, class Cells>
ETENDUE_KERNEL_INLINE void load_face(const Cells& packet, int f, std::ptrdiff_t stride, std::ptrdiff_t band,
                                     Values<numbers, C * B> (&out)[4]) {
  const Real* radiance[C];
  const RealChoice* nodes[C];
  ETENDUE_UNROLL
  for (int j = 0; j < C; ++j) {
    radiance[j] = packet.behind(j, f);
    nodes[j] = face_nodes[packet.visit(j).faces[f] & opposite_bits];
  }
  if constexpr (transposes_rows<numbers, C, B>) {
    Lanes<4> row[C];
    ETENDUE_UNROLL
    for (int j = 0; j < C; ++j) {
      LaneChoice<4> choice;
      std::memcpy(&choice, nodes[j], sizeof choice);
      row[j] = chosen<4>(load_lanes<4>(radiance[j]), choice);
    }
    Rows<C>::to_lanes(row, out);
  } else {
    ETENDUE_UNROLL
    for (int k = 0; k < 3; ++k)
      out[k] = gather_values<numbers, C, B>([&](int j) { return radiance[j] + nodes[j][k] * stride; }, band);
  }
}

/// Whether a face need not be read, because light leaves through it. Only a packet of one cell asks: in
/// others what is read there counts zero times, which is cheaper than a branch that cannot be predicted.
/// The order keeps cells together through whose faces light goes in the same directions, where all bands of a
/// cell fill a packet.
template <int C, int B>
ETENDUE_KERNEL_INLINE bool nothing_enters(const Lanes<C * B>& entering) {
  if constexpr (C > 1) {
    return false;
  } else {
    return !(entering[0] > 0);
  }
}

/// Linear basis.
template <Numbers numbers, int C, int B, class Cells>
ETENDUE_KERNEL_INLINE void balance_linear(const Cells& packet, std::ptrdiff_t stride, std::ptrdiff_t mass_at,
                                          const ProjectedAreas<Lanes<C * B>>& areas, std::ptrdiff_t band) {
  using T = Values<numbers, C * B>;
  const CellMass<T> mass =
      cell_mass(gather_values<numbers, C, B>([&](int j) { return packet.record(j); }, mass_at + band));
  const CellInverse<T> inverse = invert_cell(areas, mass.alpha, mass.beta);
  T right[4];
  load_source<numbers, C, B>(packet, stride, band, right);
  ETENDUE_UNROLL
  for (int f = 0; f < 4; ++f) {
    if (nothing_enters<C, B>(areas.incoming[f])) continue;
    T inflow[4];
    load_face<numbers, C, B>(packet, f, stride, band, inflow);
    add_inflow(areas, f, inflow, right);
  }
  T u[4];
  solve_cell(areas, inverse, right, u);
  if constexpr (Cells::sign == Sign::positive) {
    T weights[4];
    balance_weights(areas, mass.alpha, mass.beta, weights);
    packet.template keep_positive<B>(weights, (right[0] + right[1]) + (right[2] + right[3]), band, u);
  }
  if constexpr (transposes_rows<numbers, C, B>) {
    Lanes<4> row[C];
    Rows<C>::from_lanes(u, row);
    ETENDUE_UNROLL
    for (int j = 0; j < C; ++j) packet.template keep<4>(j, 0, row[j]);
  } else {
    keep_values<numbers, C, B>(packet, stride, band, u);
  }
}

/// Piecewise constants: (sigma_t V + P) u = V q + sum of n_f u_f.
template <Numbers numbers, int C, int B, class Cells>
ETENDUE_KERNEL_INLINE void balance_constant(const Cells& packet, std::ptrdiff_t mass_at,
                                            const ProjectedAreas<Lanes<C * B>>& areas, std::ptrdiff_t band) {
  using T = Values<numbers, C * B>;
  T right = gather_values<numbers, C, B>([&](int j) { return packet.source(j); }, band);
  ETENDUE_UNROLL
  for (int f = 0; f < 4; ++f)
    right +=
        areas.incoming[f] * gather_values<numbers, C, B>([&](int j) { return packet.behind(j, f); }, band);
  const T mass = gather_values<numbers, C, B>([&](int j) { return packet.record(j); }, mass_at + band);
  T u[1];
  if constexpr (numbers == Numbers::real) {
    u[0] = right / (mass + areas.total);
  } else {
    u[0] = right * reciprocal(mass + areas.total);
  }
  keep_values<numbers, C, B>(packet, 0, band, u);
}

/// Cells whose projected areas are found together: as many as there are lanes, whatever the bands, but for
/// sixteen.
constexpr int most_cells_of_block = 8;
constexpr int cells_of_block(int lanes) { return lanes < most_cells_of_block ? lanes : most_cells_of_block; }

/// Some cells of one level, and what a few cells ahead are in the order, null where it ends.
struct Block {
  const SweepVisit* visits;
  const SweepVisit* ahead;
  int count;  ///< of `visits`; up to those of a block there are idle ones behind them
};

template <Numbers numbers, Basis basis, int C, int B, Angular angular, Flux flux, Sign sign>
ETENDUE_KERNEL_INLINE void balance_packet(const SweepTaskOf<Real>& task, const RecordLayout& layout,
                                          const Block& block, int first,
                                          const ProjectedAreas<Lanes<C * B>>& areas) {
  const Packet<basis, C, angular, flux, sign> packet(task, layout, block.visits + first);
  if (block.ahead != nullptr) ETENDUE_UNROLL
  for (int j = 0; j < C; ++j)
    prefetch_cell<angular, flux>(task, block.ahead[first + j], layout.length,
                                 static_cast<std::size_t>(packet.length()));
  const auto mass = static_cast<std::ptrdiff_t>(layout.mass);
  for (std::ptrdiff_t band = 0; band < task.stride; band += places_of<numbers> * B) {
    if constexpr (basis == Basis::linear) {
      balance_linear<numbers, C, B>(packet, task.stride, mass, areas, band);
    } else {
      balance_constant<numbers, C, B>(packet, mass, areas, band);
    }
  }
}

template <Numbers numbers, Basis basis, int C, int B, Angular angular, Flux flux, Sign sign>
ETENDUE_KERNEL_INLINE void balance_block(const SweepTaskOf<Real>& task, const RecordLayout& layout,
                                         const Block& block) {
  constexpr int block_cells = cells_of_block(C * B);
  const ProjectedAreas<Lanes<block_cells>> areas =
      block_projected_areas<block_cells>(task, layout, block.visits);
  if constexpr (B == 1) {
    balance_packet<numbers, basis, C, B, angular, flux, sign>(task, layout, block, 0, areas);
  } else {
    const BlockProjectedAreas<block_cells> stored(areas);
#pragma GCC unroll 1
    for (int first = 0; first < block.count; first += C)
      balance_packet<numbers, basis, C, B, angular, flux, sign>(task, layout, block, first,
                                                                stored.template of_packet<C, B>(first));
  }
}

/// The order itself is read once for each sweep, and comes from memory.
template <int block_cells>
ETENDUE_KERNEL_INLINE void prefetch_visits(const SweepTaskOf<Real>& task, std::int32_t position) {
  const std::int32_t there = position + (task.backwards ? -order_distance : order_distance);
  if (there < task.levels[0] || there + block_cells > task.levels[task.level_count]) return;
  ETENDUE_UNROLL
  for (int j = 0; j < block_cells; j += 2) __builtin_prefetch(task.visits + there + j);
}

/// `Bands` is the stride where it is known when this is compiled, else 0.
template <Numbers numbers, Basis basis, int C, int B, int Bands, Angular angular, Flux flux, Sign sign>
ETENDUE_KERNEL_INLINE void sweep_cells(SweepTaskOf<Real> task) {
  constexpr int block_cells = cells_of_block(C * B);
  if constexpr (Bands > 0) task.stride = Bands;
  const RecordLayout layout = record_layout(basis, static_cast<int>(task.stride), scalar_of<Real>);
  SweepVisit idle;
  idle.cell_and_parallel = task.idle_cell;
  const std::int32_t begin = task.levels[0];
  const std::int32_t end = task.levels[task.level_count];
  for (std::int32_t l = 0; l < task.level_count; ++l) {
    const std::int32_t level = task.backwards ? task.level_count - 1 - l : l;
    const std::int32_t size = task.levels[level + 1] - task.levels[level];
    for (std::int32_t done = 0; done < size; done += block_cells) {
      const std::int32_t count = size - done < block_cells ? size - done : block_cells;
      const std::int32_t position =
          task.backwards ? task.levels[level + 1] - done - count : task.levels[level] + done;
      const std::int32_t ahead = position + (task.backwards ? -prefetch_distance : prefetch_distance);
      Block block{task.visits + position, nullptr, count};
      if (ahead >= begin && ahead + block_cells <= end) block.ahead = task.visits + ahead;
      prefetch_visits<block_cells>(task, position);
      SweepVisit filled[block_cells];
      if (count < block_cells) [[unlikely]] {
        for (int j = 0; j < block_cells; ++j) filled[j] = j < count ? block.visits[j] : idle;
        block.visits = filled;
      }
      balance_block<numbers, basis, C, B, angular, flux, sign>(task, layout, block);
    }
  }
}

template <Numbers numbers, Basis basis, int C, int B, int Bands, Sign sign>
void sweep(const SweepTaskOf<Real>& task) {
  [[maybe_unused]] const FlushDenormals<Real> mode;
  const bool angular = task.angular_index != nullptr;
  const bool flux = task.net_flux != nullptr;
  if (angular && flux) {
    sweep_cells<numbers, basis, C, B, Bands, Angular::present, Flux::add, sign>(task);
  } else if (angular) {
    sweep_cells<numbers, basis, C, B, Bands, Angular::present, Flux::skip, sign>(task);
  } else if (flux) {
    sweep_cells<numbers, basis, C, B, Bands, Angular::absent, Flux::add, sign>(task);
  } else {
    sweep_cells<numbers, basis, C, B, Bands, Angular::absent, Flux::skip, sign>(task);
  }
}

/// Bands fill the lanes first, cells of one level the rest. Sixteen lanes are for sixteen bands alone: with
/// several cells in them floats are as fast in eight, or slower.
template <Basis basis, int Bands, Sign sign = Sign::free, int MostBands = ETENDUE_KERNEL_LANES>
auto sweep_of_bands() {
  constexpr int B = Bands > 0 && Bands < MostBands ? Bands : MostBands;
  constexpr int lanes = B > most_cells_of_block ? B : cells_of_block(ETENDUE_KERNEL_LANES);
  return sweep<Numbers::real, basis, lanes / B, B, Bands, sign>;
}

/// The same of complex numbers, half as many as bands. Pairs of them are what fills the lanes.
template <Basis basis, int Bands>
auto complex_sweep_of() {
  constexpr int lanes = ETENDUE_KERNEL_LANES > 4 ? ETENDUE_KERNEL_LANES / 2 : 2;
  constexpr int most = lanes < 4 ? lanes : 4;
  constexpr int B = Bands > 0 && Bands / 2 < most ? Bands / 2 : most;
  return sweep<Numbers::complex, basis, lanes / B, B, Bands, Sign::free>;
}

/// The widest lanes that divide a row of nodes times bands; two short rows share them.
void choose_moment_kernels(int row, SweepKernelsOf<Real>& kernels) {
  constexpr int widest = 64 / sizeof(Real);
  if (row % widest == 0) {
    set_moment_kernels<1, widest>(kernels);
  } else if (2 * row == widest) {
    set_moment_kernels<2, widest>(kernels);
  } else if (row % 8 == 0) {
    set_moment_kernels<1, 8>(kernels);
  } else if (row == 4) {
    set_moment_kernels<2, 8>(kernels);
  } else if (row == 2) {
    set_moment_kernels<1, 2>(kernels);
  } else {
    set_moment_kernels<1, 1>(kernels);
  }
}

template <Basis basis>
void choose_for(int stride, SweepKernelsOf<Real>& kernels) {
  choose_moment_kernels(nodes_per_cell(basis) * stride, kernels);
  kernels.sweep_complex = stride <= 2   ? complex_sweep_of<basis, 2>()
                          : stride == 4 ? complex_sweep_of<basis, 4>()
                                        : complex_sweep_of<basis, 0>();
  if constexpr (basis == Basis::linear && scalar_of<Real> == Scalar::double_precision)
    kernels.sweep_positive = stride == 1   ? sweep_of_bands<basis, 1, Sign::positive>()
                             : stride == 2 ? sweep_of_bands<basis, 2, Sign::positive>()
                             : stride == 4 ? sweep_of_bands<basis, 4, Sign::positive>()
                                           : sweep_of_bands<basis, 0, Sign::positive>();
  if (stride == 1) {
    kernels.sweep = sweep_of_bands<basis, 1>();
  } else if (stride == 2) {
    kernels.sweep = sweep_of_bands<basis, 2>();
  } else if (stride == 4) {
    kernels.sweep = sweep_of_bands<basis, 4>();
  } else if (stride == 8) {
    kernels.sweep = sweep_of_bands<basis, 8>();
  } else if (stride == 16) {
    kernels.sweep = sweep_of_bands<basis, 16>();
  } else if (stride % ETENDUE_KERNEL_LANES == 0) {
    kernels.sweep = sweep_of_bands<basis, 0>();
  } else {
    kernels.sweep = sweep_of_bands<basis, 0, Sign::free, cells_of_block(ETENDUE_KERNEL_LANES)>();
  }
}

}  // namespace

void ETENDUE_KERNEL_NAME(Basis basis, int stride, SweepKernelsOf<Real>& kernels) {
  if (basis == Basis::linear) {
    choose_for<Basis::linear>(stride, kernels);
  } else {
    choose_for<Basis::constant>(stride, kernels);
  }
  kernels.matrix_product = matrix_product;
  kernels.instruction_set = ETENDUE_KERNEL_ISA;
}

}  // namespace etendue
