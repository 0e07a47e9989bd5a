// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/command/check_run.h"

#include "app/command/exact_setup.h"
#include "app/command/photon_pictures.h"
#include "app/command/pictures.h"
#include "app/command/probes.h"
#include "app/command/run_options.h"
#include "app/command/run_photons.h"
#include "app/command/run_radiosity.h"
#include "app/command/sensors.h"
#include "solver/ordinates/solve.h"

namespace etendue {
namespace {

/// Cells, directions and bands of a sweep that takes a moment.
constexpr double quick_sweep = 2e7;

void check_directions_run(const Case& input, const Problem& problem, const CellLocator& locator) {
  check_views(input.cameras, input.sensors, problem);
  const LightSetup lights(problem);
  const RunDirections directions = run_directions(input, problem, lights);
  const DirectionSet& set = directions.sets.front();
  const DirectionSet* once = directions.first_collided.empty() ? nullptr : &directions.first_collided.front();
  check_sensors(input.sensors, locator, problem);
  SolveOptions options = run_options(input, set, place_probes(input.probes, problem.mesh(), locator));
  std::optional<ExactSetup> exact;
  if (input.exact) options.angular_input = &exact.emplace(input, problem, set).input;
  const double work = static_cast<double>(problem.mesh().cell_count()) * problem.band_count() *
                      (once == nullptr ? set : *once).count();
  if (work > quick_sweep) return;
  options.max_sweeps = 1;
  // Light along rays may take longer than all sweeps, and refuses nothing that the set-up of lights does not.
  solve(problem, set, options);
  if (once != nullptr) solve(problem, *once, options);
}

}  // namespace

void check_run(const Case& input, const Problem& problem) {
  const CellLocator locator(problem.mesh());
  if (input.photons) {
    check_for_photons(input, problem);
    check_photon_cameras(input.cameras, problem);
    place_probes(input.probes, problem.mesh(), locator);
  } else if (input.radiosity) {
    check_for_radiosity(input, problem);
    place_probes(input.probes, problem.mesh(), locator);
    const LightSetup lights(problem);
    check_sensors(input.sensors, locator, problem);
  } else {
    check_directions_run(input, problem, locator);
  }
}

Case with_coarsest_cells(Case input) {
  if (input.mesh.file) return input;
  input.mesh.max_volume.reset();
  input.mesh.edge_length.reset();
  input.mesh.split = 0;
  return input;
}

}  // namespace etendue
