// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "solver/problem/problem.h"
#include "solver/solution/solve_options.h"
#include "solver/transport/acceleration/diffusion_acceleration.h"
#include "solver/transport/sweep/transport_sweep.h"

namespace etendue {

/// Diffusion that accelerates the iteration, or only estimates its error.
struct LowOrder {
  std::unique_ptr<DiffusionAcceleration>
      diffusion;  ///< null where the iteration's own estimate is good enough
  bool accelerates = false;

  DiffusionAcceleration* acceleration() const { return accelerates ? diffusion.get() : nullptr; }
  DiffusionAcceleration* judge() const { return accelerates ? nullptr : diffusion.get(); }
};

/// What is known of the low-order solve before there is a sweep.
struct LowOrderPlan {
  bool is_needed = false;  ///< of a run that iterates, to accelerate or to judge it
  std::string reason;      ///< why it does not accelerate; empty where it does
};
LowOrderPlan plan_low_order(const Problem& problem, const SolveOptions& options);

/// Chooses whether diffusion accelerates a run, judges it or is not needed (docs/theory/iteration.md).
/// `extinction` is [cell][band]. Adds the reason to `notes` where nothing is accelerated. The arguments but
/// for `notes` must outlive the result.
LowOrder choose_low_order(const Problem& problem, TransportSweep& sweep, std::span<const double> extinction,
                          const SolveOptions& options, std::vector<std::string>& notes);

}  // namespace etendue
