// SPDX-License-Identifier: AGPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "app/api/solution_impl.h"
#include "app/write/image/toned_png.h"
#include "solver/observe/color/band_color.h"
#include "solver/observe/photon_map/map_picture.h"

namespace etendue::v0 {
namespace {

const CameraCase& camera_of(const etendue::Case& input, const std::string& name) {
  const auto found = std::ranges::find(input.cameras, name, &CameraCase::name);
  if (found != input.cameras.end()) return *found;
  std::vector<std::string> names;
  for (const CameraCase& camera : input.cameras) names.push_back(camera.name);
  throw etendue::InputError(
      fmt::format("camera = \"{}\": the case has no such camera; {}", name,
                  names.empty() ? "add a [[camera]]" : fmt::format("use {}", fmt::join(names, " or "))));
}

Picture picture_of_hits(const SolvedCase& solved, const Camera& camera, const StageObserver& goes_on) {
  const PhotonCase& photons = *solved.input.photons;
  const PhotonMapOptions options{photons.photons, photons.map_hits,
                                 static_cast<std::size_t>(photons.map_neighbours),
                                 static_cast<std::uint64_t>(photons.seed), solved.threads()};
  Picture stopped;
  stopped.whole = false;
  std::vector<BandHits> hits = keep_hits(solved.problem, solved.locator, options, [&] { return goes_on(0); });
  if (!goes_on(0)) return stopped;
  return take_picture(MapRadiance(solved.problem, std::move(hits), options.neighbours), camera,
                      solved.threads(), goes_on);
}

Picture picture_of(const Solution::Impl& impl, const Camera& camera, const StageObserver& goes_on) {
  SolvedCase& solved = *impl.solved;
  if (solved.input.photons) return picture_of_hits(solved, camera, goes_on);
  const RayRadiance* rays = nullptr;
  {
    const std::scoped_lock once(impl.changing);
    rays = &rays_of(solved);
  }
  return take_picture(*rays, camera, solved.threads(), goes_on, goes_on);
}

std::vector<std::uint8_t> shown(const etendue::Case& input, const CameraCase& camera,
                                const Picture& picture) {
  const BandColor rule(input.bands);
  std::vector<LinearColor> colors;
  for (std::size_t at = 0; at < picture.radiance.size(); at += picture.bands)
    colors.push_back(rule.of(std::span(picture.radiance).subspan(at, picture.bands)));
  return toned_bytes(balanced(colors, WhiteBalance(input.bands, camera.white)), camera.exposure, camera.tone);
}

}  // namespace

Image take_image(const Solution::Impl& impl, const std::string& name, const std::function<bool()>& stop) {
  const etendue::Case& input = impl.solved->input;
  const CameraCase& camera = camera_of(input, name);
  Picture picture = picture_of(impl, camera.camera, [&](double) { return !stop || !stop(); });
  if (!picture.whole) throw Stopped("stopped: there is no picture");
  Image image{picture.pixels[0], picture.pixels[1], static_cast<int>(picture.bands), {}, {}};
  image.srgb = shown(input, camera, picture);
  image.radiance = std::move(picture.radiance);
  return image;
}

}  // namespace etendue::v0
