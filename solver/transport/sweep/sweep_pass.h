// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "solver/transport/state/transport_state.h"
#include "solver/transport/sweep/sweep_record.h"

namespace etendue {

/// States and record of one sweep along all ordinates.
struct SweepPass {
  const TransportState& last;
  TransportState& next;
  SweepRecord* record = nullptr;  ///< null: none is wanted
  Emission emission = Emission::included;
};

}  // namespace etendue
