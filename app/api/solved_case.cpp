// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/api/solved_case.h"

#include <etendue/errors.h>

#include <chrono>

#include "app/case/build/build.h"
#include "app/setup/run_context.h"

namespace etendue::v0 {

SolvedCase::SolvedCase(etendue::Case given, std::shared_ptr<const TetrahedralMesh> on)
    : input(std::move(given)), mesh(std::move(on)), problem(build_problem(input, *mesh)), locator(*mesh) {}

int SolvedCase::threads() const { return thread_count(input); }

const LightSetup* SolvedCase::lights() const {
  if (ordinates) return &ordinates->lights;
  return radiosity ? &radiosity->lights : nullptr;
}

void throw_if_stopped(const SolveHooks& hooks) {
  if (hooks.stop && hooks.stop()) throw Stopped("stopped: there is no solution");
}

RunResult measured(const SolvedCase& solved) {
  RunResult result{.input = solved.input,
                   .problem = solved.problem,
                   .solution = solved.solution,
                   .probes = {},
                   .balances = balances(solved.problem, solved.solution),
                   .walls = wall_powers(solved.problem, solved.solution),
                   .regions = region_powers(solved.problem, solved.solution),
                   .seconds = {},
                   .threads = solved.threads()};
  result.record.begun = std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now());
  return result;
}

const RayRadiance& rays_of(SolvedCase& solved) {
  if (solved.rays) return *solved.rays;
  if (solved.ordinates)
    return solved.rays.emplace(solved.ordinates->lights, solved.ordinates->set(), solved.ordinates->options,
                               solved.solution.state, solved.threads(), WallValues::joined,
                               solved.first_collisions);
  const RadiosityViews& views = *solved.radiosity;
  return solved.rays.emplace(views.lights, views.directions, views.options, solved.solution.state,
                             solved.threads());
}

}  // namespace etendue::v0
