// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "solver/ordinates/dense_scattering.h"
#include "solver/ordinates/scattering_plan.h"
#include "solver/ordinates/solution.h"

namespace etendue {

/// What scattering became in every medium and band that scatters.
std::vector<KernelReport> report_kernels(const Problem& problem, const DirectionSet& directions,
                                         const std::vector<ScatteringTreatment>& plan,
                                         const std::vector<DenseGroup>& groups);

}  // namespace etendue
