// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "solver/angular/sets/direction_set.h"
#include "solver/transport/state/transport_state.h"
#include "solver/transport/sweep/transport_sweep.h"

namespace etendue {

/// The linear sweep T on fewer directions and in single precision, for corrections of a solution on many:
/// transport synthetic acceleration in angle (Morel and Manteuffel 1991; Ramone, Adams and Nowak 1997),
/// equations (T1) to (T3) of docs/theory/iteration.md. It acts on what both sets of directions share: the
/// fluence, moments up to the degree that the fewer ones resolve, and the irradiance of walls. To what is
/// lagged it sends nothing, so that there a correction is the residual.
class CoarseDirections {
 public:
  /// `fine`, whose states it takes, must outlive it, and must neither scatter by a matrix nor pass mirrored
  /// light on to the next sweep.
  CoarseDirections(const TransportSweep& fine, DirectionSet directions);

  int count() const { return directions_.count(); }
  /// next = T last in the bands that are `active`, [band]; the others have to be zero in `last`. Throws
  /// SweepStopped as all sweeps do.
  void apply_linear(const TransportState& last, TransportState& next, std::span<const char> active);

  std::string name() const;
  int sweeps() const { return sweeps_; }
  double order_seconds() const { return sweep_.order_seconds(); }  ///< wall clock
  std::int64_t band_sweep_count() const { return sweep_.band_sweep_count(); }
  double processor_seconds() const { return sweep_.processor_seconds(); }

 private:
  /// Runs of numbers that are the same unknowns in both states.
  struct Shared {
    std::size_t fine;
    std::size_t coarse;
    std::size_t count;
  };

  void find_shared(const TransportSweep& fine);

  DirectionSet directions_;
  SingleTransportSweep sweep_;
  std::vector<Shared> shared_;
  TransportState last_;
  TransportState next_;
  int sweeps_ = 0;
};

}  // namespace etendue
