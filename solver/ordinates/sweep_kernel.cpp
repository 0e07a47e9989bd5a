// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Compiled once for each instruction set, with ETENDUE_KERNEL_NAME naming the one function that is visible
// and ETENDUE_KERNEL_LANES saying how many numbers its registers hold. Nothing in here may come from a header
// that other files share as code (kernel_inline.h says why).
#include "solver/ordinates/sweep_kernel.h"

#include "solver/ordinates/cell_balance.h"
#include "solver/ordinates/moment_kernel.h"
#include "solver/ordinates/packet.h"

namespace etendue {
namespace {

/// Cells ahead whose data are asked for: about the latency of memory over the time of a cell.
constexpr std::int32_t prefetch_distance = 16;

/// Whether the task has angular cells, and whether it adds up the net flux.
enum class Angular { absent, present };
enum class Flux { skip, add };

ETENDUE_KERNEL_INLINE void prefetch_cell(const SweepTask& task, const SweepVisit& visit,
                                         std::size_t record_length, std::size_t length) {
  const std::size_t cell = visited_cell(visit);
  const double* record = task.records + cell * record_length;
  const double* fluence = task.fluence + cell * length;
  for (std::size_t i = 0; i < record_length; i += 8) __builtin_prefetch(record + i, 0);
  for (std::size_t i = 0; i < length; i += 8) __builtin_prefetch(fluence + i, 1);
}

/// The cells of one packet: where their numbers are read and written.
template <int C>
struct Packet {
  std::uint32_t parallel[C];
  const std::uint32_t* faces[C];
  const double* record[C];
  const double* source[C];
  double* slot[C];
  double* fluence[C];
  double* radiance[C];  ///< kept for angular cells, else a scratch row
  double* net_flux[C];
};

/// Fills the lanes from `count` cells and, where those are fewer than C, the idle one.
template <Basis basis, int C, Angular angular, Flux flux>
ETENDUE_KERNEL_INLINE void fill_packet(const SweepTask& task, const RecordLayout& layout,
                                       const SweepVisit* visits, std::int32_t count, const SweepVisit& idle,
                                       Packet<C>& packet) {
  const std::size_t length = static_cast<std::size_t>(nodes_per_cell(basis) * task.stride);
  for (int j = 0; j < C; ++j) {
    const SweepVisit& visit = j < count ? visits[j] : idle;
    const std::size_t cell = visited_cell(visit);
    packet.parallel[j] = parallel_faces(visit);
    packet.faces[j] = visit.faces;
    packet.record[j] = task.records + cell * layout.length;
    packet.source[j] = packet.record[j] + layout.source;
    packet.slot[j] = task.slots + visit.slot * length;
    packet.fluence[j] = task.fluence + cell * length;
    if constexpr (angular == Angular::present) {
      // The row of a cell without angular source is the scratch row 0.
      const std::int32_t row = task.angular_index[cell];
      packet.radiance[j] = task.angular + static_cast<std::size_t>(row) * length;
      if (row > 0) packet.source[j] = packet.radiance[j];
    }
    if constexpr (flux == Flux::add) packet.net_flux[j] = task.net_flux + cell * 3 * length;
  }
}

/// The seen areas of all faces; exactly zero on parallel ones, whichever side looks.
template <int C, int B>
ETENDUE_KERNEL_INLINE FaceFlows<Lanes<C * B>> seen_faces(const SweepTask& task, const Packet<C>& packet) {
  Lanes<4> seen[C];
  std::uint32_t parallel = 0;
  for (int j = 0; j < C; ++j) {
    const double* normals = packet.record[j];
    seen[j] = (task.direction[0] * load_lanes<4>(normals) + task.direction[1] * load_lanes<4>(normals + 3)) +
              task.direction[2] * load_lanes<4>(normals + 6);
    parallel |= packet.parallel[j];
  }
  Lanes<C * B> a[4];
  spread_rows<C, B>(seen, a);
  a[3] = -((a[0] + a[1]) + a[2]);
  if (parallel != 0) [[unlikely]] {
    for (int f = 0; f < 4; ++f) {
      LaneChoice<C * B> keep;
      for (int j = 0; j < C; ++j)
        for (int b = 0; b < B; ++b) keep[j * B + b] = (packet.parallel[j] >> f & 1) != 0 ? 0 : -1;
      a[f] = keep != 0 ? a[f] : Lanes<C * B>{};
    }
  }
  return face_flows(a);
}

/// Leaves one direction's radiance to the cells behind, and adds it to the sums.
template <int B, Angular angular, Flux flux, int C>
ETENDUE_KERNEL_INLINE void keep_chunk(const SweepTask& task, const Packet<C>& packet, int j,
                                      std::ptrdiff_t length, std::ptrdiff_t at, const Lanes<B>& u) {
  const Lanes<B> weighted = task.weight * u;
  double* sum = packet.fluence[j] + at;
  store_lanes<B>(packet.slot[j] + at, u);
  store_lanes<B>(sum, load_lanes<B>(sum) + weighted);
  if constexpr (angular == Angular::present) store_lanes<B>(packet.radiance[j] + at, u);
  if constexpr (flux == Flux::add)
    for (int axis = 0; axis < 3; ++axis) {
      double* flow = packet.net_flux[j] + axis * length + at;
      store_lanes<B>(flow, load_lanes<B>(flow) + task.direction[axis] * weighted);
    }
}

/// Four nodal values of each cell, from [node][stride].
template <int C, int B>
ETENDUE_KERNEL_INLINE void load_nodes(const double* const (&from)[C], std::ptrdiff_t stride,
                                      std::ptrdiff_t band, Lanes<C * B> (&out)[4]) {
  if constexpr (transposes<C, B>) {
    Lanes<4> row[C];
    for (int j = 0; j < C; ++j) row[j] = load_lanes<4>(from[j]);
    Rows<C>::to_lanes(row, out);
  } else {
    for (int i = 0; i < 4; ++i) out[i] = gather_chunks<C, B>(from, i * stride + band);
  }
}

/// The nodes of a face in the first three lanes.
alignas(32) constexpr long long face_nodes[4][4] = {{1, 2, 3, 0}, {0, 2, 3, 1}, {0, 1, 3, 2}, {0, 1, 2, 3}};

/// Radiance at the three vertices of face f, as the cells behind those faces left it. All four faces are
/// read: what is read where light leaves counts zero times, which spares every branch on the sign of a_f.
template <int C, int B>
ETENDUE_KERNEL_INLINE void load_face(const SweepTask& task, const Packet<C>& packet, int f,
                                     std::ptrdiff_t band, Lanes<C * B> (&out)[4]) {
  const std::ptrdiff_t stride = task.stride;
  FaceCode code[C];
  const double* radiance[C];
  for (int j = 0; j < C; ++j) {
    code[j] = unpacked(packet.faces[j][f]);
    radiance[j] = task.slots + static_cast<std::ptrdiff_t>(code[j].slot) * 4 * stride;
  }
  if constexpr (transposes<C, B>) {
    Lanes<4> row[C];
    for (int j = 0; j < C; ++j) {
      LaneChoice<4> nodes;
      std::memcpy(&nodes, face_nodes[code[j].opposite], sizeof nodes);
      row[j] = __builtin_shuffle(load_lanes<4>(radiance[j]), nodes);
    }
    Rows<C>::to_lanes(row, out);
  } else {
    for (std::uint32_t k = 0; k < 3; ++k) {
      const double* node[C];
      for (int j = 0; j < C; ++j)
        node[j] = radiance[j] + static_cast<std::ptrdiff_t>(face_node(code[j].opposite, k)) * stride;
      out[k] = gather_chunks<C, B>(node, band);
    }
  }
}

/// Linear basis.
template <int C, int B, Angular angular, Flux flux>
ETENDUE_KERNEL_INLINE void balance_linear(const SweepTask& task, const RecordLayout& layout,
                                          const Packet<C>& packet, const FaceFlows<Lanes<C * B>>& flows,
                                          std::ptrdiff_t band) {
  using T = Lanes<C * B>;
  T right[4];
  load_nodes<C, B>(packet.source, task.stride, band, right);
  for (int f = 0; f < 4; ++f) {
    T inflow[4];
    load_face<C, B>(task, packet, f, band, inflow);
    add_inflow(flows, f, inflow, right);
  }
  const T mass = gather_chunks<C, B>(packet.record, static_cast<std::ptrdiff_t>(layout.mass) + band);
  const T alpha_mass = mass < 0 ? -mass : mass;
  const T beta_mass = mass < 0 ? T{} : mass;
  T u[4];
  solve_cell(flows, alpha_mass, beta_mass, right, u);
  const std::ptrdiff_t length = 4 * task.stride;
  if constexpr (transposes<C, B>) {
    Lanes<4> row[C];
    Rows<C>::from_lanes(u, row);
    for (int j = 0; j < C; ++j) keep_chunk<4, angular, flux>(task, packet, j, length, 0, row[j]);
  } else {
    for (int j = 0; j < C; ++j)
      for (int i = 0; i < 4; ++i)
        keep_chunk<B, angular, flux>(task, packet, j, length, i * task.stride + band, chunk<C, B>(u[i], j));
  }
}

/// Piecewise constants: (sigma_t V + P) u = V q + sum of n_f u_f.
template <int C, int B, Angular angular, Flux flux>
ETENDUE_KERNEL_INLINE void balance_constant(const SweepTask& task, const RecordLayout& layout,
                                            const Packet<C>& packet, const FaceFlows<Lanes<C * B>>& flows,
                                            std::ptrdiff_t band) {
  using T = Lanes<C * B>;
  T right = gather_chunks<C, B>(packet.source, band);
  for (int f = 0; f < 4; ++f) {
    const double* radiance[C];
    for (int j = 0; j < C; ++j)
      radiance[j] = task.slots + static_cast<std::ptrdiff_t>(unpacked(packet.faces[j][f]).slot) * task.stride;
    right += flows.entering[f] * gather_chunks<C, B>(radiance, band);
  }
  const T mass = gather_chunks<C, B>(packet.record, static_cast<std::ptrdiff_t>(layout.mass) + band);
  const T u = right / (mass + flows.total);
  for (int j = 0; j < C; ++j)
    keep_chunk<B, angular, flux>(task, packet, j, task.stride, band, chunk<C, B>(u, j));
}

/// `Bands` is the stride where it is known when this is compiled, else 0.
template <Basis basis, int C, int B, int Bands, Angular angular, Flux flux>
ETENDUE_KERNEL_INLINE void sweep_cells(SweepTask task) {
  if constexpr (Bands > 0) task.stride = Bands;
  const RecordLayout layout = record_layout(basis, static_cast<int>(task.stride));
  const std::size_t length = static_cast<std::size_t>(nodes_per_cell(basis) * task.stride);
  SweepVisit idle;
  idle.cell_and_parallel = task.idle_cell;
  const std::int32_t end = task.levels[task.level_count];
  for (std::int32_t l = 0; l < task.level_count; ++l) {
    const std::int32_t level = task.backwards ? task.level_count - 1 - l : l;
    const std::int32_t level_begin = task.levels[level];
    const std::int32_t level_end = task.levels[level + 1];
    for (std::int32_t done = 0; done < level_end - level_begin; done += C) {
      const std::int32_t count = level_end - level_begin - done < C ? level_end - level_begin - done : C;
      const std::int32_t position = task.backwards ? level_end - done - count : level_begin + done;
      const std::int32_t ahead = position + (task.backwards ? -prefetch_distance : prefetch_distance);
      if (ahead >= 0 && ahead + C <= end)
        for (int j = 0; j < C; ++j) prefetch_cell(task, task.visits[ahead + j], layout.length, length);
      Packet<C> packet;
      fill_packet<basis, C, angular, flux>(task, layout, task.visits + position, count, idle, packet);
      const FaceFlows<Lanes<C* B>> flows = seen_faces<C, B>(task, packet);
      for (std::ptrdiff_t band = 0; band < task.stride; band += B) {
        if constexpr (basis == Basis::linear) {
          balance_linear<C, B, angular, flux>(task, layout, packet, flows, band);
        } else {
          balance_constant<C, B, angular, flux>(task, layout, packet, flows, band);
        }
      }
    }
  }
}

template <Basis basis, int C, int B, int Bands>
void sweep(const SweepTask& task) {
  const bool angular = task.angular_index != nullptr;
  const bool flux = task.net_flux != nullptr;
  if (angular && flux) {
    sweep_cells<basis, C, B, Bands, Angular::present, Flux::add>(task);
  } else if (angular) {
    sweep_cells<basis, C, B, Bands, Angular::present, Flux::skip>(task);
  } else if (flux) {
    sweep_cells<basis, C, B, Bands, Angular::absent, Flux::add>(task);
  } else {
    sweep_cells<basis, C, B, Bands, Angular::absent, Flux::skip>(task);
  }
}

/// Bands fill the lanes first, cells of one level the rest.
template <Basis basis, int Bands>
auto sweep_of_bands() {
  constexpr int lanes = ETENDUE_KERNEL_LANES;
  constexpr int B = Bands > 0 && Bands < lanes ? Bands : lanes;
  return sweep<basis, lanes / B, B, Bands>;
}

template <Basis basis>
SweepKernels kernels_for(int stride) {
  SweepKernels kernels;
  // The widest lanes that divide a row of nodes times bands.
  const int row = nodes_per_cell(basis) * stride;
  if (row % 8 == 0) {
    set_moment_kernels<8>(kernels);
  } else if (row % 4 == 0) {
    set_moment_kernels<4>(kernels);
  } else if (row % 2 == 0) {
    set_moment_kernels<2>(kernels);
  } else {
    set_moment_kernels<1>(kernels);
  }
  if (stride == 1) {
    kernels.sweep = sweep_of_bands<basis, 1>();
  } else if (stride == 2) {
    kernels.sweep = sweep_of_bands<basis, 2>();
  } else if (stride == 4) {
    kernels.sweep = sweep_of_bands<basis, 4>();
  } else if (stride == 8) {
    kernels.sweep = sweep_of_bands<basis, 8>();
  } else {
    kernels.sweep = sweep_of_bands<basis, 0>();
  }
  return kernels;
}

}  // namespace

SweepKernels ETENDUE_KERNEL_NAME(Basis basis, int stride) {
  SweepKernels kernels =
      basis == Basis::linear ? kernels_for<Basis::linear>(stride) : kernels_for<Basis::constant>(stride);
  kernels.instruction_set = ETENDUE_KERNEL_ISA;
  return kernels;
}

}  // namespace etendue
