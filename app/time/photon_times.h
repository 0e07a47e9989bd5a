// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "app/case/case.h"
#include "app/progress/stage_progress.h"
#include "app/write/result/time_result.h"
#include "mesh/tetrahedra/search/cell_locator.h"
#include "solver/problem/problem.h"

namespace etendue {

/// Bytes that photon_times() takes beside the photons of the steady light; 0 without [time].
std::size_t photon_times_memory(const Case& input, const Problem& problem, int threads);

/// The times of a case that is solved by photons, by as many histories; without irradiances, which they do
/// not read.
TimeResult photon_times(const Case& input, const Problem& problem, const CellLocator& locator, int threads,
                        const StageDisplay& stages);

}  // namespace etendue
