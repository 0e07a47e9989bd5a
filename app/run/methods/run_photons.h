// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "app/case/case.h"
#include "app/progress/interruption.h"
#include "app/progress/stage_progress.h"
#include "app/write/result/run_result.h"
#include "mesh/tetrahedra/search/cell_locator.h"
#include "solver/photons/solve/solve_photons.h"

namespace etendue {

/// A case that is solved by photons, and what that needs.
struct PhotonRunInput {
  const Case& input;
  const Problem& problem;
  const CellLocator& locator;
  int threads = 1;
  const StageDisplay& stages;
  Interruption& interruption;
  RankGroup* ranks = nullptr;  ///< processes that share the histories; null: this one alone
};

/// A solution by photons with all that is measured of it.
struct PhotonRun {
  Solution solution;
  std::vector<ProbeRow> probes;  ///< those that were read
  RunErrors errors;
  double probe_seconds = 0;  ///< of walking back
  double walked_back = 0;    ///< histories of each probe; 0 where probes read the field of the cells
};

/// Throws InputError where photons do not know what the case asks.
void check_for_photons(const Case& input, const Problem& problem);

/// Walks the histories of a case, and back from its probes. A signal ends the program at once until a batch
/// is whole; later ones leave out batches and probes that are not.
PhotonRun run_photons(const PhotonRunInput& run);

}  // namespace etendue
