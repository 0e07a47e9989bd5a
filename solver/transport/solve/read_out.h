// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "solver/solution/solution.h"
#include "solver/transport/sweep/transport_sweep.h"

namespace etendue {

/// Fills the solution's fields from the state that the last sweep gave, and from its record, whose parts are
/// moved. Constant elements have their value at every vertex.
void read_out(const TransportSweep& sweep, const TransportState& state, SweepRecord& record,
              Solution& solution);

/// Notes on kernels, lumped mass, orders and walls of a run.
std::vector<std::string> notes_of(const TransportSweep& sweep);

}  // namespace etendue
