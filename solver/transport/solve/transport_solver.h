// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "solver/angular/sets/direction_set.h"
#include "solver/problem/problem.h"
#include "solver/solution/solution.h"
#include "solver/solution/solve_observer.h"
#include "solver/solution/solve_options.h"
#include "solver/transport/acceleration/coarse_directions.h"
#include "solver/transport/solve/acceleration_policy.h"
#include "solver/transport/source/directional_emission.h"
#include "solver/transport/source/ordinate_lights.h"
#include "solver/transport/state/transport_state.h"
#include "solver/transport/sweep/transport_sweep.h"

namespace etendue {

/// solve() for several solutions with the same coefficients: sweep orders and what accelerates are made once.
/// Between solutions the values of the angular input may change, and what the problem emits by
/// Problem::set_following().
class TransportSolver {
 public:
  /// The arguments must outlive it; emission that follows changes a copy of the problem. `known_orders` are
  /// those of another solver of the same mesh, directions and number of bands; null: they are made. Throws
  /// InputError where a mirror has no partner ordinates, SolveStopped where the options' `stops` asks for it.
  TransportSolver(const Problem& problem, const DirectionSet& directions, const SolveOptions& options,
                  std::shared_ptr<const SweepOrders> known_orders = nullptr);
  TransportSolver(const TransportSolver&) = delete;
  TransportSolver& operator=(const TransportSolver&) = delete;

  /// The first solution is iterated from the options' initial state, each other one from the last. Throws as
  /// solve() does.
  Solution solve(const SolveObserver& observer = {});
  std::shared_ptr<const SweepOrders> orders() const { return sweep_.discretization().orders; }

 private:
  /// Lights and emission that depend on the direction, and the options with them as angular input.
  struct DirectionalSources {
    DirectionalSources(const Problem& problem, const DirectionSet& directions, const SolveOptions& asked);
    DirectionalSources(const DirectionalSources&) = delete;
    DirectionalSources& operator=(const DirectionalSources&) = delete;

    OrdinateLights lights;
    DirectionalEmission emission;
    SolveOptions options;
  };

  void report_sources(Solution& solution) const;
  double low_order_seconds() const;
  /// The cost of a sweep for each cell, direction and band [ns].
  double sweep_cost() const;

  std::optional<Problem> changing_;  ///< the problem, where emission follows
  const Problem& problem_;
  const SolveOptions& options_;
  std::vector<double> extinction_;  ///< [cell][band]
  DirectionalSources sources_;
  TransportSweep sweep_;
  TransportState state_;
  std::unique_ptr<CoarseDirections> coarse_;
  std::optional<SingleTransportSweep> single_;
  std::optional<LowOrder> low_order_;
  std::vector<std::string> low_order_notes_;
};

}  // namespace etendue
