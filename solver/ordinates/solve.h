// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "mesh/tetrahedra/cell_locator.h"
#include "solver/angle/direction_set.h"
#include "solver/ordinates/saved_state.h"
#include "solver/ordinates/solution.h"
#include "solver/problem/problem.h"

namespace etendue {

/// Polynomial degree of the discontinuous Galerkin space.
enum class SpaceOrder { constant = 0, linear = 1 };

/// How the equations are iterated; automatic: GMRES.
enum class Method { automatic, gmres, source_iteration };

/// The numbers that sweeps compute with. Mixed: float within the cycles of GMRES, double where they begin and
/// end, so that the residual that is judged, and the solution, are those of double.
enum class Precision { full, mixed };

/// What speeds the iteration up; automatic: diffusion with GMRES where it pays. With none diffusion still
/// judges the error where residuals could not.
enum class Acceleration { automatic, diffusion, none };

/// Which diffusion coefficient the acceleration takes; automatic: non-local where a void is present or
/// extinctions differ by more than a factor of 100.
enum class DiffusionLength { automatic, local, nonlocal };

/// Lumping of the mass matrix: in no cell, in all, or where extinction times cell size exceeds 2.
enum class Lumping { none, mass, automatic };

/// Whether negative radiance is taken out of every cell, keeping its balance: by setting it to zero and
/// rescaling the rest, or by the nearest values that are not negative. A stage after the linear solution.
enum class Positivity { none, rescale, quadratic };

/// An irradiance meter at a point inside: light that falls on the side its normal points to (w.n < 0).
struct IrradianceMeter {
  std::vector<CellPoint> cells;  ///< where the point lies, from CellLocator::find; values are volume-weighted
  Vec3 normal = Vec3::UnitZ();   ///< unit
};

class AngularInput;

struct SolveOptions {
  SpaceOrder order = SpaceOrder::linear;
  Lumping lumping = Lumping::automatic;
  Positivity positivity = Positivity::none;
  Method method = Method::automatic;
  Precision precision = Precision::full;  ///< of GMRES; other methods know only full
  Acceleration acceleration = Acceleration::automatic;
  DiffusionLength diffusion_length = DiffusionLength::automatic;
  double tolerance = 1e-6;  ///< estimated relative error of the iteration, per band
  int max_sweeps = 500;
  int threads = 0;                                  ///< 0: all cores
  std::size_t order_memory = std::size_t{2} << 30;  ///< bytes that sweep orders may take; beyond, recomputed
  /// What a third-level cache may hold of a sweep [bytes]; with more, neighbouring ordinates go through the
  /// mesh together, tile by tile.
  std::size_t cache_bytes = std::size_t{16} << 20;
  std::vector<int> keep_ordinates;      ///< whose radiance the solution keeps
  std::vector<IrradianceMeter> meters;  ///< read while sweeping: the angular solution is not kept
  /// Source and inflow by direction on top of the problem's; must outlive the solution. Null: none.
  const AngularInput* angular_input = nullptr;
  /// Where the iteration starts; must outlive the call. Null: from darkness.
  const SavedState* initial = nullptr;
  /// Whether to end at once, within a sweep: asked by all threads, often. Then SolveStopped is thrown.
  std::function<bool()> stops = {};
};

/// A solution that ended within a sweep, as SolveOptions::stops wanted: there is no solution, but a state to
/// continue from.
struct SolveStopped {
  SavedState state;
};

/// Bytes that solve() may take at its peak, the solution and all Krylov vectors included: an upper estimate.
std::size_t estimate_memory(const Problem& problem, const DirectionSet& directions,
                            const SolveOptions& options);

/// State of the iteration after a sweep.
struct SweepProgress {
  int sweep = 0;  ///< from 1
  int max_sweeps = 0;
  std::span<const double> residual;  ///< [band] estimated relative error
  double tolerance = 0;
  double seconds = 0;       ///< since the first sweep began
  double seconds_left = 0;  ///< estimated from the measured rate of convergence; negative: unknown
  std::function<SavedState()> state = {};  ///< makes a copy of the best state so far
};

enum class SolveControl { proceed, stop };

/// Called after every sweep; may ask to stop, and then the best state so far is the solution.
using SolveObserver = std::function<SolveControl(const SweepProgress&)>;

/// Solves by discrete ordinates with upwind discontinuous Galerkin elements. Not converging is a result,
/// marked in the solution. Throws InputError where a mirror has no partner ordinates.
Solution solve(const Problem& problem, const DirectionSet& directions, const SolveOptions& options,
               const SolveObserver& observer = {});

}  // namespace etendue
