// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/solve/precision_policy.h"

#include "solver/transport/solve/returned_light.h"

namespace etendue {
namespace {

/// Each cycle in single precision begins anew after six digits: with more of them that takes as many sweeps
/// as are saved.
constexpr double finest_tolerance = 1e-10;

}  // namespace

bool has_cycles_in_single_precision(const Problem& problem, const SolveOptions& options) {
  if (options.method == Method::source_iteration) return false;
  return options.precision == Precision::mixed ||
         (options.precision == Precision::automatic && options.tolerance >= finest_tolerance &&
          most_returns(problem) <= many_returns);
}

}  // namespace etendue
