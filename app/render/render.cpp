// SPDX-License-Identifier: AGPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "app/case/build/build.h"
#include "app/progress/interruption.h"
#include "app/progress/progress.h"
#include "app/progress/stage_progress.h"
#include "app/render/photon_pictures.h"
#include "app/render/pictures.h"
#include "app/render/saved_scene.h"
#include "app/request/commands.h"
#include "app/request/verbose_log.h"
#include "app/setup/memory.h"
#include "app/setup/run_context.h"
#include "app/write/result/output_folder.h"
#include "solver/photons/solve/photon_mesh.h"

namespace etendue {
namespace {

/// The case whose cameras are meant: the one given, else that of the results.
Case case_to_render(const RenderRequest& request) {
  if (!request.file.empty()) return read_case(request.file, request.overrides);
  if (auto saved = case_of_results(request.results, request.overrides)) return *std::move(saved);
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

ExitCode outcome(bool done, std::ostream& err) {
  if (done) return ExitCode::done;
  err << "interrupted: no picture was written\n";
  return ExitCode::interrupted;
}

/// Pictures by photons: nothing of the results is needed, since the same histories are walked again.
ExitCode render_by_photons(const RenderRequest& request, Case input, const std::vector<CameraCase>& cameras,
                           Interruption& interruption, std::ostream& out, std::ostream& err) {
  if (request.threads) input.solve.threads = *request.threads;
  const TetrahedralMesh mesh = build_mesh(input, verbose_log(request, err));
  const Problem problem = build_problem(input, mesh);
  refuse_for_photons(problem);
  check_photon_cameras(cameras, problem);
  const int threads = thread_count(input);
  const HitMemory memory = estimate_photon_map_memory(input, problem, threads);
  out << check_memory(memory.most, mesh, problem.band_count(), "", memory.expected);
  interruption.note_the_first();
  const std::filesystem::path directory = request.output.value_or(request.results);
  const std::function<bool()> interrupted = [&] { return interruption.noted(); };
  return outcome(write_photon_pictures(
                     {input, cameras, directory, resolved_style(request.progress, out), out, interrupted},
                     problem, CellLocator(mesh), threads),
                 err);
}

}  // namespace

ExitCode render_results(const RenderRequest& request, std::ostream& out, std::ostream& err) {
  Interruption interruption;
  Case input = case_to_render(request);
  const std::vector<CameraCase> cameras = chosen_cameras(request, input);
  const std::filesystem::path directory = request.output.value_or(request.results);
  check_output_directory(directory);
  if (input.photons) return render_by_photons(request, std::move(input), cameras, interruption, out, err);
  out << "reading " << request.results.string() << std::endl;
  const SavedScene saved(std::move(input), request.results, "render", request.threads,
                         verbose_log(request, err));
  check_views(cameras, {}, saved.problem);
  out << fmt::format("preparing light along rays in {} cells", saved.mesh.cell_count()) << std::endl;
  // A signal before the first picture ends the program at once.
  const ProgressStyle style = resolved_style(request.progress, out);
  std::optional<ShownStage> following(std::in_place, StageDisplay{style, out, {}},
                                      "light before its first collision");
  const auto first = find_first_collisions(saved.lights, saved.options.threads, following->observer());
  following.reset();
  const RayRadiance scene(saved.lights, saved.directions, saved.options, saved.state, saved.options.threads,
                          WallValues::joined, first);
  const ErrorImages errors(cameras, saved.lights, saved.directions, saved.options, saved.state,
                           saved.result.direction_error, first);
  interruption.note_the_first();
  const bool done = write_pictures(saved.input, cameras, scene, errors, saved.options.threads, directory,
                                   style, out, [&] { return interruption.noted(); });
  return outcome(done, err);
}

}  // namespace etendue
