// SPDX-License-Identifier: AGPL-3.0-or-later
#include <etendue/errors.h>
#include <fmt/format.h>

#include "app/api/solved_case.h"
#include "app/case/temperatures.h"
#include "app/readings/probes.h"
#include "app/readings/sensors.h"
#include "app/run/memory_forecast.h"
#include "app/run/report/resolution_text.h"
#include "app/time/heat_steps.h"
#include "app/write/vtk/solution_file.h"
#include "solver/exact/exact_balance.h"
#include "solver/uncollided/first_collision/solve_rotated.h"

namespace etendue::v0 {
namespace {

/// The state that the case starts from; empty where it starts from darkness.
std::optional<SavedState> initial_state(const SolvedCase& solved) {
  if (!solved.input.initial) return std::nullopt;
  return read_initial(*solved.input.initial, solved.input, *solved.mesh);
}

/// Sweeps until the iteration has converged or was ended.
void sweep(SolvedCase& solved, const SolveHooks& hooks, OrdinateSensorTally& tally) {
  const OrdinatesSetup& setup = *solved.ordinates;
  const std::optional<SavedState> initial = initial_state(solved);
  SolveOptions options = setup.options;
  if (initial) options.initial = &*initial;
  options.stops = hooks.stop;
  DirectionSetObserver reader;
  if (need_all_ordinates(solved.input.sensors, solved.problem.space()))
    reader = [&](const DirectionSetSolution& swept) {
      setup.set_emission(solved.problem);
      tally.add(options, swept);
    };
  hooks.begins("light before its first collision");
  UncollidedLight uncollided(setup.lights, options);
  throw_if_stopped(hooks);
  if (steps_temperatures(solved.input)) {
    hooks.begins("temperatures in time");
    std::optional<etendue::Solution> end = take_heat_steps(
        {solved.input, solved.problem, *setup.temperatures, setup.set(), options, setup.locator}, uncollided,
        {hooks.stop, {}}, reader, solved.in_time.emplace());
    throw_if_stopped(hooks);
    if (end && !solved.in_time->steps->fault.empty())
      end->notes.push_back(fmt::format("steps in time ended at {:g} s: {}",
                                       solved.in_time->steps->steps.back().end,
                                       solved.in_time->steps->fault));
    if (!end) throw Stopped("stopped within the first step: there is no solution");
    solved.solution = *std::move(end);
    solved.first_collisions = uncollided.first_collisions();
    return;
  }
  hooks.begins("sweeps");
  try {
    solved.solution = solve_rotated(
        uncollided, setup.directions.sets, options,
        [&](const SweepProgress& progress) {
          return hooks.swept(progress) ? SolveControl::proceed : SolveControl::stop;
        },
        setup.directions.first_collided, reader);
  } catch (const SolveStopped&) {
    throw Stopped("stopped within a sweep: there is no solution");
  }
  solved.first_collisions = uncollided.first_collisions();
}

bool sees_along_rays(const SolvedCase& solved) {
  return std::ranges::any_of(solved.input.sensors, [&](const SensorCase& sensor) {
    return !reads_ordinates(sensor, solved.problem.space());
  });
}

StageObserver stopping(const SolveHooks& hooks) {
  return [&hooks](double) { return !hooks.stop || !hooks.stop(); };
}

}  // namespace

void solve_by_ordinates(SolvedCase& solved, const SolveHooks& hooks) {
  hooks.begins("setting up");
  solved.ordinates = std::make_unique<OrdinatesSetup>(solved.input, solved.problem);
  const OrdinatesSetup& setup = *solved.ordinates;
  // Throws where there is not as much.
  memory_text(steps_temperatures(solved.input) ? directions_run_memory(solved.input, solved.problem, setup)
                                               : setup.memory(),
              solved.problem);
  OrdinateSensorTally tally(solved.input.sensors, setup.lights, setup.locator);
  sweep(solved, hooks, tally);
  setup.set_emission(solved.problem);
  RunResult& result = solved.result.emplace(measured(solved));
  result.heat = setup.heat_solution();
  result.time = solved.in_time;
  result.is_coarse = is_coarse(setup.resolution(solved.problem));
  if (setup.exact) {
    result.exact = compare_with_exact(solved.problem, solved.solution, setup.exact->radiance, setup.set());
    add_exact_powers(setup.exact->input, result.walls, result.regions, result.balances);
  }
  if (!solved.input.probes.empty()) hooks.begins("probes");
  result.probes = read_probes(solved.input.probes, setup.lights, solved.solution, setup.locator,
                              solved.threads(), stopping(hooks));
  if (!solved.input.sensors.empty()) hooks.begins("sensors");
  if (sees_along_rays(solved)) rays_of(solved);
  result.sensors = read_sensors(
      solved.input.sensors, {setup.lights, tally, setup.options, solved.solution, solved.rays, setup.locator},
      stopping(hooks));
  throw_if_stopped(hooks);
}

}  // namespace etendue::v0
