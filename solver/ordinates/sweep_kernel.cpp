// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Compiled once for each instruction set, with ETENDUE_KERNEL_NAME naming the one function that is visible.
// Nothing in here may come from a header that other files share as code (lanes.h says why).
#include "solver/ordinates/sweep_kernel.h"

#include "solver/ordinates/cell_balance.h"
#include "solver/ordinates/lanes.h"

namespace etendue {
namespace {

/// Cells ahead whose data are asked for: about the latency of memory over the time of a cell.
constexpr int prefetch_distance = 10;

/// Whether the task has angular cells, and whether it adds up the net flux.
enum class Angular { absent, present };
enum class Flux { skip, add };

ETENDUE_KERNEL_INLINE void prefetch(const double* from, std::ptrdiff_t doubles, int rw) {
  for (std::ptrdiff_t i = 0; i < doubles; i += 8) {
    if (rw) {
      __builtin_prefetch(from + i, 1);
    } else {
      __builtin_prefetch(from + i, 0);
    }
  }
}

template <int Nodes, Flux flux>
ETENDUE_KERNEL_INLINE void prefetch_cell(const SweepTask& task, std::size_t cell) {
  const std::ptrdiff_t length = Nodes * task.stride;
  prefetch(task.normals + cell * normals_stride, 12, 0);
  prefetch(task.mass + cell * 2 * static_cast<std::size_t>(task.stride), 2 * task.stride, 0);
  prefetch(task.source + cell * static_cast<std::size_t>(length), length, 0);
  prefetch(task.fluence + cell * static_cast<std::size_t>(length), length, 1);
  if constexpr (flux == Flux::add)
    prefetch(task.net_flux + cell * 3 * static_cast<std::size_t>(length), 3 * length, 1);
}

/// Four seen areas; exactly zero on parallel faces, whichever side looks.
ETENDUE_KERNEL_INLINE void seen_areas(const SweepTask& task, const double* normals, const std::int32_t* slots,
                                      double (&a)[4]) {
  for (std::ptrdiff_t f = 0; f < 4; ++f) {
    const double seen = (task.direction[0] * normals[3 * f] + task.direction[1] * normals[3 * f + 1]) +
                        task.direction[2] * normals[3 * f + 2];
    a[f] = slots[f] == 0 ? 0 : seen;
  }
}

/// Where a cell's own values are read and written.
struct CellRows {
  const double* mass;
  const double* source;
  double* radiance;  ///< kept for angular cells, else a scratch row
  double* fluence;
  double* net_flux;
  double* trace[4];
};

/// Linear basis, W bands at once. All four slots are read and all are written: what is read on faces where
/// light leaves counts zero times, and what is written where it entered has been read for the last time.
/// That spares every branch on the sign of a_f.
template <int W, Angular angular, Flux flux>
ETENDUE_KERNEL_INLINE void balance_linear(const SweepTask& task, const FaceFlows& flows, const CellRows& rows,
                                          std::ptrdiff_t band) {
  using T = Lanes<W>;
  const std::ptrdiff_t stride = task.stride;
  T right[4];
  for (int i = 0; i < 4; ++i) right[i] = load_lanes<W>(rows.source + i * stride + band);
  for (int f = 0; f < 4; ++f) {
    T inflow[3];
    for (int k = 0; k < 3; ++k) inflow[k] = load_lanes<W>(rows.trace[f] + k * stride + band);
    add_inflow(flows, f, inflow, right);
  }
  const T alpha_mass = load_lanes<W>(rows.mass + band);
  const T beta_mass = load_lanes<W>(rows.mass + stride + band);
  T u[4];
  solve_cell(flows, alpha_mass, beta_mass, right, u);
  for (int f = 0; f < 4; ++f) {
    std::ptrdiff_t corner = 0;
    for (int i = 0; i < 4; ++i)
      if (i != f) store_lanes<W>(rows.trace[f] + stride * corner++ + band, u[i]);
  }
  for (int i = 0; i < 4; ++i) {
    const std::ptrdiff_t at = i * stride + band;
    const T weighted = task.weight * u[i];
    store_lanes<W>(rows.fluence + at, load_lanes<W>(rows.fluence + at) + weighted);
    if constexpr (angular == Angular::present) store_lanes<W>(rows.radiance + at, u[i]);
    if constexpr (flux == Flux::add)
      for (int axis = 0; axis < 3; ++axis) {
        double* sum = rows.net_flux + axis * 4 * stride + at;
        store_lanes<W>(sum, load_lanes<W>(sum) + task.direction[axis] * weighted);
      }
  }
}

/// Piecewise constants: (sigma_t V + P) u = V q + sum of n_f u_f.
template <int W, Angular angular, Flux flux>
ETENDUE_KERNEL_INLINE void balance_constant(const SweepTask& task, const FaceFlows& flows,
                                            const CellRows& rows, std::ptrdiff_t band) {
  using T = Lanes<W>;
  T right = load_lanes<W>(rows.source + band);
  for (int f = 0; f < 4; ++f) right += flows.entering[f] * load_lanes<W>(rows.trace[f] + band);
  const T u = right / (load_lanes<W>(rows.mass + band) + flows.total);
  for (int f = 0; f < 4; ++f) store_lanes<W>(rows.trace[f] + band, u);
  const T weighted = task.weight * u;
  store_lanes<W>(rows.fluence + band, load_lanes<W>(rows.fluence + band) + weighted);
  if constexpr (angular == Angular::present) store_lanes<W>(rows.radiance + band, u);
  if constexpr (flux == Flux::add)
    for (int axis = 0; axis < 3; ++axis) {
      double* sum = rows.net_flux + axis * task.stride + band;
      store_lanes<W>(sum, load_lanes<W>(sum) + task.direction[axis] * weighted);
    }
}

/// `Bands` is the stride where it is known when this is compiled, else 0.
template <Basis basis, int W, int Bands, Angular angular, Flux flux>
ETENDUE_KERNEL_INLINE void sweep_cells(SweepTask task) {
  constexpr int nodes = nodes_per_cell(basis);
  constexpr int face_nodes = nodes_per_face(basis);
  if constexpr (Bands > 0) task.stride = Bands;
  const std::ptrdiff_t stride = task.stride;
  const std::size_t length = static_cast<std::size_t>(nodes * stride);
  const std::size_t trace_length = static_cast<std::size_t>(face_nodes * stride);
  const std::int32_t count = task.cell_count;
  const std::int32_t step = task.backwards ? -1 : 1;
  std::int32_t position = task.backwards ? count - 1 : 0;
  for (std::int32_t done = 0; done < count; ++done, position += step) {
    if (done + prefetch_distance < count)
      prefetch_cell<nodes, flux>(task,
                                 static_cast<std::size_t>(task.cells[position + step * prefetch_distance]));
    const std::size_t cell = static_cast<std::size_t>(task.cells[position]);
    const std::int32_t* slots = task.slots + 4 * static_cast<std::ptrdiff_t>(position);
    double a[4];
    seen_areas(task, task.normals + cell * normals_stride, slots, a);
    const FaceFlows flows = face_flows(a);

    CellRows rows;
    rows.mass = task.mass + cell * 2 * static_cast<std::size_t>(stride);
    rows.source = task.source + cell * length;
    rows.radiance = nullptr;
    if constexpr (angular == Angular::present) {
      // The row of a cell without angular source is the scratch row 0.
      const std::int32_t row = task.angular_index[cell];
      rows.radiance = task.angular + static_cast<std::size_t>(row) * length;
      if (row > 0) rows.source = rows.radiance;
    }
    rows.fluence = task.fluence + cell * length;
    rows.net_flux = flux == Flux::add ? task.net_flux + cell * 3 * length : nullptr;
    for (int f = 0; f < 4; ++f)
      rows.trace[f] = task.traces + static_cast<std::size_t>(slots[f]) * trace_length;

    for (std::ptrdiff_t band = 0; band < stride; band += W) {
      if constexpr (basis == Basis::linear) {
        balance_linear<W, angular, flux>(task, flows, rows, band);
      } else {
        balance_constant<W, angular, flux>(task, flows, rows, band);
      }
    }
  }
}

template <Basis basis, int W, int Bands>
void sweep(const SweepTask& task) {
  const bool angular = task.angular_index != nullptr;
  const bool flux = task.net_flux != nullptr;
  if (angular && flux) {
    sweep_cells<basis, W, Bands, Angular::present, Flux::add>(task);
  } else if (angular) {
    sweep_cells<basis, W, Bands, Angular::present, Flux::skip>(task);
  } else if (flux) {
    sweep_cells<basis, W, Bands, Angular::absent, Flux::add>(task);
  } else {
    sweep_cells<basis, W, Bands, Angular::absent, Flux::skip>(task);
  }
}

/// Sums that are kept in registers while their factors run by.
constexpr int moment_block = 4;

/// Directions first … first + Count - 1 of one row, W numbers of it, from all its moments.
template <int W, int Count>
ETENDUE_KERNEL_INLINE void expand_block(const MomentTask& task, const double* moments, std::size_t at,
                                        int first) {
  Lanes<W> sum[Count] = {};
  for (int k = 0; k < task.moments; ++k) {
    const Lanes<W> moment = load_lanes<W>(moments + static_cast<std::size_t>(k) * task.row_length);
    for (int m = 0; m < Count; ++m)
      sum[m] += task.matrix[static_cast<std::ptrdiff_t>(first + m) * task.moments + k] * moment;
  }
  for (int m = 0; m < Count; ++m) store_lanes<W>(task.direction_rows[first + m] + at, sum[m]);
}

/// Moments first … first + Count - 1 of one row, W numbers of it, gain from all directions.
template <int W, int Count>
ETENDUE_KERNEL_INLINE void collect_block(const MomentTask& task, double* moments, std::size_t at, int first) {
  Lanes<W> sum[Count];
  for (int k = 0; k < Count; ++k)
    sum[k] = load_lanes<W>(moments + static_cast<std::size_t>(first + k) * task.row_length);
  for (int m = 0; m < task.directions; ++m) {
    const Lanes<W> radiance = load_lanes<W>(task.direction_rows[m] + at);
    for (int k = 0; k < Count; ++k)
      sum[k] += task.matrix[static_cast<std::ptrdiff_t>(m) * task.moments + first + k] * radiance;
  }
  for (int k = 0; k < Count; ++k)
    store_lanes<W>(moments + static_cast<std::size_t>(first + k) * task.row_length, sum[k]);
}

template <int W>
void moments_to_directions(const MomentTask& task) {
  for (std::size_t row = task.first_row; row < task.last_row; ++row)
    for (std::size_t x = 0; x < task.row_length; x += W) {
      const double* moments =
          task.moment_rows + row * static_cast<std::size_t>(task.moments) * task.row_length + x;
      const std::size_t at = row * task.row_length + x;
      int m = 0;
      for (; m + moment_block <= task.directions; m += moment_block)
        expand_block<W, moment_block>(task, moments, at, m);
      for (; m < task.directions; ++m) expand_block<W, 1>(task, moments, at, m);
    }
}

template <int W>
void directions_to_moments(const MomentTask& task) {
  for (std::size_t row = task.first_row; row < task.last_row; ++row)
    for (std::size_t x = 0; x < task.row_length; x += W) {
      double* moments = task.moment_rows + row * static_cast<std::size_t>(task.moments) * task.row_length + x;
      const std::size_t at = row * task.row_length + x;
      int k = 0;
      for (; k + moment_block <= task.moments; k += moment_block)
        collect_block<W, moment_block>(task, moments, at, k);
      for (; k < task.moments; ++k) collect_block<W, 1>(task, moments, at, k);
    }
}

template <int W>
void set_moment_kernels(SweepKernels& kernels) {
  kernels.moments_to_directions = moments_to_directions<W>;
  kernels.directions_to_moments = directions_to_moments<W>;
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
    kernels.sweep = sweep<basis, 1, 1>;
  } else if (stride == 2) {
    kernels.sweep = sweep<basis, 2, 2>;
  } else if (stride == 4) {
    kernels.sweep = sweep<basis, 4, 4>;
  } else if (stride == 8) {
    kernels.sweep = sweep<basis, 8, 8>;
  } else {
    kernels.sweep = sweep<basis, 8, 0>;
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
