// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/render/saved_scene.h"

#include <algorithm>
#include <thread>

#include "app/case/build/build.h"
#include "app/case/temperatures.h"
#include "app/readings/probes.h"
#include "app/write/json/summary.h"
#include "app/write/vtk/solution_file.h"

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

/// Saved results hold no emission of media whose temperatures followed.
Case with_given_temperatures(Case input) {
  if (!iterates_temperatures(input)) return input;
  throw InputError(
      "the temperatures of this case follow by iteration, and pictures of its saved results cannot be made "
      "(not in this version); "
      "run the case with its cameras");
}

}  // namespace

std::optional<Case> case_of_results(const std::filesystem::path& results, const Overrides& overrides) {
  const std::optional<SavedCase> saved = case_of_earlier_run(results);
  if (!saved) return std::nullopt;
  return read_case_text(saved->toml, saved->file, overrides);
}

SavedScene::SavedScene(Case asked, const std::filesystem::path& results, const std::string& command,
                       std::optional<int> threads, const Log& log)
    : input(with_given_temperatures(std::move(asked))),
      mesh(build_mesh(input, log)),
      problem(build_problem(input, mesh)),
      directions(build_directions(input, problem)),
      lights(problem),
      options(options_of_run(input, results, threads, mesh)),
      result(read_result(InputFile{results / "solution.vtu", {"command line", 0, command}}, input, mesh)),
      state(result.state) {}

}  // namespace etendue
