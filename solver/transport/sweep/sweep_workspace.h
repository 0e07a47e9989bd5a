// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "solver/transport/state/aligned_array.h"
#include "solver/transport/sweep/transport_sweep.h"

// Part of TransportSweep, for its source files alone.
namespace etendue {

/// What one thread needs while it sweeps a batch; sums are zero between batches.
template <class Real>
struct TransportSweepOf<Real>::Workspace {
  /// For each ordinate of a group.
  struct Member {
    SweepSlotsOf<Real> slots;
    bool is_filled = false;  ///< with what walls send in, the same for all ordinates of a sweep
    OwnedOrder remade_order;
  };

  AlignedArrayOf<Real> radiance;  ///< of all slots
  std::vector<Member> members;
  std::unique_ptr<SweepOrderMaker> order_maker;  ///< null while none was made again
  AlignedArrayOf<Real> fluence;                  ///< [cell + 1][node][stride]
  AlignedArray irradiance;
  AlignedArrayOf<Real> angular;  ///< [ordinate of the batch][1 + row][node][stride]
  AlignedArrayOf<Real> net_flux;
  AlignedArray exitance;
  AlignedArrayOf<Real> whole;  ///< [1 + cell][node][stride] of an ordinate that is kept
  std::vector<double> meters;
  std::vector<double> absorbed;
  AlignedArrayOf<Real>
      records;  ///< as those of the sweep, with the mass of one ordinate where it depends on it
};

/// One ordinate as it sweeps the mesh.
template <class Real>
struct TransportSweepOf<Real>::Passage {
  OrdinateIndex ordinate;
  const SweepOrder* order;
  Real* angular;  ///< [1 + row][node][stride]
  Workspace::Member* member;
};

}  // namespace etendue
