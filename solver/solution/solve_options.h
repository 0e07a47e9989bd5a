// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "base/vec3.h"
#include "mesh/tetrahedra/search/cell_locator.h"

namespace etendue {

/// Polynomial degree of the discontinuous Galerkin space.
enum class SpaceOrder { constant = 0, linear = 1 };

/// How the equations are iterated; automatic: GMRES.
enum class Method { automatic, gmres, source_iteration };

/// The numbers that sweeps compute with. Mixed: float within the cycles of GMRES, double where they begin and
/// end, so that the residual that is judged, and the solution, are those of double. Automatic: mixed where
/// the tolerance is at least 1e-10 and light does not return more than some 300 times.
enum class Precision { automatic, full, mixed };

/// Corrections of the vectors of GMRES on fewer directions (Morel and Manteuffel 1991); automatic: on at most
/// a sixth of them, where that pays.
enum class AngularMultigrid { automatic, none };

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
class RankGroup;
class FollowingEmission;
struct AddedExtinction;
struct SavedState;

struct SolveOptions {
  SpaceOrder order = SpaceOrder::linear;
  Lumping lumping = Lumping::automatic;
  Positivity positivity = Positivity::none;
  Method method = Method::automatic;
  Precision precision = Precision::automatic;  ///< of GMRES; other methods know only full
  AngularMultigrid angular_multigrid = AngularMultigrid::automatic;  ///< of GMRES
  Acceleration acceleration = Acceleration::automatic;
  DiffusionLength diffusion_length = DiffusionLength::automatic;
  double tolerance = 1e-6;  ///< estimated relative error of the iteration, per band
  int max_sweeps = 500;
  int threads = 0;  ///< 0: all cores
  /// Processes that share the ordinates of each sweep, and do the rest alike; must outlive the solution.
  /// Null: this one sweeps alone.
  RankGroup* ranks = nullptr;
  std::size_t order_memory = std::size_t{2} << 30;  ///< bytes that sweep orders may take; beyond, recomputed
  /// What a third-level cache may hold of a sweep [bytes]; with more, neighbouring ordinates go through the
  /// mesh together, tile by tile.
  std::size_t cache_bytes = std::size_t{16} << 20;
  std::vector<int> keep_ordinates;      ///< whose radiance the solution keeps
  std::vector<IrradianceMeter> meters;  ///< read while sweeping: the angular solution is not kept
  /// Source and inflow by direction on top of the problem's; must outlive the solution. Null: none.
  const AngularInput* angular_input = nullptr;
  /// Sources of another problem, of which this one is the adjoint with all directions reversed: the solution
  /// has their products with it (Solution::source_products). They must outlive the call.
  std::vector<const AngularInput*> paired_sources;
  /// Of light that changes with time; must outlive the solution. Null: nothing is added. Complex radiances
  /// are not for positivity, emission that follows or source iteration with diffusion.
  const AddedExtinction* added_extinction = nullptr;
  /// Emission that changes with the solution, and in the end is that of the solution; must outlive the
  /// call. Null: the emission of the problem is all.
  FollowingEmission* following_emission = nullptr;
  /// Where the iteration starts; must outlive the call. Null: from darkness.
  const SavedState* initial = nullptr;
  /// Whether to end at once, within a sweep: asked by all threads, often. Then SolveStopped is thrown.
  std::function<bool()> stops = {};
  /// Told the share of the sweep orders that are made, in (0, 1], by one thread at a time.
  std::function<void(double share)> orders_share = {};
  /// Told the share of a sweep that is done, in (0, 1], after every few batches of ordinates by one thread.
  std::function<void(double share)> sweep_share = {};
};

}  // namespace etendue
