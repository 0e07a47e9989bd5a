// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "solver/problem/problem.h"
#include "solver/solution/solution.h"

namespace etendue {

/// Whether no medium emits differently in different directions.
bool emits_isotropically(const Problem& problem);

/// Divergence of the net flux in the mean over each cell, summed over the bands [cell] [power/length^3]: what
/// the medium emits less what it absorbs, 4 pi q - sigma_a phi (Modest, Radiative Heat Transfer, eq.
/// (10.59)). Media must not emit differently in different directions.
std::vector<double> flux_divergence(const Problem& problem, const Solution& solution);

}  // namespace etendue
