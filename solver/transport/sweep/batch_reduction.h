// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "solver/transport/sweep/batch_workspace.h"
#include "solver/transport/sweep/moment_operators.h"
#include "solver/transport/sweep/sweep_pass.h"

namespace etendue {

/// Sum of the batches of a sweep: adds fluence, moments and irradiance that threads found to the next state,
/// batch after batch, so that the bits do not depend on the number of threads.
template <class Real>
class BatchReduction {
 public:
  using Workspaces = std::span<const std::unique_ptr<BatchWorkspace<Real>>>;

  /// The arguments must outlive it. `seconds` counts the processor time.
  BatchReduction(const Discretization& discretization, MomentOperators<Real>& moments, int threads,
                 double& seconds)
      : d_(discretization), moments_(moments), threads_(threads), seconds_(seconds) {}

  /// Adds the batches from `first_batch` on, one from each of the workspaces, and sets their sums to zero.
  void add(std::int32_t first_batch, Workspaces workspaces, const SweepPass& pass) const;

 private:
  void add_cells(std::int32_t first, std::int32_t last, Workspaces workspaces, const SweepPass& pass) const;
  void add_moments(std::int32_t first_batch, Workspaces workspaces, const SweepPass& pass) const;

  const Discretization& d_;
  MomentOperators<Real>& moments_;
  int threads_;
  double& seconds_;
};

extern template class BatchReduction<double>;
extern template class BatchReduction<float>;

}  // namespace etendue
