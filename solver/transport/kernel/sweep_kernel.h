// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

#include "solver/transport/kernel/cell_record.h"
#include "solver/transport/kernel/sweep_visit.h"

namespace etendue {

/// What becomes of negative nodal values (positivity_fixup.h).
enum class Fixup { rescale, quadratic };

/// What the fixup met along one direction in one band.
struct FixupCensus {
  std::int64_t cells = 0;   ///< with a negative value before it
  std::int64_t failed = 0;  ///< of them without non-negative values that balance; left as they were
  double smallest = 0;      ///< value before it [power/(length^2 sr)]
  double moved = 0;         ///< integral of |change| over the cells [power length/sr]
};

/// One direction's sweep over all cells, as bare arrays: reference_sweep.h for many cells and bands at a
/// time. `stride` is the number of bands rounded up to whole lanes; in all arrays the band is the fastest
/// index. Per-cell arrays end with one padding cell, the idle cell, that fills up incomplete packets (its
/// record has a mass and nothing else).
template <class Real>
struct SweepTaskOf {
  const SweepVisit* visits = nullptr;    ///< [position]
  const std::int32_t* levels = nullptr;  ///< [level + 1] first position, and the end, of the levels to sweep
  std::int32_t level_count = 0;
  std::uint32_t idle_cell = 0;  ///< the number of cells
  bool backwards = false;       ///< walk the positions from the last to the first
  Real direction[3] = {};
  Real weight = 0;                ///< [sr]
  std::ptrdiff_t stride = 1;      ///< bands, rounded up to lanes
  const Real* records = nullptr;  ///< [cell][record length] cell_record.h
  Real* slots = nullptr;          ///< [slot][node][stride] radiance
  bool fetches_slots = false;     ///< because they do not stay in the cache
  Real* fluence = nullptr;        ///< [cell][node][stride] += weight u
  const std::int32_t* angular_index =
      nullptr;               ///< [cell] row in `angular`; 0, a scratch row, without; null: no cell has one
  Real* angular = nullptr;   ///< [row][node][stride] in: right-hand side of this direction; out: radiance
  Real* net_flux = nullptr;  ///< [cell][3][node][stride] += weight direction u; null: not wanted
  const double* volumes = nullptr;  ///< [cell] [length^3]; of sweep_positive
  Fixup fixup = Fixup::rescale;     ///< of sweep_positive
  FixupCensus* census = nullptr;    ///< [band, padded]; of sweep_positive
};

using SweepTask = SweepTaskOf<double>;

/// A small dense product between moments and directions, row by row, for the angular cells. Directions come
/// in orbits (moment_orbits.h): harmonics of one class have the same values but for known signs at all
/// directions of an orbit, so that sums over a class serve all of them.
template <class Real>
struct MomentTaskOf {
  std::size_t row_length = 0;  ///< numbers of one row: nodes times stride
  int moments = 0;
  int orbit_size = 2;                ///< 2 or 8
  const int* class_begin = nullptr;  ///< [class], and the end: places in `order`
  const int* order = nullptr;        ///< the moments, class by class
  int orbits = 0;
  const Real* matrix = nullptr;           ///< [moment, in that order][orbit] at its first direction
  Real* moment_rows = nullptr;            ///< [row][moment][row_length]
  Real* const* direction_rows = nullptr;  ///< [orbit][direction] -> [row][row_length]
  std::size_t first_row = 0;              ///< work on rows first_row … last_row - 1
  std::size_t last_row = 0;
};

using MomentTask = MomentTaskOf<double>;

/// Columns of a product that are worked on at a time.
inline constexpr std::size_t product_lanes = 64;

/// result = matrix factor, with product_lanes columns; all row by row.
struct ProductTask {
  int rows = 0;
  int inner = 0;
  const double* matrix = nullptr;  ///< [row][inner]
  const double* factor = nullptr;  ///< [inner][product_lanes]
  double* result = nullptr;        ///< [row][product_lanes]
};

using MatrixProduct = void (*)(const ProductTask&);

/// The kernels compiled for one instruction set, and for double or float.
template <class Real>
struct SweepKernelsOf {
  void (*sweep)(const SweepTaskOf<Real>&) = nullptr;
  /// The same where the bands 2 p and 2 p + 1 are the real and the imaginary part of one radiance, and of the
  /// mass of a cell (cell_record.h).
  void (*sweep_complex)(const SweepTaskOf<Real>&) = nullptr;
  /// The same with non-negative values in every cell; null for constant elements, which have them
  /// anyway, and in single precision.
  void (*sweep_positive)(const SweepTaskOf<Real>&) = nullptr;
  /// direction_rows = matrix moment_rows
  void (*moments_to_directions)(const MomentTaskOf<Real>&) = nullptr;
  /// moment_rows += matrix^T direction_rows
  void (*directions_to_moments)(const MomentTaskOf<Real>&) = nullptr;
  /// In double precision whatever the sweep has.
  MatrixProduct matrix_product = nullptr;
  const char* instruction_set = "";
};

using SweepKernels = SweepKernelsOf<double>;

/// Bands rounded up to the lanes that the kernels compute side by side.
int lane_stride(int bands);

/// Whether some kernels leave out the faces of a cell through which no light enters, with so many bands.
bool skips_faces(int stride);

/// The kernels for this machine: the widest instruction set that it has, or the one that the environment
/// variable ETENDUE_ISA names (baseline, avx2, avx512). Throws InputError where that is unknown or missing
/// here.
template <class Real = double>
SweepKernelsOf<Real> choose_kernels(Basis basis, int stride);

}  // namespace etendue
