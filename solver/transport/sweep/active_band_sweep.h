// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <memory>
#include <span>

#include "solver/transport/state/transport_state.h"
#include "solver/transport/sweep/discretization.h"
#include "solver/transport/sweep/sweep_cost.h"

namespace etendue {

/// Linear sweep of those bands alone that are still iterated, once they fit into fewer lanes.
template <class Real>
class ActiveBandSweep {
 public:
  /// The sweep of all bands is of `discretization`, which must outlive it.
  ActiveBandSweep(const Discretization& discretization, int threads);
  ~ActiveBandSweep();

  /// next = T last in the active bands, [band], and zero in the others; adds to `cost`. Returns false, and
  /// does nothing, where a sweep of all bands needs no more lanes.
  bool apply_linear(const TransportState& last, TransportState& next, std::span<const char> active,
                    SweepCost& cost);
  /// Lanes of the last such sweep; those of all bands where there is none.
  int lanes() const;
  /// Forgets the last active bands.
  void reset();

 private:
  struct Subset;

  /// Returns the sweep of the active bands; null where it would not need fewer lanes.
  Subset* subset_of(std::span<const char> active);

  const Discretization& d_;
  int threads_;
  std::unique_ptr<Subset> subset_;  ///< of the last active bands; null: all bands
  bool is_possible_ = true;         ///< false where a subset has other rows in its state
};

extern template class ActiveBandSweep<double>;
extern template class ActiveBandSweep<float>;

}  // namespace etendue
