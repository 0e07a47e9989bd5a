// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>

#include "solver/angular/sets/direction_set.h"
#include "solver/problem/problem.h"

namespace etendue {

/// The scattering coefficient, in the mean over directions, that goes with a kernel: the same everywhere for
/// a matrix, in proportion to the kernel for a formula, whose place is set to where it is large; the mean
/// over the region too for a formula that is no product of a factor of the place and one of the directions.
Coefficient kernel_scattering(DirectionalScattering& kernel, const DirectionSet& directions,
                              const TetrahedralMesh& mesh, int region);

/// The extinction that is given beside it.
std::optional<double> kernel_extinction(const DirectionalScattering& kernel);

}  // namespace etendue
