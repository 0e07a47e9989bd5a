// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>

#include "base/index.h"
#include "solver/transport/state/transport_state.h"
#include "solver/transport/sweep/sweep_record.h"

namespace etendue {

/// States and record of one sweep along all ordinates.
struct SweepPass {
  const TransportState& last;
  TransportState& next;
  SweepRecord* record = nullptr;  ///< null: none is wanted
  Emission emission = Emission::included;
  std::span<const char> only = {};  ///< [ordinate] whether to march along it; empty: along all

  bool skips(OrdinateIndex m) const { return !only.empty() && only[m.at()] == 0; }
};

}  // namespace etendue
