// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

namespace etendue {

/// Polynomial space of the kernel.
enum class Basis { constant, linear };

constexpr int nodes_per_cell(Basis basis) { return basis == Basis::linear ? 4 : 1; }
constexpr int nodes_per_face(Basis basis) { return basis == Basis::linear ? 3 : 1; }

/// Doubles from one cell's outward area normals [4][3] to the next; a record fills two cache lines.
inline constexpr std::size_t normals_stride = 16;

/// One direction's sweep over all cells, as bare arrays. `stride` is the number of bands rounded up to whole
/// lanes; in all arrays the band is the fastest index. Right-hand sides are multiplied by 12 (linear basis).
struct SweepTask {
  std::int32_t cell_count = 0;
  const std::int32_t* cells = nullptr;  ///< [position] cell
  const std::int32_t* slots = nullptr;  ///< [position][4]
  bool backwards = false;               ///< walk the positions from the last to the first
  double direction[3] = {};
  double weight = 0;                ///< [sr]
  std::ptrdiff_t stride = 1;        ///< bands, rounded up to lanes
  const double* normals = nullptr;  ///< [cell][4][3] padded to normals_stride [length^2]
  const double* mass = nullptr;     ///< [cell][2][stride] alpha_mass, beta_mass (cell_balance.h)
  const double* source = nullptr;   ///< [cell][node][stride] right-hand side of isotropic sources
  const std::int32_t* angular_index =
      nullptr;                 ///< [cell] row in `angular`; 0, a scratch row, without; null: no cell has one
  double* angular = nullptr;   ///< [row][node][stride] in: right-hand side of this direction; out: radiance
  double* traces = nullptr;    ///< [slot][face node][stride] radiance on faces
  double* fluence = nullptr;   ///< [cell][node][stride] += weight u
  double* net_flux = nullptr;  ///< [cell][3][node][stride] += weight direction u; null: not wanted
};

/// A small dense product between moments and directions, row by row, for the angular cells.
struct MomentTask {
  std::size_t row_length = 0;  ///< doubles of one row: nodes times stride
  int moments = 0;
  int directions = 0;
  const double* matrix = nullptr;           ///< [direction][moment]
  double* moment_rows = nullptr;            ///< [row][moment][row_length]
  double* const* direction_rows = nullptr;  ///< [direction] -> [row][row_length]
  std::size_t first_row = 0;                ///< work on rows first_row … last_row - 1
  std::size_t last_row = 0;
};

/// The kernels compiled for one instruction set.
struct SweepKernels {
  void (*sweep)(const SweepTask&) = nullptr;
  /// direction_rows = matrix moment_rows
  void (*moments_to_directions)(const MomentTask&) = nullptr;
  /// moment_rows += matrix^T direction_rows
  void (*directions_to_moments)(const MomentTask&) = nullptr;
  const char* instruction_set = "";
};

/// Bands rounded up to the lanes that the kernels compute side by side.
int lane_stride(int bands);

/// The kernels for this machine: the widest instruction set that it has, or the one that the environment
/// variable ETENDUE_ISA names (baseline, avx2, avx512). Throws InputError where that is unknown or missing
/// here.
SweepKernels choose_kernels(Basis basis, int stride);

}  // namespace etendue
