// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "solver/angular/kernels/dense_kernel.h"
#include "solver/problem/problem.h"

namespace etendue {

/// sigma_a(x, w) of one medium and band, where it is a formula that depends on the direction: means over
/// cells, [ordinate][cell of `cells`] [1/length]. Where the formula is the extinction, `amplitude` [cell]
/// times what `kernel` scatters out of each ordinate is taken off. Throws InputError, naming the medium, the
/// point and the direction, where it is negative or not finite.
std::vector<double> directional_absorption(const Problem& problem, const DirectionSet& directions,
                                           const Medium& medium, int band, const DenseKernel& kernel,
                                           std::span<const CellIndex> cells,
                                           std::span<const double> amplitude);

}  // namespace etendue
