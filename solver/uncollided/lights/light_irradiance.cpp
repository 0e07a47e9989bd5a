// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/uncollided/lights/light_irradiance.h"

#include <algorithm>
#include <array>

#include "solver/problem/mirror.h"
#include "solver/uncollided/closed_form/polygon_irradiance.h"
#include "solver/uncollided/closed_form/uniform_emitters.h"
#include "solver/uncollided/sources/wide_source.h"

namespace etendue {
namespace {

/// Every triangle alone: points that represent a group of them may lie beside it, behind an obstacle.
constexpr LightDetail each_triangle{0, 0, fine_light.thickness, fine_light.largest_side, fine_light.rule};

/// Adds the light of beams, on the side that a normal points to and from all sides, times a factor.
void add_beams(const LightBeams& beams, const Vec3& normal, double factor, UncollidedAtPoint& light) {
  for (std::size_t i = 0; i < beams.size(); ++i) {
    const double cosine = std::max(0.0, -normal.dot(beams.direction(i)));
    for (std::size_t b = 0; b < beams.bands(); ++b) {
      light.irradiance[b] += factor * cosine * beams.fluence(i)[b];
      light.fluence[b] += factor * beams.fluence(i)[b];
    }
  }
}

std::span<const EmitterPart> flat_parts(const LightSource& source) {
  const WideSource* wide = source.as_wide();
  return wide != nullptr ? wide->flat_parts() : std::span<const EmitterPart>();
}

}  // namespace

// Mirrors may stand where images are not to be counted, as long as no light asks for them.
LightIrradiance::LightIrradiance(const LightSetup& lights) : lights_(lights) {
  if (std::ranges::any_of(lights.sources(), [](const auto& source) { return !flat_parts(*source).empty(); }))
    images_ = lights.paths().mirrors().images_of_point();
  skies_.resize(lights.sources().size());
  const auto& walls = lights.problem().walls();
  if (std::ranges::any_of(walls, [](const Wall& wall) { return is_mirror(wall); })) return;
  for (std::size_t i = 0; i < skies_.size(); ++i) {
    const WideSource* wide = lights.sources()[i]->as_wide();
    const SkySource* sky = wide != nullptr ? wide->as_sky() : nullptr;
    if (sky != nullptr && sky->shows_radiance()) skies_[i].emplace(*sky, lights.paths());
  }
}

UncollidedAtPoint LightIrradiance::at(const PointInCell& point, const Vec3& normal) const {
  const std::size_t bands = lights_.paths().bands();
  UncollidedAtPoint light{std::vector<double>(bands, 0), std::vector<double>(bands, 0)};
  LightBeams seen(bands), clear(bands);
  LightDetail each = each_triangle;
  each.shadow_edges = &lights_.shadow_edges();
  for (std::size_t i = 0; i < skies_.size(); ++i) {
    if (skies_[i]) {
      add_sky(*skies_[i], point, normal, light);
      continue;
    }
    const LightSource* source = lights_.sources()[i].get();
    const bool flat = !flat_parts(*source).empty();
    const LightDetail detail = flat ? each : fine_light;
    seen.clear();
    clear.clear();
    source->add_beams(point, Sight::attenuated, detail, seen);
    if (flat && seen.size() > 0) source->add_beams(point, Sight::clear, detail, clear);
    add(*source, point.position, normal, seen, clear, light);
  }
  return light;
}

// The beams are exact where all of them arrive; beside obstacles and windows they do so by chance.
void LightIrradiance::add_sky(const SkyIrradiance& sky, const PointInCell& point, const Vec3& normal,
                              UncollidedAtPoint& light) const {
  const std::size_t bands = lights_.paths().bands();
  LightBeams seen(bands);
  sky.sky().add_beams(point, Sight::attenuated, fine_light, seen);
  const auto falls = [&](const Vec3& direction) { return normal.dot(direction) < 0; };
  std::size_t falling = 0;
  for (std::size_t i = 0; i < seen.size(); ++i) falling += falls(seen.direction(i)) ? 1 : 0;
  const std::span<const Vec3> all = sky.sky().directions();
  const bool whole = falling == static_cast<std::size_t>(std::ranges::count_if(all, falls));
  UncollidedAtPoint by_beams{std::vector<double>(bands, 0), std::vector<double>(bands, 0)},
      by_faces = by_beams;
  if (whole || seen.size() == all.size()) add_beams(seen, normal, 1, by_beams);
  if (!whole || seen.size() < all.size()) sky.add(point, normal, by_faces.irradiance, by_faces.fluence);
  for (std::size_t b = 0; b < bands; ++b) {
    light.irradiance[b] += (whole ? by_beams : by_faces).irradiance[b];
    light.fluence[b] += (seen.size() == all.size() ? by_beams : by_faces).fluence[b];
  }
}

void LightIrradiance::add(const LightSource& source, const Vec3& position, const Vec3& normal,
                          const LightBeams& seen, const LightBeams& clear, UncollidedAtPoint& light) const {
  UncollidedAtPoint found{std::vector<double>(clear.bands(), 0), std::vector<double>(clear.bands(), 0)};
  add_beams(seen, normal, 1, found);
  // Where nothing of it is seen, no rounding is to be left of (1).
  if (seen.size() > 0 && clear.size() > 0) {
    add_beams(clear, normal, -1, found);
    for (const MirrorSet mirrors : images_) add_clear(flat_parts(source), mirrors, position, normal, found);
  }
  // Where nearly all is lost, the rule of the beams may take more than there was.
  const auto add_to = [](const std::vector<double>& from, std::vector<double>& to) {
    for (std::size_t b = 0; b < to.size(); ++b) to[b] += from[b] < 0 ? 0 : from[b];
  };
  add_to(found.irradiance, light.irradiance);
  add_to(found.fluence, light.fluence);
}

// Through mirrors the meter is moved behind them instead of the light.
void LightIrradiance::add_clear(std::span<const EmitterPart> flat, MirrorSet mirrors, const Vec3& position,
                                const Vec3& normal, UncollidedAtPoint& light) const {
  const MirrorPlanes& planes = lights_.paths().mirrors();
  const Vec3 eye = planes.image(mirrors, position), up = planes.image_direction(mirrors, normal);
  for (const EmitterPart& part : flat) {
    if (!shines_to(part, eye)) continue;
    const std::array<Vec3, 3> seen = {part.corners[0] - eye, part.corners[1] - eye, part.corners[2] - eye};
    const double across = polygon_irradiance(seen, up), all = triangle_solid_angle(seen);
    for (std::size_t b = 0; b < part.brightness.size(); ++b) {
      const double arrives = part.brightness[b] * planes.reflectance(mirrors, b);
      light.irradiance[b] += arrives * across;
      light.fluence[b] += arrives * all;
    }
  }
}

}  // namespace etendue
