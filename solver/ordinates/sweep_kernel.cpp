// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Compiled once for each instruction set, with ETENDUE_KERNEL_NAME naming the one function that is visible
// and ETENDUE_KERNEL_LANES saying how many numbers its registers hold. Nothing in here may come from a header
// that other files share as code (kernel_inline.h says why).
#include "solver/ordinates/sweep_kernel.h"

#include "solver/ordinates/cell_balance.h"
#include "solver/ordinates/moment_kernel.h"
#include "solver/ordinates/packet.h"
#include "solver/ordinates/positivity_fixup.h"
#include "solver/ordinates/product_kernel.h"

namespace etendue {
namespace {

/// Cells ahead whose data are asked for: about the latency of memory over the time of a cell.
constexpr std::int32_t prefetch_distance = 16;

/// Whether the task has angular cells, whether it adds up the net flux, and whether it keeps values positive.
enum class Angular { absent, present };
enum class Flux { skip, add };
enum class Sign { free, positive };

template <int Write>
ETENDUE_KERNEL_INLINE void prefetch_lines(const double* from, std::size_t length) {
  for (std::size_t i = 0; i < length; i += 8) __builtin_prefetch(from + i, Write);
}

/// `length` is that of a cell's radiance.
template <Angular angular, Flux flux>
ETENDUE_KERNEL_INLINE void prefetch_cell(const SweepTask& task, const SweepVisit& visit,
                                         std::size_t record_length, std::size_t length) {
  const std::size_t cell = visited_cell(visit);
  prefetch_lines<0>(task.records + cell * record_length, record_length);
  prefetch_lines<1>(task.fluence + cell * length, length);
  if (task.fetches_slots) {
    prefetch_lines<1>(task.slots + visit.slot * length, length);
    ETENDUE_UNROLL
    for (int f = 0; f < 4; ++f)
      prefetch_lines<0>(task.slots + unpacked(visit.faces[f]).slot * length, length);
  }
  if constexpr (angular == Angular::present)
    prefetch_lines<1>(task.angular + static_cast<std::size_t>(task.angular_index[cell]) * length, length);
  if constexpr (flux == Flux::add) prefetch_lines<1>(task.net_flux + cell * 3 * length, 3 * length);
}

/// Gives values that are not all positive a sign, and writes that down.
ETENDUE_KERNEL_INLINE void fix_values(Fixup fixup, const double (&weights)[4], double balance, double volume,
                                      double (&u)[4], FixupCensus& census) {
  double before[4];
  for (int i = 0; i < 4; ++i) {
    before[i] = u[i];
    census.smallest = u[i] < census.smallest ? u[i] : census.smallest;
  }
  ++census.cells;
  if (balance < 0) {
    ++census.failed;
    return;
  }
  if (fixup == Fixup::rescale) {
    rescale_to_balance(weights, balance, u);
  } else {
    project_on_balance(weights, balance, u);
  }
  for (int i = 0; i < 4; ++i)
    census.moved += volume / 4 * (u[i] < before[i] ? before[i] - u[i] : u[i] - before[i]);
}

/// The cells of one packet, and where their numbers are read and written.
template <Basis basis, int C, Angular angular, Flux flux, Sign the_sign>
class Packet {
 public:
  static constexpr Sign sign = the_sign;

  ETENDUE_KERNEL_MEMBER Packet(const SweepTask& task, const RecordLayout& layout, const SweepVisit* visits)
      : task_(task), layout_(layout), visits_(visits) {
    ETENDUE_UNROLL
    for (int j = 0; j < C; ++j) cell_[j] = visited_cell(visits[j]);
  }

  ETENDUE_KERNEL_MEMBER std::ptrdiff_t length() const { return nodes_per_cell(basis) * task_.stride; }
  ETENDUE_KERNEL_MEMBER const SweepVisit& visit(int j) const { return visits_[j]; }
  ETENDUE_KERNEL_MEMBER const double* record(int j) const {
    return task_.records + cell_[j] * layout_.length;
  }
  ETENDUE_KERNEL_MEMBER const double* source(int j) const {
    if constexpr (angular == Angular::present)
      if (task_.angular_index[cell_[j]] > 0) return radiance(j);
    return record(j) + layout_.source;
  }
  ETENDUE_KERNEL_MEMBER double* slot(int j) const {
    return task_.slots + static_cast<std::ptrdiff_t>(visits_[j].slot) * length();
  }
  /// The radiance behind face f.
  ETENDUE_KERNEL_MEMBER const double* behind(int j, int f) const {
    const std::uint32_t code = visits_[j].faces[f];
    // Four times the slot stands in the code as it is.
    if constexpr (basis == Basis::linear)
      return task_.slots + static_cast<std::ptrdiff_t>(code & ~opposite_bits) * task_.stride;
    return task_.slots + static_cast<std::ptrdiff_t>(unpacked(code).slot) * task_.stride;
  }
  ETENDUE_KERNEL_MEMBER double* fluence(int j) const {
    return task_.fluence + static_cast<std::ptrdiff_t>(cell_[j]) * length();
  }
  /// Kept for angular cells; the row of the others is the scratch row 0.
  ETENDUE_KERNEL_MEMBER double* radiance(int j) const {
    return task_.angular + task_.angular_index[cell_[j]] * length();
  }
  ETENDUE_KERNEL_MEMBER double* net_flux(int j) const {
    return task_.net_flux + static_cast<std::ptrdiff_t>(cell_[j]) * 3 * length();
  }

  /// Leaves one direction's radiance to the cells behind, and adds it to the sums.
  template <int B>
  ETENDUE_KERNEL_MEMBER void keep(int j, std::ptrdiff_t at, const Lanes<B>& u) const {
    const Lanes<B> weighted = task_.weight * u;
    double* sum = fluence(j) + at;
    store_lanes<B>(slot(j) + at, u);
    store_lanes<B>(sum, load_lanes<B>(sum) + weighted);
    if constexpr (angular == Angular::present) store_lanes<B>(radiance(j) + at, u);
    if constexpr (flux == Flux::add)
      for (int axis = 0; axis < 3; ++axis) {
        double* flow = net_flux(j) + axis * length() + at;
        store_lanes<B>(flow, load_lanes<B>(flow) + task_.direction[axis] * weighted);
      }
  }

  /// Gives all values of the packet a sign. An idle cell is dark.
  template <int B>
  ETENDUE_KERNEL_MEMBER void keep_positive(const Lanes<C * B> (&weights)[4], const Lanes<C * B>& balance,
                                           std::ptrdiff_t band, Lanes<C * B> (&u)[4]) const {
    for (int j = 0; j < C; ++j)
      for (int b = 0; b < B; ++b) {
        const int lane = j * B + b;
        double values[4] = {u[0][lane], u[1][lane], u[2][lane], u[3][lane]};
        if (values[0] >= 0 && values[1] >= 0 && values[2] >= 0 && values[3] >= 0) continue;
        const double own[4] = {weights[0][lane], weights[1][lane], weights[2][lane], weights[3][lane]};
        fix_values(task_.fixup, own, balance[lane], task_.volumes[cell_[j]], values, task_.census[band + b]);
        for (int i = 0; i < 4; ++i) u[i][lane] = values[i];
      }
  }

 private:
  const SweepTask& task_;
  const RecordLayout& layout_;
  const SweepVisit* visits_;
  std::size_t cell_[C];
};

/// The seen areas of all faces; exactly zero on parallel ones, whichever side looks.
template <int C, int B, class Cells>
ETENDUE_KERNEL_INLINE FaceFlows<Lanes<C * B>> seen_faces(const SweepTask& task, const Cells& packet) {
  Lanes<4> seen[C];
  std::uint32_t parallel = 0;
  ETENDUE_UNROLL
  for (int j = 0; j < C; ++j) {
    const double* normals = packet.record(j);
    seen[j] = (task.direction[0] * load_lanes<4>(normals) + task.direction[1] * load_lanes<4>(normals + 3)) +
              task.direction[2] * load_lanes<4>(normals + 6);
    parallel |= packet.visit(j).cell_and_parallel;
  }
  Lanes<C * B> a[4];
  spread_rows<C, B>(seen, a);
  a[3] = -((a[0] + a[1]) + a[2]);
  if (parallel >> visit_cell_bits != 0) [[unlikely]] {
    for (int f = 0; f < 4; ++f) {
      LaneChoice<C * B> keep;
      for (int j = 0; j < C; ++j)
        for (int b = 0; b < B; ++b)
          keep[j * B + b] = (parallel_faces(packet.visit(j)) >> f & 1) != 0 ? 0 : -1;
      a[f] = keep != 0 ? a[f] : Lanes<C * B>{};
    }
  }
  return face_flows(a);
}

/// B neighbouring bands of each cell, from the place that `from` names for cell j.
template <int C, int B, class From>
ETENDUE_KERNEL_INLINE Lanes<C * B> gather_from(const From& from, std::ptrdiff_t at) {
  const double* place[C];
  ETENDUE_UNROLL
  for (int j = 0; j < C; ++j) place[j] = from(j);
  return gather_chunks<C, B>(place, at);
}

/// Right-hand side of the isotropic sources at the four nodes of each cell.
template <int C, int B, class Cells>
ETENDUE_KERNEL_INLINE void load_source(const Cells& packet, std::ptrdiff_t stride, std::ptrdiff_t band,
                                       Lanes<C * B> (&out)[4]) {
  if constexpr (transposes<C, B>) {
    Lanes<4> row[C];
    ETENDUE_UNROLL
    for (int j = 0; j < C; ++j) row[j] = load_lanes<4>(packet.source(j));
    Rows<C>::to_lanes(row, out);
  } else {
    ETENDUE_UNROLL
    for (int i = 0; i < 4; ++i)
      out[i] = gather_from<C, B>([&](int j) { return packet.source(j); }, i * stride + band);
  }
}

/// The nodes of the face opposite a node in the first three lanes.
alignas(32) constexpr long long face_nodes[4][4] = {{1, 2, 3, 0}, {0, 2, 3, 1}, {0, 1, 3, 2}, {0, 1, 2, 3}};

/// Radiance at the three vertices of face f, as the cells behind those faces left it. All four faces are
/// read: what is read where light leaves counts zero times, which spares every branch on the sign of a_f.
template <int C, int B, class Cells>
ETENDUE_KERNEL_INLINE void load_face(const Cells& packet, int f, std::ptrdiff_t stride, std::ptrdiff_t band,
                                     Lanes<C * B> (&out)[4]) {
  const double* radiance[C];
  const long long* nodes[C];
  ETENDUE_UNROLL
  for (int j = 0; j < C; ++j) {
    radiance[j] = packet.behind(j, f);
    nodes[j] = face_nodes[packet.visit(j).faces[f] & opposite_bits];
  }
  if constexpr (transposes<C, B>) {
    Lanes<4> row[C];
    ETENDUE_UNROLL
    for (int j = 0; j < C; ++j) {
      LaneChoice<4> choice;
      std::memcpy(&choice, nodes[j], sizeof choice);
      row[j] = __builtin_shuffle(load_lanes<4>(radiance[j]), choice);
    }
    Rows<C>::to_lanes(row, out);
  } else {
    ETENDUE_UNROLL
    for (int k = 0; k < 3; ++k)
      out[k] = gather_from<C, B>([&](int j) { return radiance[j] + nodes[j][k] * stride; }, band);
  }
}

/// Linear basis.
template <int C, int B, class Cells>
ETENDUE_KERNEL_INLINE void balance_linear(const Cells& packet, std::ptrdiff_t stride, std::ptrdiff_t mass_at,
                                          const FaceFlows<Lanes<C * B>>& flows, std::ptrdiff_t band) {
  using T = Lanes<C * B>;
  T right[4];
  load_source<C, B>(packet, stride, band, right);
  ETENDUE_UNROLL
  for (int f = 0; f < 4; ++f) {
    T inflow[4];
    load_face<C, B>(packet, f, stride, band, inflow);
    add_inflow(flows, f, inflow, right);
  }
  const T mass = gather_from<C, B>([&](int j) { return packet.record(j); }, mass_at + band);
  const T alpha_mass = mass < 0 ? -mass : mass;
  const T beta_mass = mass < 0 ? T{} : mass;
  T u[4];
  solve_cell(flows, alpha_mass, beta_mass, right, u);
  if constexpr (Cells::sign == Sign::positive) {
    T weights[4];
    balance_weights(flows, alpha_mass, beta_mass, weights);
    packet.template keep_positive<B>(weights, (right[0] + right[1]) + (right[2] + right[3]), band, u);
  }
  if constexpr (transposes<C, B>) {
    Lanes<4> row[C];
    Rows<C>::from_lanes(u, row);
    ETENDUE_UNROLL
    for (int j = 0; j < C; ++j) packet.template keep<4>(j, 0, row[j]);
  } else {
    ETENDUE_UNROLL
    for (int j = 0; j < C; ++j) {
      ETENDUE_UNROLL
      for (int i = 0; i < 4; ++i) packet.template keep<B>(j, i * stride + band, chunk<C, B>(u[i], j));
    }
  }
}

/// Piecewise constants: (sigma_t V + P) u = V q + sum of n_f u_f.
template <int C, int B, class Cells>
ETENDUE_KERNEL_INLINE void balance_constant(const Cells& packet, std::ptrdiff_t mass_at,
                                            const FaceFlows<Lanes<C * B>>& flows, std::ptrdiff_t band) {
  using T = Lanes<C * B>;
  T right = gather_from<C, B>([&](int j) { return packet.source(j); }, band);
  ETENDUE_UNROLL
  for (int f = 0; f < 4; ++f)
    right += flows.entering[f] * gather_from<C, B>([&](int j) { return packet.behind(j, f); }, band);
  const T mass = gather_from<C, B>([&](int j) { return packet.record(j); }, mass_at + band);
  const T u = right / (mass + flows.total);
  ETENDUE_UNROLL
  for (int j = 0; j < C; ++j) packet.template keep<B>(j, band, chunk<C, B>(u, j));
}

template <Basis basis, int C, int B, Angular angular, Flux flux, Sign sign>
ETENDUE_KERNEL_INLINE void balance_packet(const SweepTask& task, const RecordLayout& layout,
                                          const SweepVisit* visits) {
  const Packet<basis, C, angular, flux, sign> packet(task, layout, visits);
  const FaceFlows<Lanes<C* B>> flows = seen_faces<C, B>(task, packet);
  const auto mass = static_cast<std::ptrdiff_t>(layout.mass);
  for (std::ptrdiff_t band = 0; band < task.stride; band += B) {
    if constexpr (basis == Basis::linear) {
      balance_linear<C, B>(packet, task.stride, mass, flows, band);
    } else {
      balance_constant<C, B>(packet, mass, flows, band);
    }
  }
}

/// `Bands` is the stride where it is known when this is compiled, else 0.
template <Basis basis, int C, int B, int Bands, Angular angular, Flux flux, Sign sign>
ETENDUE_KERNEL_INLINE void sweep_cells(SweepTask task) {
  if constexpr (Bands > 0) task.stride = Bands;
  const RecordLayout layout = record_layout(basis, static_cast<int>(task.stride));
  const std::size_t length = static_cast<std::size_t>(nodes_per_cell(basis) * task.stride);
  SweepVisit idle;
  idle.cell_and_parallel = task.idle_cell;
  const std::int32_t begin = task.levels[0];
  const std::int32_t end = task.levels[task.level_count];
  for (std::int32_t l = 0; l < task.level_count; ++l) {
    const std::int32_t level = task.backwards ? task.level_count - 1 - l : l;
    const std::int32_t level_begin = task.levels[level];
    const std::int32_t level_end = task.levels[level + 1];
    for (std::int32_t done = 0; done < level_end - level_begin; done += C) {
      const std::int32_t count = level_end - level_begin - done < C ? level_end - level_begin - done : C;
      const std::int32_t position = task.backwards ? level_end - done - count : level_begin + done;
      const std::int32_t ahead = position + (task.backwards ? -prefetch_distance : prefetch_distance);
      if (ahead >= begin && ahead + C <= end) ETENDUE_UNROLL
      for (int j = 0; j < C; ++j)
        prefetch_cell<angular, flux>(task, task.visits[ahead + j], layout.length, length);
      const SweepVisit* visits = task.visits + position;
      SweepVisit filled[C];
      if (count < C) [[unlikely]] {
        for (int j = 0; j < C; ++j) filled[j] = j < count ? visits[j] : idle;
        visits = filled;
      }
      balance_packet<basis, C, B, angular, flux, sign>(task, layout, visits);
    }
  }
}

template <Basis basis, int C, int B, int Bands, Sign sign>
void sweep(const SweepTask& task) {
  const bool angular = task.angular_index != nullptr;
  const bool flux = task.net_flux != nullptr;
  if (angular && flux) {
    sweep_cells<basis, C, B, Bands, Angular::present, Flux::add, sign>(task);
  } else if (angular) {
    sweep_cells<basis, C, B, Bands, Angular::present, Flux::skip, sign>(task);
  } else if (flux) {
    sweep_cells<basis, C, B, Bands, Angular::absent, Flux::add, sign>(task);
  } else {
    sweep_cells<basis, C, B, Bands, Angular::absent, Flux::skip, sign>(task);
  }
}

/// Bands fill the lanes first, cells of one level the rest.
template <Basis basis, int Bands, Sign sign = Sign::free>
auto sweep_of_bands() {
  constexpr int lanes = ETENDUE_KERNEL_LANES;
  constexpr int B = Bands > 0 && Bands < lanes ? Bands : lanes;
  return sweep<basis, lanes / B, B, Bands, sign>;
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
  if constexpr (basis == Basis::linear)
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
  } else {
    kernels.sweep = sweep_of_bands<basis, 0>();
  }
  return kernels;
}

}  // namespace

SweepKernels ETENDUE_KERNEL_NAME(Basis basis, int stride) {
  SweepKernels kernels =
      basis == Basis::linear ? kernels_for<Basis::linear>(stride) : kernels_for<Basis::constant>(stride);
  kernels.matrix_product = matrix_product;
  kernels.instruction_set = ETENDUE_KERNEL_ISA;
  return kernels;
}

}  // namespace etendue
