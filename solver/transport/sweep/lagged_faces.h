// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "solver/transport/order/sweep_slots.h"
#include "solver/transport/sweep/discretization.h"

namespace etendue {

/// Sets the slots of the cells upwind of the lagged faces of ordinate m to their radiance in the last sweep
/// (docs/theory/theory.md, section 4). They hold it until these cells are solved.
template <class Real>
void set_lagged(const Discretization& discretization, OrdinateIndex m, const SweepOrder& order,
                const TransportState& last, const SweepSlotsOf<Real>& slots);

/// Copies the radiance upwind of the lagged faces of ordinate m to the next state.
template <class Real>
void keep_lagged(const Discretization& discretization, OrdinateIndex m, const SweepOrder& order,
                 TransportState& next, const SweepSlotsOf<Real>& slots);

}  // namespace etendue
