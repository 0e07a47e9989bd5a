// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/render/saved_scene.h"

#include <algorithm>
#include <thread>

#include "app/case/build/build.h"
#include "app/case/build/build_heat.h"
#include "app/readings/probes.h"
#include "app/write/json/summary.h"
#include "app/write/vtk/solution_file.h"
#include "solver/heat/temperature_iteration.h"

namespace etendue {
namespace {

SolveOptions options_of_run(const Case& input, const std::filesystem::path& results,
                            std::optional<int> threads, const TetrahedralMesh& mesh) {
  SolveOptions options = input.solve;
  if (threads) options.threads = *threads;
  if (options.threads == 0)
    options.threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  // Of directions alone do probes decide what was kept.
  if (input.radiosity) return options;
  const std::optional<Case> saved = case_of_results(results, {});
  options.meters = place_probes(saved ? saved->probes : input.probes, mesh, CellLocator(mesh));
  return options;
}

/// With the emission of the temperatures that a run has found.
Problem problem_of_run(const Case& input, const TetrahedralMesh& mesh, const SavedState& state) {
  Problem problem = build_problem(input, mesh);
  const std::optional<HeatProblem> heat = build_heat(input, mesh);
  if (!heat) return problem;
  if (state.following.empty())
    throw InputError(
        "solution.vtu was written without the temperatures that follow (by an earlier version); run the case "
        "again");
  TemperatureIteration temperatures(problem, *heat);
  temperatures.start_from(state.following);
  problem.set_following(temperatures.sources());
  return problem;
}

}  // namespace

std::optional<Case> case_of_results(const std::filesystem::path& results, const Overrides& overrides) {
  const std::optional<SavedCase> saved = case_of_earlier_run(results);
  if (!saved) return std::nullopt;
  return read_case_text(saved->toml, saved->file, overrides);
}

SavedScene::SavedScene(Case asked, const std::filesystem::path& results, const std::string& command,
                       std::optional<int> threads, const Log& log)
    : input(std::move(asked)),
      mesh(build_mesh(input, log)),
      result(read_result(InputFile{results / "solution.vtu", {"command line", 0, command}}, input, mesh)),
      state(result.state),
      problem(problem_of_run(input, mesh, state)),
      directions(build_directions(input, problem)),
      lights(problem),
      options(options_of_run(input, results, threads, mesh)) {}

}  // namespace etendue
