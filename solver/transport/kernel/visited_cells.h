// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

// For the kernel files only.
#include <cstddef>
#include <cstdint>

#include "solver/transport/kernel/packet.h"
#include "solver/transport/kernel/positivity_fixup.h"
#include "solver/transport/kernel/sweep_kernel.h"

namespace etendue {
namespace {

/// Cells ahead whose data are asked for: about the latency of memory over the time of a cell.
constexpr std::int32_t prefetch_distance = 16;
/// The same of the order itself, which says where they are.
constexpr std::int32_t order_distance = 64;

/// Whether the task has angular cells, whether it adds up the net flux, and whether it keeps values positive.
enum class Angular { absent, present };
enum class Flux { skip, add };
enum class Sign { free, positive };

/// Into the first level of the cache, or into the second beside it, for reading or for writing.
enum class Fetch { first_read, first_write, second };

template <Fetch fetch>
ETENDUE_KERNEL_INLINE void prefetch_lines(const Real* from, std::size_t length) {
  constexpr std::size_t line = 64 / sizeof(Real);
  for (std::size_t i = 0; i < length; i += line)
    if constexpr (fetch == Fetch::second) {
      __builtin_prefetch(from + i, 0, 2);
    } else {
      __builtin_prefetch(from + i, fetch == Fetch::first_write ? 1 : 0);
    }
}

/// What passes once and what is added to. With one band the first level is left to the slots, and with
/// sixteen doubles it cannot hold what is asked for ahead.
ETENDUE_KERNEL_INLINE void prefetch_passing(const SweepTaskOf<Real>& task, const Real* read,
                                            std::size_t read_length, const Real* added,
                                            std::size_t added_length) {
  if (task.stride == 1 || static_cast<std::size_t>(task.stride) * sizeof(Real) >= 128) {
    prefetch_lines<Fetch::second>(read, read_length);
    prefetch_lines<Fetch::second>(added, added_length);
  } else {
    prefetch_lines<Fetch::first_read>(read, read_length);
    prefetch_lines<Fetch::first_write>(added, added_length);
  }
}

/// `length` is that of a cell's radiance.
template <Angular angular, Flux flux>
ETENDUE_KERNEL_INLINE void prefetch_cell(const SweepTaskOf<Real>& task, const SweepVisit& visit,
                                         std::size_t record_length, std::size_t length) {
  const std::size_t cell = visited_cell(visit);
  prefetch_passing(task, task.records + cell * record_length, record_length, task.fluence + cell * length,
                   length);
  if (task.fetches_slots) {
    prefetch_lines<Fetch::first_write>(task.slots + visit.slot * length, length);
    ETENDUE_UNROLL
    for (int f = 0; f < 4; ++f)
      prefetch_lines<Fetch::first_read>(task.slots + unpacked(visit.faces[f]).slot * length, length);
  }
  if constexpr (angular == Angular::present)
    prefetch_lines<Fetch::first_write>(
        task.angular + static_cast<std::size_t>(task.angular_index[cell]) * length, length);
  if constexpr (flux == Flux::add)
    prefetch_lines<Fetch::first_write>(task.net_flux + cell * 3 * length, 3 * length);
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

  ETENDUE_KERNEL_MEMBER Packet(const SweepTaskOf<Real>& task, const RecordLayout& layout,
                               const SweepVisit* visits)
      : task_(task), layout_(layout), visits_(visits) {
    ETENDUE_UNROLL
    for (int j = 0; j < C; ++j) cell_[j] = visited_cell(visits[j]);
  }

  ETENDUE_KERNEL_MEMBER std::ptrdiff_t length() const { return nodes_per_cell(basis) * task_.stride; }
  ETENDUE_KERNEL_MEMBER const SweepVisit& visit(int j) const { return visits_[j]; }
  ETENDUE_KERNEL_MEMBER const Real* record(int j) const { return task_.records + cell_[j] * layout_.length; }
  ETENDUE_KERNEL_MEMBER const Real* source(int j) const {
    if constexpr (angular == Angular::present)
      if (task_.angular_index[cell_[j]] > 0) return radiance(j);
    return record(j) + layout_.source;
  }
  ETENDUE_KERNEL_MEMBER Real* slot(int j) const {
    return task_.slots + static_cast<std::ptrdiff_t>(visits_[j].slot) * length();
  }
  /// The radiance behind face f.
  ETENDUE_KERNEL_MEMBER const Real* behind(int j, int f) const {
    const std::uint32_t code = visits_[j].faces[f];
    // The code contains four times the slot as it is.
    if constexpr (basis == Basis::linear)
      return task_.slots + static_cast<std::ptrdiff_t>(code & ~opposite_bits) * task_.stride;
    return task_.slots + static_cast<std::ptrdiff_t>(unpacked(code).slot) * task_.stride;
  }
  ETENDUE_KERNEL_MEMBER Real* fluence(int j) const {
    return task_.fluence + static_cast<std::ptrdiff_t>(cell_[j]) * length();
  }
  /// Kept for angular cells; the row of the others is the scratch row 0.
  ETENDUE_KERNEL_MEMBER Real* radiance(int j) const {
    return task_.angular + task_.angular_index[cell_[j]] * length();
  }
  ETENDUE_KERNEL_MEMBER Real* net_flux(int j) const {
    return task_.net_flux + static_cast<std::ptrdiff_t>(cell_[j]) * 3 * length();
  }

  /// Leaves one direction's radiance to the cells behind, and adds it to the sums.
  template <int B>
  ETENDUE_KERNEL_MEMBER void keep(int j, std::ptrdiff_t at, const Lanes<B>& u) const {
    const Lanes<B> weighted = task_.weight * u;
    Real* sum = fluence(j) + at;
    store_lanes<B>(slot(j) + at, u);
    store_lanes<B>(sum, load_lanes<B>(sum) + weighted);
    if constexpr (angular == Angular::present) store_lanes<B>(radiance(j) + at, u);
    if constexpr (flux == Flux::add)
      for (int axis = 0; axis < 3; ++axis) {
        Real* flow = net_flux(j) + axis * length() + at;
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
        for (int i = 0; i < 4; ++i) u[i][lane] = static_cast<Real>(values[i]);
      }
  }

 private:
  const SweepTaskOf<Real>& task_;
  const RecordLayout& layout_;
  const SweepVisit* visits_;
  std::size_t cell_[C];
};

}  // namespace
}  // namespace etendue
