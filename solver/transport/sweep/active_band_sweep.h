// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "solver/problem/band_selection.h"
#include "solver/transport/sweep/transport_sweep.h"

// Part of TransportSweep, for its source files alone.
namespace etendue {

/// Sweep of a subset of the bands, with its states.
template <class Real>
struct TransportSweepOf<Real>::ActiveBandSweep {
  ActiveBandSweep(const TransportSweepOf& wide, std::vector<int> wanted)
      : bands(std::move(wanted)),
        problem(wide.problem_.of_bands(bands)),
        extinction(select_bands(wide.extinction_, static_cast<std::size_t>(wide.cells_.bands()), bands)),
        sweep(wide, problem, extinction, bands),
        last(sweep.layout()),
        next(sweep.layout()) {}

  std::size_t stride() const { return static_cast<std::size_t>(sweep.cells_.stride()); }

  std::vector<int> bands;  ///< of the wide sweep
  Problem problem;
  std::vector<double> extinction;
  TransportSweepOf sweep;
  TransportState last;
  TransportState next;
};

}  // namespace etendue
