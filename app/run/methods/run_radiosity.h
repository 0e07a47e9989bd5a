// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "app/case/case.h"
#include "app/progress/interruption.h"
#include "app/progress/stage_progress.h"
#include "app/write/result/run_result.h"
#include "mesh/tetrahedra/search/cell_locator.h"
#include "solver/angular/sets/direction_set.h"
#include "solver/radiosity/solve/solve_radiosity.h"
#include "solver/uncollided/lights/light_setup.h"

namespace etendue {

/// A solution by radiosity with all that is measured of it.
struct RadiosityRun {
  Solution solution;
  RadiosityReport report;
  std::vector<ProbeRow> probes;
  std::vector<Solution> passes;  ///< walls after the first passes, as the case asks
  /// Light on patches where they are finer than faces: of the solution, and of these passes.
  std::optional<PatchLight> patches;
  std::vector<PatchLight> pass_patches;
  double probe_seconds = 0;
};

/// Throws InputError where radiosity does not know what the case asks.
void check_for_radiosity(const Case& input, const Problem& problem);

RadiosityOptions radiosity_options(const Case& input, int threads);

/// What the form factors take, as a line.
std::string radiosity_memory_text(const RadiosityMemory& memory);

/// What a run by radiosity looks at.
struct RadiosityScene {
  const Case& input;
  const LightSetup& lights;  ///< followed along rays by pictures and sensors
  const DirectionSet& directions;
  const CellLocator& locator;
  const StageDisplay& stages;
  Interruption& interruption;
};

/// Thrown where the light in the cells takes too long after a signal: without it there is nothing to write.
struct RadiosityStopped {};

/// Solves a case in a room that is made for it. The state of the solution is that of RadiosityRoom. After the
/// first pass a signal ends the passes. Throws RadiosityStopped.
RadiosityRun run_radiosity(const RadiosityScene& scene, RadiosityRoom& room,
                           const FactorProgress& of_cells = {});

}  // namespace etendue
