// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "solver/solution/solution.h"
#include "solver/transport/scattering/dense_scattering.h"
#include "solver/transport/scattering/scattering_plan.h"

namespace etendue {

/// What scattering became in every medium and band that scatters.
std::vector<KernelReport> report_kernels(const Problem& problem, const DirectionSet& directions,
                                         const std::vector<ScatteringTreatment>& plan,
                                         const std::vector<DenseGroup>& groups);

}  // namespace etendue
