// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/uncollided/sources/sky_source.h"

#include <algorithm>
#include <cmath>

#include "solver/uncollided/sources/beam_source.h"

namespace etendue {
namespace {

bool lets_in(const BeamLight& part, int wall) { return std::ranges::count(part.walls, wall) > 0; }

/// A dark part of a sky sends no beam, but rays see it.
bool is_dark(const BeamLight& part) {
  return std::ranges::all_of(part.irradiance, [](double irradiance) { return irradiance == 0; });
}

std::vector<double> sky_power(std::span<const BeamLight> parts, const TetrahedralMesh& mesh) {
  std::vector<double> power(parts.front().irradiance.size(), 0);
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f) {
    if (!lets_in(parts.front(), mesh.wall(FaceIndex(f)))) continue;
    for (const BeamLight& part : parts)
      for (std::size_t b = 0; b < power.size(); ++b)
        power[b] += part.irradiance[b] * std::max(0.0, -part.direction.dot(mesh.area_normal(FaceIndex(f))));
  }
  return power;
}

bool mirrors_are_perfect(const Problem& problem) {
  return std::ranges::all_of(problem.walls(), [](const Wall& wall) {
    return std::ranges::all_of(wall.specular, [](double part) { return part == 0 || part == 1; });
  });
}

}  // namespace

bool continues_sky(std::span<const Light> lights, std::size_t i) {
  return i > 0 && !lights[i].name.empty() && lights[i].name == lights[i - 1].name &&
         std::holds_alternative<BeamLight>(lights[i].kind) &&
         std::holds_alternative<BeamLight>(lights[i - 1].kind) &&
         !std::get<BeamLight>(lights[i].kind).profile;
}

SkySource::SkySource(std::string name, std::vector<BeamLight> parts, const LightPaths& paths)
    : WideSource(std::move(name), sky_power(parts, paths.problem().mesh())),
      parts_(std::move(parts)),
      paths_(paths),
      images_(paths.mirrors().images_of_direction()) {
  for (const MirrorSet mirrors : images_)
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      if (is_dark(parts_[i])) continue;
      const Vec3 direction = paths.mirrors().image_direction(mirrors, parts_[i].direction);
      const auto known = std::ranges::find_if(
          directions_, [&](const Vec3& other) { return (other - direction).norm() < returning_direction; });
      const auto place = static_cast<std::size_t>(known - directions_.begin());
      if (known == directions_.end()) {
        directions_.push_back(direction);
        from_.emplace_back();
      }
      if (std::ranges::count(from_[place], i) == 0) from_[place].push_back(i);
    }
  if (std::ranges::all_of(parts_, [](const BeamLight& part) { return part.solid_angle > 0; }))
    for (const BeamLight& part : parts_)
      for (const double irradiance : part.irradiance) radiance_.push_back(irradiance / part.solid_angle);
  const bool perfect = mirrors_are_perfect(paths.problem());
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const auto like = std::ranges::find_if(
        parts_, [&](const BeamLight& other) { return perfect && other.irradiance == parts_[i].irradiance; });
    kinds_.push_back(like == parts_.end() ? i : static_cast<std::size_t>(like - parts_.begin()));
  }
}

bool SkySource::comes_in_by(int wall) const { return lets_in(parts_.front(), wall); }

std::span<const double> SkySource::radiance(const Vec3& towards) const {
  const auto nearest = std::ranges::min_element(
      parts_, {}, [&](const BeamLight& part) { return part.direction.dot(towards); });
  const std::size_t bands = parts_.front().irradiance.size();
  return std::span(radiance_).subspan(static_cast<std::size_t>(nearest - parts_.begin()) * bands, bands);
}

std::optional<SkySource::Entry> SkySource::transmit(const PointInCell& at, std::size_t direction,
                                                    std::span<double> transmittance) const {
  const std::optional<WayOut> out = paths_.leave(at, -directions_[direction], transmittance);
  if (!out) return std::nullopt;
  for (const std::size_t i : from_[direction])
    if ((out->direction + parts_[i].direction).norm() < returning_direction)
      return lets_in(parts_[i], paths_.problem().mesh().wall(out->face)) ? std::optional(Entry{out->face, i})
                                                                         : std::nullopt;
  return std::nullopt;
}

void SkySource::add_beams(const PointInCell& at, Sight sight, LightDetail, LightBeams& beams) const {
  if (sight == Sight::clear) {
    for (const MirrorSet mirrors : images_)
      for (const BeamLight& part : parts_) {
        const std::span<double> fluence =
            beams.add(paths_.mirrors().image_direction(mirrors, part.direction));
        for (std::size_t b = 0; b < fluence.size(); ++b)
          fluence[b] = part.irradiance[b] * paths_.mirrors().reflectance(mirrors, b);
      }
    return;
  }
  for (std::size_t i = 0; i < directions_.size(); ++i) {
    const std::span<double> fluence = beams.add(directions_[i]);
    const std::optional<Entry> entry = transmit(at, i, fluence);
    if (!entry) {
      beams.drop();
      continue;
    }
    for (std::size_t b = 0; b < fluence.size(); ++b) fluence[b] *= parts_[entry->part].irradiance[b];
  }
}

}  // namespace etendue
