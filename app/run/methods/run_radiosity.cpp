// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/run/methods/run_radiosity.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "app/setup/method_checks.h"
#include "app/setup/run_context.h"
#include "base/errors.h"
#include "base/parallel/parallel_for.h"

namespace etendue {
namespace {

// A probe on a wall sees the light in front of that wall: it is moved so far towards its cell's middle.
constexpr double off_the_wall = 1e-6;
// From a probe, where something may stand between.
constexpr int rays_to_a_patch = 64;
// Where light is redirected: a probe looks around along so many times the rays of a patch.
constexpr int path_rays_of_probe = 16;

std::vector<ProbeRow> probes_of(const RadiosityScene& scene, const WallLightField& field, int threads) {
  std::vector<ProbeRow> rows;
  std::vector<std::optional<Vec3>> normals;
  for (const Probe& place : scene.input.probes)
    for (std::size_t i = 0; i < place.points.size(); ++i) {
      rows.push_back({place.name, static_cast<int>(i), place.points[i], {}, {}});
      normals.push_back(place.normal);
    }
  ShownStage stage(scene.stages, "probes");
  StageCounter counter(rows.size(), stage.observer());
  const TetrahedralMesh& mesh = scene.lights.problem().mesh();
  parallel_for(rows.size(), threads, 1, [&](std::size_t i) {
    ProbeRow& row = rows[i];
    const Vec3 middle = mesh.centroid(scene.locator.find(row.point).front().cell);
    const WallLightValue value = field.at(row.point + off_the_wall * (middle - row.point), normals[i]);
    for (std::size_t b = 0; b < value.fluence.size(); ++b) {
      const Vec3& flux = value.net_flux[b];
      row.values.push_back({value.fluence[b], {flux[0], flux[1], flux[2]}});
    }
    if (normals[i]) row.irradiance = value.irradiance;
    return counter.add();
  });
  std::erase_if(rows, [](const ProbeRow& row) { return row.values.empty(); });
  return rows;
}

SavedState state_to_look_at(const RadiosityRoom& room, const RadiosityScene& scene) {
  const Problem& problem = scene.lights.problem();
  const TetrahedralMesh& mesh = problem.mesh();
  std::vector<bool> followed;
  for (std::size_t w = 0; w < problem.walls().size(); ++w)
    followed.push_back(scene.lights.has_wall(static_cast<int>(w)));
  std::vector<double> half_range;
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f)
    half_range.push_back(scene.directions.half_range(mesh.area_normal(FaceIndex(f)).normalized()));
  return room.state(followed, half_range);
}

/// Of light that a medium scatters, which there is none of here.
void check_views_of_radiosity(const Case& input) {
  std::vector<Fault> faults;
  for (const SensorCase& sensor : input.sensors)
    if (!sensor.region.empty())
      faults.push_back(fault_at(sensor.origin, "",
                                "a sensor of a region in a run by radiosity, which has no directions of "
                                "light to count; use solve.method = \"auto\""));
  for (const CameraCase& camera : input.cameras)
    if (camera.camera.errors)
      faults.push_back(fault_at(camera.origin, "",
                                "errors = true in a run by radiosity (its layers are of light that a medium "
                                "scatters, and there is none); take it out"));
  if (!faults.empty()) throw InputError(std::move(faults));
}

/// The share that is done from the first residual to the tolerance, on a logarithmic scale.
double share_of_passes(double first, double now, double tolerance) {
  if (now <= tolerance) return 1;
  return first > now ? std::log(first / now) / std::log(first / tolerance) : 0;
}

}  // namespace

void check_for_radiosity(const Case& input, const Problem& problem) {
  refuse_for_radiosity(problem);
  check_views_of_radiosity(input);
  refuse_what_needs_ordinates(input, "radiosity has",
                              "its source lies in the domain, and radiosity knows walls alone");
  if (input.initial)
    throw InputError(
        fault_at(input.initial->origin, input.initial->path.string(),
                 "radiosity starts from nothing (its passes are those of the light); take it out"));
}

RadiosityOptions radiosity_options(const Case& input, int threads) {
  RadiosityOptions options;
  options.patch_size = input.radiosity->patch_size;
  options.refinement = {input.radiosity->refine_change, input.radiosity->smallest_patch};
  options.method = input.radiosity->solution;
  options.rays = input.radiosity->rays;
  options.link_tolerance = input.radiosity->link_tolerance;
  options.path_rays = input.radiosity->path_rays;
  options.limits = {input.solve.tolerance, input.solve.max_sweeps};
  options.threads = threads;
  return options;
}

std::string radiosity_memory_text(const RadiosityMemory& memory) {
  constexpr double mebibyte = 1024.0 * 1024.0;
  if (memory.links > 0)
    return fmt::format("patches: {}; some {:.2g} links between groups of them take {:.3g} MiB\n",
                       memory.patches, static_cast<double>(memory.links),
                       static_cast<double>(ExchangeLinks::bytes_of(memory.links)) / mebibyte);
  const double matrix = static_cast<double>(ExchangeMatrix::bytes_of(memory.patches)) / mebibyte;
  return fmt::format("patches: {}; their matrix would take {:.3g} MiB and is {}\n", memory.patches, matrix,
                     memory.kept ? "kept" : "made anew in each pass");
}

RadiosityRun run_radiosity(const RadiosityScene& scene, RadiosityRoom& room, const FactorProgress& of_cells) {
  const Case& input = scene.input;
  const Problem& problem = scene.lights.problem();
  const bool finer = are_finer_than_faces(room.patches());
  std::optional<ShownStage> passing(std::in_place, scene.stages, "light from wall to wall");
  const StageObserver of_passes = passing->observer();
  double first_residual = 0;
  RadiosityRun run;
  run.solution = room.solve(
      [&](const RadiosityState& state) {
        if (run.passes.size() < static_cast<std::size_t>(input.radiosity->passes)) {
          room.fields_on_walls(state, run.passes.emplace_back());
          if (finer) run.pass_patches.push_back(light_on_patches(problem, room.patches(), state));
        }
        scene.interruption.note_the_first();
        const double left = *std::ranges::max_element(state.residual);
        if (first_residual <= 0) first_residual = left;
        of_passes(share_of_passes(first_residual, left, input.solve.tolerance));
        return !scene.interruption.noted();
      },
      [&](double done) {
        passing.reset();
        if (scene.interruption.is_overdue()) throw RadiosityStopped{};
        of_cells(done);
      });
  passing.reset();
  if (finer) run.patches = light_on_patches(problem, room.patches(), room.solved());
  run.solution.state = state_to_look_at(room, scene);
  run.report = room.report();
  // Pictures and sensors follow these walls along rays.
  if (!input.cameras.empty() || !input.sensors.empty()) run.solution.notes = scene.lights.notes();
  Stopwatch watch;
  if (!input.probes.empty())
    run.probes =
        probes_of(scene, room.light(rays_to_a_patch, path_rays_of_probe * input.radiosity->path_rays),
                  thread_count(input));
  run.probe_seconds = watch.lap();
  return run;
}

}  // namespace etendue
