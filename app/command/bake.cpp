// SPDX-License-Identifier: AGPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "app/command/commands.h"
#include "app/command/pictures.h"
#include "app/command/saved_scene.h"
#include "app/command/verbose_log.h"
#include "app/write/baked_surface.h"
#include "app/write/output_folder.h"
#include "app/write/summary.h"
#include "app/write/unit_labels.h"
#include "solver/picture/gather.h"
#include "solver/picture/tone.h"

namespace etendue {
namespace {

Case case_to_bake(const BakeRequest& request) {
  if (auto saved = case_of_results(request.results, {})) return *std::move(saved);
  throw FileError((request.results / "summary.json").string(),
                  "holds no case of an earlier run; name the directory of its results");
}

/// The numbers of the walls that are the sky: those named, else all that neither shine nor reflect.
std::vector<int> sky_walls(const BakeRequest& request, const Problem& problem) {
  const auto zero = [](const std::vector<double>& values) {
    return std::ranges::all_of(values, [](double v) { return v == 0; });
  };
  std::vector<int> walls;
  std::vector<std::string> names;
  for (std::size_t w = 0; w < problem.walls().size(); ++w) {
    const Wall& wall = problem.walls()[w];
    names.push_back(wall.name);
    const bool bare = zero(wall.radiance) && zero(wall.diffuse) && zero(wall.specular);
    if (request.sky.empty() ? bare : std::ranges::count(request.sky, wall.name) > 0)
      walls.push_back(static_cast<int>(w));
  }
  for (const std::string& name : request.sky)
    if (std::ranges::count(names, name) == 0)
      throw InputError(
          fmt::format("command line: bake: --sky = {}: no such wall; use {}", name, fmt::join(names, ", ")));
  if (walls.empty())
    throw InputError(
        fmt::format("command line: bake: no wall is open to the sky (all of them shine or reflect); use "
                    "--sky with one of {}",
                    fmt::join(names, ", ")));
  return walls;
}

/// Visibility as grey.
BakedSurface occlusion(const BakeRequest& request, const SavedScene& scene, const WallSurface& surface) {
  BakedSurface baked{surface, {"sky_visibility"}, {}, {}, "sky visibility: 1 less the ambient occlusion"};
  baked.values =
      bake_sky_visibility(surface, scene.mesh, sky_walls(request, scene.problem), scene.options.threads);
  for (const double value : baked.values) baked.colors.push_back({value, value, value});
  return baked;
}

/// What directions brought to the walls, as the solution has it, or looked for by rays.
WallIrradiance brought(const BakeRequest& request, const SavedScene& scene) {
  const SolveOptions& options = scene.options;
  if (request.gather == 0)
    return WallLight(scene.lights, scene.directions, scene.state, options.order == SpaceOrder::linear ? 3 : 1)
        .joined();
  const RayRadiance radiance(scene.lights, scene.directions, options, scene.state, options.threads);
  return gather(radiance, request.gather, options.threads);
}

BakedSurface light(const BakeRequest& request, const SavedScene& scene, const WallSurface& surface) {
  BakedSurface baked{surface, {}, {}, {}, ""};
  baked.values = bake_irradiance(surface, scene.lights, brought(request, scene), scene.options.threads);
  if (request.quantity == BakedQuantity::radiosity)
    baked.values = bake_radiosity(surface, scene.problem, baked.values);
  const std::string quantity = request.quantity == BakedQuantity::radiosity ? "radiosity" : "irradiance";
  const std::vector<std::string>& bands = scene.problem.bands().names;
  const BandColor rule(scene.problem.bands());
  for (const std::string& band : bands)
    baked.names.push_back(quantity + (bands.size() > 1 ? "_" + band : ""));
  for (std::size_t at = 0; at < baked.values.size(); at += bands.size())
    baked.colors.push_back(rule.of(std::span(baked.values).subspan(at, bands.size())));
  const double exposure = automatic_exposure(baked.colors);
  for (LinearColor& color : baked.colors)
    for (double& value : color) value *= exposure;
  baked.comment = fmt::format("{} [{}]; colours are it times {:.6g}: {}", quantity,
                              UnitLabels(scene.input.units).flux, exposure, rule.rule());
  return baked;
}

}  // namespace

ExitCode bake_results(const BakeRequest& request, std::ostream& out, std::ostream& err) {
  const std::filesystem::path directory = request.output.value_or(request.results);
  check_output_directory(directory);
  const SavedScene scene(case_to_bake(request), request.results, "bake", request.threads,
                         verbose_log(request, err));
  if (scene.problem.space() == AngularSpace::plane)
    throw InputError("command line: bake: not in flatland (not in this version)");
  const WallSurface surface = wall_surface(scene.mesh);
  const bool sky = request.quantity == BakedQuantity::occlusion;
  const BakedSurface baked = sky ? occlusion(request, scene, surface) : light(request, scene, surface);
  const std::string name = sky                                            ? "occlusion"
                           : request.quantity == BakedQuantity::radiosity ? "radiosity"
                                                                          : "irradiance";
  OutputFolder folder(directory);
  folder.add_text(name + ".ply", ply_bytes(baked));
  folder.add_text(name + ".glb", glb_bytes(baked));
  const std::string summary = summary_with_files(directory, folder.names());
  if (!summary.empty()) folder.add_text("summary.json", summary);
  folder.publish({});
  out << fmt::format("baked {} at {} vertices of {} faces\n  {}\nwritten to {}: {}.ply {}.glb\n", name,
                     surface.vertices.size(), surface.triangles.size(), baked.comment, directory.string(),
                     name, name);
  return ExitCode::done;
}

}  // namespace etendue
