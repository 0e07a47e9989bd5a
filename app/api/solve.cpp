// SPDX-License-Identifier: AGPL-3.0-or-later
#include <etendue/solve.h>

#include "app/api/case_impl.h"
#include "app/api/mesh_impl.h"
#include "app/api/solution_impl.h"
#include "app/api/translated.h"
#include "app/case/build/build.h"
#include "app/case/build/mesh_names.h"
#include "app/run/check_run.h"

namespace etendue::v0 {
namespace {

/// The case as it is solved: with the threads that the settings ask for, and without checkpoints.
etendue::Case case_to_solve(const Case& input, const SolveSettings& settings) {
  etendue::Case result = input.impl().input;
  if (settings.threads > 0) result.solve.threads = settings.threads;
  result.output.checkpoint_every = 0;
  return result;
}

SolveHooks hooks_of(const SolveSettings& settings) {
  return {[&settings](const std::string& stage) {
            if (settings.progress) settings.progress({.stage = stage, .residual = {}});
            if (settings.stop && settings.stop()) throw Stopped("stopped: there is no solution");
          },
          [&settings](const SweepProgress& sweep) {
            return !settings.progress ||
                   settings.progress({"sweeps", sweep.sweep, sweep.residual, sweep.tolerance, sweep.seconds,
                                      sweep.seconds_left});
          },
          settings.stop};
}

void solve_by_its_method(SolvedCase& solved, const SolveHooks& hooks) {
  if (solved.input.photons) return solve_by_photons(solved, hooks);
  if (solved.input.radiosity) return solve_by_radiosity(solved, hooks);
  solve_by_ordinates(solved, hooks);
}

}  // namespace

Solution solve(const Case& input, const SolveSettings& settings) {
  hooks_of(settings).begins("meshing");
  return solve(input, input.mesh(), settings);
}

Solution solve(const Case& input, const Mesh& mesh, const SolveSettings& settings) {
  return translated([&] {
    check_names(input.impl().input, names_of(*mesh.impl().mesh));
    auto impl = std::make_shared<Solution::Impl>(
        std::make_unique<SolvedCase>(case_to_solve(input, settings), mesh.impl().mesh), mesh);
    solve_by_its_method(*impl->solved, hooks_of(settings));
    return Solution(std::move(impl));
  });
}

void check(const Case& input, const Mesh& mesh) {
  translated([&] {
    check_names(input.impl().input, names_of(*mesh.impl().mesh));
    check_run(input.impl().input, build_problem(input.impl().input, *mesh.impl().mesh));
  });
}

}  // namespace etendue::v0
