// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "app/case/case.h"
#include "app/write/result/run_result.h"
#include "base/parallel/stage_observer.h"
#include "mesh/tetrahedra/search/cell_locator.h"
#include "solver/solution/solution.h"
#include "solver/solution/solve_options.h"
#include "solver/uncollided/lights/light_setup.h"

namespace etendue {

/// A meter for each point of the probes that have a normal, in the order of the case. Throws InputError with
/// every point of a probe that lies outside the mesh.
std::vector<IrradianceMeter> place_probes(const std::vector<Probe>& probes, const TetrahedralMesh& mesh,
                                          const CellLocator& locator);

/// The solution at all probes; its meters are those of place_probes. Uncollided light is computed exactly at
/// each point, the rest is interpolated. Where the observer stops it, the points that were not reached are
/// left out.
std::vector<ProbeRow> read_probes(const std::vector<Probe>& probes, const LightSetup& lights,
                                  const Solution& solution, const CellLocator& locator, int threads,
                                  const StageObserver& observer = {});

}  // namespace etendue
