// SPDX-License-Identifier: AGPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <thread>

#include "app/case/build.h"
#include "app/command/commands.h"
#include "app/command/interruption.h"
#include "app/command/pictures.h"
#include "app/command/probes.h"
#include "app/command/progress.h"
#include "app/command/verbose_log.h"
#include "app/write/output_folder.h"
#include "app/write/solution_file.h"
#include "app/write/summary.h"

namespace etendue {
namespace {

std::optional<Case> saved_case(const RenderRequest& request, const Overrides& overrides) {
  const std::optional<SavedCase> saved = case_of_earlier_run(request.results);
  if (!saved) return std::nullopt;
  return read_case_text(saved->toml, saved->file, overrides);
}

/// The case whose cameras are meant: the one given, else that of the results.
Case case_to_render(const RenderRequest& request) {
  if (!request.file.empty()) return read_case(request.file, request.overrides);
  if (auto saved = saved_case(request, request.overrides)) return *std::move(saved);
  throw FileError(
      (request.results / "summary.json").string(),
      "holds no case of an earlier run; name the directory of its results, or the case with --case");
}

std::vector<CameraCase> chosen_cameras(const RenderRequest& request, const Case& input) {
  std::string names;
  for (const CameraCase& camera : input.cameras) names += (names.empty() ? "" : ", ") + camera.name;
  if (input.cameras.empty())
    throw InputError(
        "command line: render: the case has no [[camera]]; add one and name the case with --case");
  if (request.cameras.empty()) return input.cameras;
  std::vector<CameraCase> chosen;
  for (const std::string& name : request.cameras) {
    const auto found = std::ranges::find(input.cameras, name, &CameraCase::name);
    if (found == input.cameras.end())
      throw InputError("command line: render: --camera = " + name + ": no such camera; use " + names);
    chosen.push_back(*found);
  }
  return chosen;
}

/// As the run had them: its probes decide in which cells moments were kept.
SolveOptions options_of_run(const RenderRequest& request, const Case& input, const TetrahedralMesh& mesh) {
  SolveOptions options = input.solve;
  if (request.threads) options.threads = *request.threads;
  if (options.threads == 0)
    options.threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  const std::optional<Case> saved = saved_case(request, {});
  options.meters = place_probes(saved ? saved->probes : input.probes, mesh, CellLocator(mesh));
  return options;
}

}  // namespace

ExitCode render_results(const RenderRequest& request, std::ostream& out, std::ostream& err) {
  Interruption interruption;
  const Case input = case_to_render(request);
  const std::vector<CameraCase> cameras = chosen_cameras(request, input);
  const std::filesystem::path directory = request.output.value_or(request.results);
  check_output_directory(directory);
  const TetrahedralMesh mesh = build_mesh(input, verbose_log(request, err));
  const Problem problem = build_problem(input, mesh);
  check_cameras(cameras, problem);
  const DirectionSet directions = build_directions(input);
  const LightSetup lights(problem);
  const SolveOptions options = options_of_run(request, input, mesh);
  const InputFile solution{request.results / "solution.vtu", {"command line", 0, "render"}};
  const SavedState state = read_initial(solution, input, mesh);
  interruption.note_the_first();
  const bool done =
      write_pictures(input, cameras, {lights, directions, options, state}, directory,
                     resolved_style(request.progress, out), out, [&] { return interruption.noted(); });
  if (done) return ExitCode::done;
  err << "interrupted: no picture was written\n";
  return ExitCode::interrupted;
}

}  // namespace etendue
