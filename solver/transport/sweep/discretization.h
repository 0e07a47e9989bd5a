// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "solver/solution/added_extinction.h"
#include "solver/solution/solve_options.h"
#include "solver/transport/cells/cell_coefficients.h"
#include "solver/transport/order/ordinate_schedule.h"
#include "solver/transport/order/sweep_orders.h"
#include "solver/transport/scattering/dense_scattering.h"
#include "solver/transport/scattering/scattering_moments.h"
#include "solver/transport/state/transport_state.h"
#include "solver/transport/sweep/section_sums.h"
#include "solver/transport/walls/wall_exchange.h"

namespace etendue {

/// Treatment of scattering in all media.
struct ScatteringTreatments {
  std::vector<ScatteringTreatment> plan;  ///< [region * bands + band]
  std::vector<DenseGroup> groups;         ///< matrices of the media that scatter by one
};

/// The discretized problem of a sweep, equations (4), (11) and (13) of docs/theory/theory.md: cells,
/// ordinates and their orders, scattering and walls.
struct Discretization {
  /// `extinction` is [cell][band]; it may exceed absorption + scattering. `known_orders` are those of another
  /// one of the same mesh, directions and number of bands; null: they are made. The arguments must outlive
  /// it. Throws InputError where a mirror has no partner ordinates, SweepStopped where the options' `stops`
  /// asks for it.
  Discretization(const Problem& problem, const DirectionSet& directions, std::span<const double> extinction,
                 const SolveOptions& options, std::shared_ptr<const SweepOrders> known_orders, Scalar scalar);
  /// The same for sweeps in another precision, with the same orders.
  Discretization(const Discretization& other, Scalar scalar);
  /// The same for a subset of the bands, with the same orders. `problem` and `extinction` are those of the
  /// subset.
  Discretization(const Discretization& wide, const Problem& problem, std::span<const double> extinction,
                 std::span<const int> bands, Scalar scalar);
  /// The same problem on other directions, of which nothing is recorded: with no sources that depend on the
  /// direction, and with scattering by the moments of `fine`, as far as these directions resolve them
  /// (scattering_on_fewer()). Nothing in `fine` may scatter by a matrix.
  Discretization(const Discretization& fine, const DirectionSet& directions, Scalar scalar);
  Discretization(const Discretization&) = delete;
  Discretization& operator=(const Discretization&) = delete;

  StateLayout layout() const;
  /// Numbers of a fluence, [cell][node][stride].
  std::size_t fluence_size() const;
  /// Returns true where one sweep gives the solution: nothing scatters, and no light that arrives at walls or
  /// lagged faces is kept for the next sweep.
  bool is_direct() const;
  /// Threads that share the batches of a sweep.
  int sweep_threads() const;

  const Problem& problem;
  const DirectionSet& directions;
  std::span<const double> extinction;
  SolveOptions options;
  AddedExtinction added;  ///< to the extinction, its real part in `extinction` too
  ScatteringTreatments scattering;
  CellCoefficients cells;
  OrdinateSchedule schedule;
  ScatteringMoments moments;
  DenseScattering dense;
  double order_seconds = 0;  ///< wall-clock time that the orders took; 0 where they are those of another
  std::shared_ptr<const SweepOrders> orders;
  std::shared_ptr<WaitingSections> waiting;  ///< of this and of all that were made from it
  WallExchange walls;

 private:
  /// Makes its own orders where `known_orders` is null.
  Discretization(const Problem& problem, const DirectionSet& directions, std::span<const double> extinction,
                 const SolveOptions& options, AddedExtinction added_extinction, Scalar scalar,
                 ScatteringTreatments treatments, std::shared_ptr<const SweepOrders> known_orders,
                 std::shared_ptr<WaitingSections> known_waiting);
};

}  // namespace etendue
