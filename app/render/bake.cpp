// SPDX-License-Identifier: AGPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "app/case/build/open_walls.h"
#include "app/progress/interruption.h"
#include "app/progress/progress.h"
#include "app/progress/stage_progress.h"
#include "app/render/saved_scene.h"
#include "app/request/commands.h"
#include "app/request/verbose_log.h"
#include "app/write/json/summary.h"
#include "app/write/result/output_folder.h"
#include "app/write/result/unit_labels.h"
#include "app/write/vtk/baked_surface.h"
#include "solver/observe/camera/gather.h"
#include "solver/observe/color/tone.h"

namespace etendue {
namespace {

Case case_to_bake(const BakeRequest& request) {
  if (auto saved = case_of_results(request.results, {})) return *std::move(saved);
  throw FileError((request.results / "summary.json").string(),
                  "holds no case of an earlier run; name the directory of its results");
}

/// The numbers of the walls that are the sky: those named, else the outer ones that neither shine nor
/// reflect.
std::vector<int> sky_walls(const BakeRequest& request, const Problem& problem) {
  std::vector<int> walls;
  std::vector<std::string> names;
  if (request.sky.empty()) walls = open_walls(problem.mesh(), problem.walls());
  for (std::size_t w = 0; w < problem.walls().size(); ++w) {
    names.push_back(problem.walls()[w].name);
    if (std::ranges::count(request.sky, names.back()) > 0) walls.push_back(static_cast<int>(w));
  }
  for (const std::string& name : request.sky)
    if (std::ranges::count(names, name) == 0)
      throw InputError(
          fmt::format("command line: bake: --sky = {}: no such wall; use {}", name, fmt::join(names, ", ")));
  if (walls.empty())
    throw InputError(
        fmt::format("command line: bake: no wall is open to the sky (all outer ones shine or reflect); use "
                    "--sky with one of {}",
                    fmt::join(names, ", ")));
  return walls;
}

/// What directions brought to the walls, as the solution has it, or looked for by rays.
WallIrradiance brought(const BakeRequest& request, const SavedScene& scene, const StageObserver& observer) {
  const SolveOptions& options = scene.options;
  if (request.gather == 0)
    return WallLight(scene.lights, scene.directions, scene.state, options.order == SpaceOrder::linear ? 3 : 1)
        .brought();
  const RayRadiance radiance(scene.lights, scene.directions, options, scene.state, options.threads);
  return gather(radiance, request.gather, fine_shadow_rays, options.threads, observer);
}

/// Numbers at places, and how they are shown.
struct Baked {
  std::vector<std::string> names;
  std::vector<double> values;       ///< [place][name]
  std::vector<LinearColor> colors;  ///< [place], not exposed yet
};

/// Bakes at any places of the walls, with progress. After an interruption what it gives is empty.
class Baker {
 public:
  Baker(const BakeRequest& request, const SavedScene& scene, const Interruption& interruption,
        std::ostream& out)
      : request_(request), scene_(scene), interruption_(interruption), out_(out) {
    if (request.quantity == BakedQuantity::occlusion)
      sky_ = sky_walls(request, scene.problem);
    else
      observed("looking for the light of walls",
               [&](const StageObserver& observer) { brought_ = brought(request, scene, observer); });
  }

  std::string name() const {
    if (request_.quantity == BakedQuantity::occlusion) return "occlusion";
    return request_.quantity == BakedQuantity::radiosity ? "radiosity" : "irradiance";
  }
  std::string unit() const {
    return request_.quantity == BakedQuantity::occlusion ? "" : UnitLabels(scene_.input.units).flux;
  }

  /// `where` the places are, "4961 vertices".
  Baked at(const std::vector<BakePlace>& places, const std::string& where) const {
    Baked baked;
    observed(fmt::format("baking {} at {}", name(), where), [&](const StageObserver& observer) {
      baked = request_.quantity == BakedQuantity::occlusion ? occlusion(places, observer)
                                                            : light(places, observer);
    });
    return baked;
  }

  /// What colours are multiplied by, from those at the vertices.
  double exposure(const std::vector<LinearColor>& colors) const {
    return request_.quantity == BakedQuantity::occlusion ? 1 : automatic_exposure(colors);
  }
  std::string comment(double exposure) const {
    if (request_.quantity == BakedQuantity::occlusion) return "sky visibility: 1 less the ambient occlusion";
    return fmt::format("{} [{}]; colours are it times {:.6g}: {}", name(), unit(), exposure,
                       BandColor(scene_.problem.bands()).rule());
  }

 private:
  /// Does something that takes its time and shows how it goes on.
  template <class Do>
  void observed(const std::string& what, const Do& do_it) const {
    ShownStage stage(
        {resolved_style(request_.progress, out_), out_, [this] { return interruption_.noted(); }}, what);
    do_it(stage.observer());
  }

  /// Visibility as grey.
  Baked occlusion(const std::vector<BakePlace>& places, const StageObserver& observer) const {
    Baked baked{{"sky_visibility"},
                bake_sky_visibility(places, scene_.mesh, sky_, scene_.options.threads, observer),
                {}};
    for (const double value : baked.values) baked.colors.push_back({value, value, value});
    return baked;
  }

  Baked light(const std::vector<BakePlace>& places, const StageObserver& observer) const {
    if (interruption_.noted()) return {};
    Baked baked{{}, bake_irradiance(places, scene_.lights, brought_, scene_.options.threads, observer), {}};
    if (baked.values.empty()) return {};
    if (request_.quantity == BakedQuantity::radiosity)
      baked.values = bake_radiosity(places, scene_.problem, baked.values);
    const std::vector<std::string>& bands = scene_.problem.bands().names;
    const BandColor rule(scene_.problem.bands());
    const WhiteBalance white(scene_.problem.bands());
    for (const std::string& band : bands)
      baked.names.push_back(name() + (bands.size() > 1 ? "_" + band : ""));
    for (std::size_t at = 0; at < baked.values.size(); at += bands.size())
      baked.colors.push_back(white.of(rule.of(std::span(baked.values).subspan(at, bands.size()))));
    return baked;
  }

  const BakeRequest& request_;
  const SavedScene& scene_;
  const Interruption& interruption_;
  std::ostream& out_;
  std::vector<int> sky_;
  WallIrradiance brought_;
};

void expose(double exposure, std::vector<LinearColor>& colors) {
  for (LinearColor& color : colors)
    for (double& value : color) value *= exposure;
}

/// A texture that was asked for, on its way to files.
struct Texture {
  WallAtlas atlas;
  Baked baked;
};

std::optional<Texture> texture_of(const BakeRequest& request, const SavedScene& scene, const Baker& baker,
                                  const WallSurface& surface, double exposure) {
  if (request.texture == 0) return std::nullopt;
  Texture texture{wall_atlas(surface, scene.mesh, request.texture), {}};
  texture.baked = baker.at(texture.atlas.places, fmt::format("{} pixels", texture.atlas.places.size()));
  expose(exposure, texture.baked.colors);
  return texture;
}

void add_texture(Texture texture, const std::string& name, const std::string& comment,
                 const WallSurface& surface, OutputFolder& folder) {
  const BakedTexture baked{surface,
                           texture.atlas,
                           std::move(texture.baked.names),
                           std::move(texture.baked.values),
                           std::move(texture.baked.colors),
                           comment};
  folder.add_text(name + ".texture.glb", textured_glb_bytes(baked));
  folder.add_text(name + ".texture.png", texture_png(baked));
  folder.add_text(name + ".texture.exr", texture_exr(baked));
}

}  // namespace

ExitCode bake_results(const BakeRequest& request, std::ostream& out, std::ostream& err) {
  Interruption interruption;
  const std::filesystem::path directory = request.output.value_or(request.results);
  check_output_directory(directory);
  Case input = case_to_bake(request);
  out << "reading " << request.results.string() << std::endl;
  const SavedScene scene(std::move(input), request.results, "bake", request.threads,
                         verbose_log(request, err));
  if (scene.problem.space() == AngularSpace::plane)
    throw InputError("command line: bake: not in flatland (not in this version)");
  for (const Wall& wall : scene.problem.walls())
    if (request.quantity == BakedQuantity::radiosity && (wall.is_glossy() || wall.transmits()))
      throw InputError(
          fmt::format("command line: bake: what the wall {} sends is not its diffuse reflectance times what "
                      "it receives (it is glossy or lets light through); bake the irradiance",
                      wall.name));
  const WallSurface surface = wall_surface(scene.mesh);
  // Until light is looked for at the places a signal ends the program at once.
  const Baker baker(request, scene, interruption, out);
  interruption.note_the_first();
  Baked at_vertices =
      baker.at(vertex_places(surface, scene.mesh), fmt::format("{} vertices", surface.vertices.size()));
  const double exposure = baker.exposure(at_vertices.colors);
  std::optional<Texture> texture = texture_of(request, scene, baker, surface, exposure);
  if (interruption.noted()) {
    err << "interrupted: nothing was written\n";
    return ExitCode::interrupted;
  }
  interruption.note_all();
  expose(exposure, at_vertices.colors);
  const BakedSurface baked{surface, std::move(at_vertices.names), std::move(at_vertices.values),
                           std::move(at_vertices.colors), baker.comment(exposure)};
  OutputFolder folder(directory);
  const std::string name = baker.name();
  folder.add_text(name + ".ply", ply_bytes(baked));
  folder.add_text(name + ".glb", glb_bytes(baked));
  write_baked(baked, baker.unit(), scene.input, folder.add(name + ".vtp"), directory / (name + ".vtp"));
  if (texture) add_texture(*std::move(texture), name, baked.comment, surface, folder);
  const std::vector<std::string> names = folder.names();
  folder.lock();
  const std::string summary = summary_with_files(directory, names);
  if (!summary.empty()) folder.add_text("summary.json", summary);
  folder.publish({});
  out << fmt::format("baked {} at {} vertices of {} faces\n  {}\nwritten to {}: {}\n", name,
                     surface.vertices.size(), surface.triangles.size(), baked.comment, directory.string(),
                     fmt::join(names, " "));
  return ExitCode::done;
}

}  // namespace etendue
