// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "solver/ordinates/aligned_array.h"
#include "solver/ordinates/transport_sweep.h"

// Part of TransportSweep, for its source files alone.
namespace etendue {

/// What one thread needs while it sweeps a batch; sums are zero between batches.
struct TransportSweep::Workspace {
  /// For each ordinate of a group.
  struct Member {
    SweepSlots slots;
    bool is_filled = false;  ///< with what walls send in, the same for all ordinates of a sweep
    SweepOrder scratch_order;
  };

  AlignedArray radiance;  ///< of all slots
  std::vector<Member> members;
  AlignedArray fluence;  ///< [cell + 1][node][stride]
  AlignedArray irradiance;
  AlignedArray angular;  ///< [ordinate of the batch][1 + row][node][stride]
  AlignedArray net_flux;
  AlignedArray exitance;
  AlignedArray whole;  ///< [1 + cell][node][stride] of an ordinate that is kept
  std::vector<double> meters;
  std::vector<double> absorbed;
  AlignedArray records;  ///< as those of the sweep, with the mass of one ordinate where it depends on it
};

/// One ordinate on its way through the mesh.
struct TransportSweep::Passage {
  OrdinateIndex ordinate;
  const SweepOrder* order;
  double* angular;  ///< [1 + row][node][stride]
  Workspace::Member* member;
};

}  // namespace etendue
