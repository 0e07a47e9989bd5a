// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/render/pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "app/progress/stage_progress.h"
#include "base/wall_clock.h"
#include "solver/problem/any_formula.h"

namespace etendue {
namespace {

/// A kernel by a formula or a file is known at the ordinates alone.
bool has_kernel(const Medium& medium) {
  for (std::size_t band = 0; band < medium.directional.size(); ++band)
    if (medium.is_directional(static_cast<int>(band)) && !is_seen_by_rays(medium.directional[band]))
      return true;
  return false;
}

/// Whether something absorbs or emits by a formula of the direction.
bool uses_formulas(const Problem& problem) {
  return std::ranges::any_of(problem.media(), [](const Medium& medium) {
    return any_formula(medium.absorption_by_direction) || any_formula(medium.emission_by_direction);
  });
}

/// False where it was interrupted.
bool add_errors(const ErrorImages& errors, int threads, const StageDisplay& stages, NamedPicture& named) {
  for (const auto& [of, scene] :
       {std::pair("cells", errors.of_cells()), std::pair("directions", errors.of_directions())}) {
    if (scene == nullptr) continue;
    ShownStage stage(stages, fmt::format("errors of {} in picture {}", of, named.camera.name));
    Picture error = take_picture(*scene, named.camera.camera, threads, stage.observer());
    if (!error.whole) return false;
    for (std::size_t i = 0; i < error.radiance.size(); ++i)
      error.radiance[i] = std::abs(error.radiance[i] - named.picture.radiance[i]);
    named.errors.push_back({of, std::move(error)});
  }
  return true;
}

/// There are no rays: what reads ordinates works.
void check_views_in_plane(const std::vector<CameraCase>& cameras, const std::vector<SensorCase>& sensors) {
  std::vector<Fault> faults;
  for (const CameraCase& camera : cameras)
    faults.push_back(fault_at(camera.origin, "", "a camera in flatland (not in this version); remove it"));
  for (const SensorCase& sensor : sensors) {
    const SensorKind kind = sensor.sensor.kind;
    const bool flux = kind == SensorKind::flux && sensor.sensor.polygon.empty();
    if (flux || kind == SensorKind::region || kind == SensorKind::irradiance || kind == SensorKind::fluence)
      continue;
    faults.push_back(fault_at(sensor.origin, "",
                              "a sensor of this kind in flatland (not in this version); use irradiance, "
                              "fluence, region, or flux through a wall or the surface of a region"));
  }
  if (!faults.empty()) throw InputError(std::move(faults));
}

bool is_black(const Picture& picture) {
  return std::all_of(picture.radiance.begin(), picture.radiance.end(),
                     [](double value) { return value == 0; });
}

}  // namespace

void check_views(const std::vector<CameraCase>& cameras, const std::vector<SensorCase>& sensors,
                 const Problem& problem) {
  if (problem.space() == AngularSpace::plane) return check_views_in_plane(cameras, sensors);
  std::string where;
  if (std::any_of(problem.media().begin(), problem.media().end(), has_kernel))
    where = "beside a kernel, which rays do not see (not in this version); remove it";
  if (uses_formulas(problem))
    where =
        "beside absorption or emission that depends on the direction, which rays do not see (not in this "
        "version); remove it";
  if (where.empty()) return;
  std::vector<Fault> faults;
  for (const CameraCase& camera : cameras) faults.push_back(fault_at(camera.origin, "", "a camera " + where));
  for (const SensorCase& sensor : sensors) faults.push_back(fault_at(sensor.origin, "", "a sensor " + where));
  if (!faults.empty()) throw InputError(std::move(faults));
}

bool write_pictures(const PictureOrder& order, const TakePicture& take, const AddErrors& add) {
  std::ostream& out = order.out;
  out << fmt::format("pictures: {}\n", BandColor(order.input.bands).rule());
  std::vector<NamedPicture> pictures;
  for (const CameraCase& camera : order.cameras) {
    const WallClock::time_point begun = WallClock::now();
    StageProgress display(order.progress, "picture " + camera.name, out);
    Picture picture = take(camera.camera, [&](double share) {
      display.show(share, seconds_since(begun));
      return !order.interrupted();
    });
    display.finish();
    if (!picture.whole) return false;
    const std::string white = WhiteBalance(order.input.bands, camera.white).rule();
    out << fmt::format("picture {}: {} x {} pixels, {} {} each, {:.3g} s{}\n", camera.name, picture.pixels[0],
                       picture.pixels[1], camera.camera.samples, camera.camera.samples == 1 ? "ray" : "rays",
                       seconds_since(begun), white.empty() ? "" : "; " + white);
    if (is_black(picture))
      out << fmt::format("  the picture {} is black: nothing that the camera looks at shines\n", camera.name);
    pictures.push_back({camera, std::move(picture), {}});
    if (camera.camera.errors && !add(pictures.back())) return false;
  }
  const auto seconds = order.begun ? std::optional(seconds_since(*order.begun)) : std::nullopt;
  const std::vector<std::string> names = add_pictures(order.directory, order.input, pictures, seconds);
  out << "written to " << order.directory.string() << ":";
  for (const std::string& name : names) out << " " << name;
  out << std::endl;
  return true;
}

bool write_pictures(const Case& input, const std::vector<CameraCase>& cameras, const RayRadiance& scene,
                    const ErrorImages& error_images, int threads, const std::filesystem::path& directory,
                    ProgressStyle progress, std::ostream& out, const std::function<bool()>& interrupted,
                    std::optional<std::chrono::steady_clock::time_point> begun) {
  const StageDisplay stages{progress, out, interrupted};
  return write_pictures(
      {input, cameras, directory, progress, out, interrupted, begun},
      [&](const Camera& camera, const StageObserver& observer) {
        std::optional<ShownStage> gathering;
        if (camera.gather > 0) gathering.emplace(stages, "looking for the light of walls");
        return take_picture(scene, camera, threads, observer, [&](double share) {
          const bool goes_on = gathering && gathering->observer()(share);
          if (share == 1 || !goes_on) gathering.reset();
          return goes_on;
        });
      },
      [&](NamedPicture& picture) { return add_errors(error_images, threads, stages, picture); });
}

}  // namespace etendue
