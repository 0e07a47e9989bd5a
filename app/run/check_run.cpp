// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/run/check_run.h"

#include <utility>

#include "app/case/temperatures.h"
#include "app/readings/probes.h"
#include "app/readings/sensors.h"
#include "app/render/photon_pictures.h"
#include "app/run/memory_forecast.h"
#include "app/run/methods/photon_memory.h"
#include "app/run/methods/run_photons.h"
#include "app/run/methods/run_radiosity.h"
#include "app/run/ordinates_setup.h"
#include "app/run/report/phase_text.h"
#include "app/time/solve_in_time.h"
#include "solver/transport/solve/solve.h"

namespace etendue {
namespace {

/// Cells, directions and bands of a sweep that takes a moment.
constexpr double quick_sweep = 2e7;

CheckedRun check_directions_run(const Case& input, const Problem& problem) {
  OrdinatesSetup run(input, problem);
  const bool collides_once = !run.directions.first_collided.empty();
  const double work = static_cast<double>(problem.mesh().cell_count()) * problem.band_count() *
                      finest(run.directions).count();
  if (work <= quick_sweep) {
    SolveOptions options = run.options;
    options.max_sweeps = 1;
    // Light along rays may take longer than all sweeps, and refuses nothing that the set-up of lights does
    // not.
    solve(problem, run.set(), options);
    if (collides_once) solve(problem, run.directions.first_collided.front(), options);
  }
  // It refuses what it cannot do.
  if (input.time && !steps_temperatures(input))
    time_plan_text({input, problem, run.directions.sets, run.options, run.locator, run.lights});
  return {directions_run_memory(input, problem, run), run.resolution(problem),
          plan_texts(problem, run.set())};
}

}  // namespace

CheckedRun check_run(const Case& input, const Problem& problem) {
  if (!input.photons && !input.radiosity) return check_directions_run(input, problem);
  const CellLocator locator(problem.mesh());
  if (input.photons) {
    check_for_photons(input, problem);
    check_photon_cameras(input.cameras, problem);
    place_probes(input.probes, problem.mesh(), locator);
    return {photon_run_memory(input, problem), {}, {}};
  }
  check_for_radiosity(input, problem);
  place_probes(input.probes, problem.mesh(), locator);
  const LightSetup lights(problem);
  check_sensors(input.sensors, locator, problem);
  return {};
}

Case with_coarsest_cells(Case input) {
  if (input.mesh.file) return input;
  input.mesh.max_volume.reset();
  input.mesh.edge_length.reset();
  input.mesh.refine = 0;
  return input;
}

}  // namespace etendue
