// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "solver/solution/saved_state.h"

namespace etendue {

/// How the iteration of one band ended.
struct BandConvergence {
  int sweeps = 0;       ///< transport sweeps that this band took part in: not those after it is done
  double residual = 0;  ///< estimated relative error of the iteration
  bool converged = false;
};

/// One line of the iteration's history.
struct HistoryEntry {
  int sweep = 0;
  int band = 0;
  double residual = 0;
};

/// Nodal values of the fluence below zero in one band.
struct NegativeCensus {
  long count = 0;       ///< of 4 values in each cell
  double smallest = 0;  ///< [power/length^2]
};

/// What keeping values positive met along one direction in one band, in the last sweep.
struct OrdinateFixup {
  int ordinate = 0;
  int band = 0;
  std::array<double, 3> direction = {};
  double weight = 0;        ///< [sr]
  std::int64_t cells = 0;   ///< where a value was negative before
  std::int64_t failed = 0;  ///< of them where no values balance without negative ones: they stayed negative
  double smallest = 0;      ///< value before [power/(length^2 sr)]
  double moved = 0;         ///< integral of |change| over the volume [power length/sr]
};

/// The same over all directions.
struct FixupTotal {
  std::int64_t cells = 0;   ///< pairs of a cell and a direction
  std::int64_t failed = 0;  ///< of them
  double smallest = 0;      ///< [power/(length^2 sr)]
  double moved = 0;         ///< [power length], as the integral of the fluence
};

/// What scattering in one medium and band became on the direction set.
struct KernelReport {
  std::string medium;
  std::string band;
  double asymmetry = 0;         ///< mean cosine of the discrete kernel, of what scatters of isotropic light
  double energy_error = 0;      ///< largest |row sum - 1|, of a matrix see DenseAccuracy
  std::string backend;          ///< e.g. "moments, degree 5 (…)"
  std::string phase = {};       ///< the phase function's name
  double smallest = 0;          ///< value of the kernel where it is negative, relative to its mean; else 0
  double negative_share = 0;    ///< integral of |negative values| over that of all
  double smallest_forward = 0;  ///< over the directions: part of the scattered light that goes on straight
  double largest_forward = 0;   ///< ahead and is not counted as scattered
  double momentum_error = 0;    ///< of a matrix: see DenseAccuracy
  double reciprocity_error = 0;
  double integral_error = 0;  ///< of a formula: by how much of itself its integral may be off
};

/// What a formula's integral may be off by without a warning.
inline constexpr double unremarkable_integral_error = 1e-6;

/// Wall-clock seconds of the stages of a solution.
struct SolveSeconds {
  double orders = 0;
  double sweep = 0;
  double low_order = 0;
  double low_order_setup = 0;  ///< the part of low_order that is done once
  double lights = 0;
  double setup = 0;  ///< before the first sweep: coefficients, scattering, memory; without the orders
};

/// The radiance of one ordinate, kept on request.
struct OrdinateRadiance {
  int ordinate = 0;
  std::vector<double> values;  ///< [cell][4][band] [power/(length^2 sr)]
};

/// Powers of light before its first collision: sent = absorbed + collided + reflected + kept.
struct UncollidedBalance {
  double sent = 0;
  double absorbed = 0;   ///< in the media
  double collided = 0;   ///< scattered for the first time
  double reflected = 0;  ///< diffusely by walls, for the first time
  double kept = 0;       ///< by walls, what leaves the domain included
  double residual = 0;   ///< what the cells miss of it, relative
};

/// The part of a solution that was integrated along rays from the lights; empty without any.
struct UncollidedPart {
  std::vector<double> fluence;                  ///< [cell][4][band] included in that of the solution
  std::vector<double> net_flux;                 ///< [cell][4][3][band] included in that of the solution
  std::vector<UncollidedBalance> balance;       ///< [band]
  std::vector<char> exact_walls;                ///< [wall] whether its radiance L was sent as pi L A
  std::vector<std::vector<double>> from_walls;  ///< [wall][band] what lights send through walls [power]
  std::vector<double> inside;                   ///< [band] of lights that are neither media nor walls [power]
};

/// What is emitted by media and walls that emit differently in different directions; empty without any.
struct DirectionalPowers {
  std::vector<std::vector<double>> regions;  ///< [region][band] [power]
  std::vector<std::vector<double>> walls;    ///< [wall][band] [power]
};

/// A solution of a Problem, whatever method found it. Fields have four values in each cell, at its vertices
/// in their order, and jump between cells; walls have three in each boundary face.
struct Solution {
  std::string method;  ///< "source-iteration", …
  int directions = 0;
  std::vector<double> fluence;     ///< [cell][4][band] [power/length^2]
  std::vector<double> net_flux;    ///< [cell][4][3 (x, y, z)][band] [power/length^2]
  std::vector<double> irradiance;  ///< [boundary face][3][band] arriving at the wall [power/length^2]
  std::vector<double> exitance;    ///< [boundary face][3][band] sent into the domain [power/length^2]
  /// [cell][band] absorbed in the mean over the cell [power/length^3] where absorption depends on the
  /// direction; empty where it is absorption times fluence everywhere.
  std::vector<double> absorbed;
  std::vector<double>
      half_range;  ///< [boundary face] discrete half range [sr], of what enters where a wall refracts
  std::vector<OrdinateRadiance> radiance;
  SavedState state;                         ///< from which another run may go on
  std::vector<std::int32_t> angular_cells;  ///< whose moments the state has, in their order
  /// [cell][band] standard error of the cell's mean fluence, a mean over rotated sets [power/length^2]; empty
  /// with one set.
  std::vector<double> direction_error;
  std::vector<double> meters;  ///< [meter][band] irradiance [power/length^2]
  /// [paired source][band] the sum over m of w_m <s_m, u_-m>, u_-m the radiance against direction m: of the
  /// source over the volume, and of |w.n| times the inflow over the walls.
  std::vector<double> source_products;
  std::vector<BandConvergence> convergence;  ///< [band]
  std::vector<HistoryEntry> history;
  UncollidedPart lights;
  DirectionalPowers by_direction;
  std::vector<NegativeCensus> negative;  ///< [band]
  std::vector<OrdinateFixup> fixups;     ///< [ordinate][band]; empty where nothing was kept positive
  std::vector<KernelReport> kernels;
  std::vector<std::string> notes;  ///< choices that were made and their reasons, a line each
  SolveSeconds seconds;
  int lagged_faces = 0;   ///< over all directions, where the sweep order had to break cycles
  double sweep_cost = 0;  ///< processor time per cell, direction and band, mean over the sweeps [ns]
  bool interrupted = false;

  bool converged() const {
    for (const BandConvergence& band : convergence)
      if (!band.converged) return false;
    return !interrupted;
  }
};

/// [band], of a fluence [cell][4][band].
std::vector<NegativeCensus> negative_census(const std::vector<double>& fluence, std::size_t bands);

/// [band]; empty where nothing was kept positive.
std::vector<FixupTotal> fixup_totals(const Solution& solution);

}  // namespace etendue
