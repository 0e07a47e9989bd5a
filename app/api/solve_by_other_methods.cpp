// SPDX-License-Identifier: AGPL-3.0-or-later
#include <etendue/errors.h>

#include <ostream>

#include "app/api/solved_case.h"
#include "app/case/build/build.h"
#include "app/readings/probes.h"
#include "app/readings/sensors.h"
#include "app/render/photon_pictures.h"
#include "app/run/memory_forecast.h"
#include "app/run/methods/photon_memory.h"
#include "app/run/methods/run_photons.h"
#include "app/run/methods/run_radiosity.h"
#include "app/run/report/unreached.h"
#include "app/setup/memory.h"

namespace etendue::v0 {
namespace {

/// A run whose stages are not shown; a function says when it ends.
struct QuietRun {
  explicit QuietRun(const SolveHooks& hooks)
      : stops([&hooks] { return hooks.stop && hooks.stop(); }),
        interruption(stops),
        stages{ProgressStyle::none, nowhere, stops} {}

  std::function<bool()> stops;
  Interruption interruption;
  std::ostream nowhere{nullptr};
  StageDisplay stages;
};

SolveOptions options_of(const SolvedCase& solved) {
  SolveOptions options = solved.input.solve;
  options.threads = solved.threads();
  return options;
}

}  // namespace

void solve_by_photons(SolvedCase& solved, const SolveHooks& hooks) {
  hooks.begins("setting up");
  check_for_photons(solved.input, solved.problem);
  check_photon_cameras(solved.input.cameras, solved.problem);
  place_probes(solved.input.probes, *solved.mesh, solved.locator);
  memory_text(photon_run_memory(solved.input, solved.problem),
              solved.problem);  // throws where there is not as much
  hooks.begins("photons");
  QuietRun quiet(hooks);
  PhotonRun found = run_photons(
      {solved.input, solved.problem, solved.locator, solved.threads(), quiet.stages, quiet.interruption});
  throw_if_stopped(hooks);
  solved.solution = std::move(found.solution);
  RunResult& result = solved.result.emplace(measured(solved));
  result.probes = std::move(found.probes);
  result.errors = std::move(found.errors);
  bound_unreached(result, solved.locator, found.walked_back);
}

void solve_by_radiosity(SolvedCase& solved, const SolveHooks& hooks) {
  hooks.begins("setting up");
  check_for_radiosity(solved.input, solved.problem);
  place_probes(solved.input.probes, *solved.mesh, solved.locator);
  solved.radiosity = std::make_unique<RadiosityViews>(
      solved.problem, build_directions(solved.input, solved.problem), options_of(solved));
  const RadiosityViews& views = *solved.radiosity;
  check_sensors(solved.input.sensors, solved.locator, solved.problem);
  const RadiosityOptions asked = radiosity_options(solved.input, solved.threads());
  hooks.begins("form factors");
  RadiosityRoom room(solved.problem, asked, [&](const RadiosityStage& stage) {
    if (stage.done == 0)
      check_memory(radiosity_memory(solved.problem, asked, stage.patches).bytes, *solved.mesh,
                   solved.problem.band_count());
  });
  throw_if_stopped(hooks);
  hooks.begins("light from wall to wall");
  QuietRun quiet(hooks);
  RadiosityRun found;
  try {
    found = run_radiosity(
        {solved.input, views.lights, views.directions, solved.locator, quiet.stages, quiet.interruption},
        room, [](double) {});
  } catch (const RadiosityStopped&) {
    throw Stopped("stopped: there is no solution");
  }
  throw_if_stopped(hooks);
  solved.solution = std::move(found.solution);
  if (!solved.input.sensors.empty()) rays_of(solved);
  RunResult& result = solved.result.emplace(measured(solved));
  result.probes = std::move(found.probes);
  result.radiosity = std::move(found.report);
  result.passes = std::move(found.passes);
  result.patches = std::move(found.patches);
  result.pass_patches = std::move(found.pass_patches);
  result.sensors =
      read_sensors(solved.input.sensors,
                   {views.lights, OrdinateSensorTally(solved.input.sensors, views.lights, solved.locator),
                    views.options, solved.solution, solved.rays, solved.locator});
}

}  // namespace etendue::v0
