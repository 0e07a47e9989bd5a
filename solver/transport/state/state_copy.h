// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "solver/solution/saved_state.h"
#include "solver/transport/state/transport_state.h"

namespace etendue {

/// The values of a state, to the last bit.
SavedState saved(const TransportState& state, int bands);

/// Gives a state the values that were saved. Throws InputError where they are not of its kind.
void restore(const SavedState& from, int bands, TransportState& state);

}  // namespace etendue
