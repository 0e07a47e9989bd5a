// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>

#include "solver/ordinates/saved_state.h"
#include "solver/problem/problem.h"

namespace etendue {

/// A state of linear elements whose fluence and moments are continuous within each region: at each vertex the
/// mean over the region's cells there, weighted by volume (Clément 1975). Of smooth light that is as near to
/// the truth as the elements or nearer, so that the difference of the two tells how large the error of these
/// is (Zienkiewicz and Zhu 1987). `rows` [cell] are those of CollidedSource. What walls receive stays.
SavedState recovered_state(const Problem& problem, const SavedState& state,
                           std::span<const std::int32_t> rows);

}  // namespace etendue
