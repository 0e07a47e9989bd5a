// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/lights/sky_source.h"

#include <algorithm>
#include <cmath>

namespace etendue {
namespace {

/// A direction that comes back to that of a beam through mirrors does so to rounding.
constexpr double same_direction = 1e-9;

bool comes_in_by(const BeamLight& part, int wall) { return std::ranges::count(part.walls, wall) > 0; }

std::vector<double> power_of(std::span<const BeamLight> parts, const TetrahedralMesh& mesh) {
  std::vector<double> power(parts.front().irradiance.size(), 0);
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f) {
    if (!comes_in_by(parts.front(), mesh.wall(FaceIndex(f)))) continue;
    for (const BeamLight& part : parts)
      for (std::size_t b = 0; b < power.size(); ++b)
        power[b] += part.irradiance[b] * std::max(0.0, -part.direction.dot(mesh.area_normal(FaceIndex(f))));
  }
  return power;
}

}  // namespace

bool continues_sky(std::span<const Light> lights, std::size_t i) {
  return i > 0 && !lights[i].name.empty() && lights[i].name == lights[i - 1].name &&
         std::holds_alternative<BeamLight>(lights[i].kind) &&
         std::holds_alternative<BeamLight>(lights[i - 1].kind);
}

SkySource::SkySource(std::string name, std::vector<BeamLight> parts, const LightPaths& paths)
    : WideSource(std::move(name), power_of(parts, paths.problem().mesh())),
      parts_(std::move(parts)),
      paths_(paths),
      images_(paths.mirrors().images_of_direction()) {}

void SkySource::add_beams(const PointInCell& at, Sight sight, LightDetail, LightBeams& beams) const {
  for (const MirrorSet mirrors : images_)
    for (const BeamLight& part : parts_) {
      const Vec3 direction = paths_.mirrors().image_direction(mirrors, part.direction);
      // All ways count as equally long: what is linear between places is the optical depth.
      const std::span<double> fluence = beams.add(direction, {1, 0});
      if (sight == Sight::attenuated) {
        const std::optional<WayOut> out = paths_.leave(at, -direction, fluence);
        const bool lit = out && (out->direction + part.direction).norm() < same_direction &&
                         comes_in_by(part, paths_.problem().mesh().wall(out->face));
        if (!lit) {
          beams.drop();
          continue;
        }
      } else {
        for (std::size_t b = 0; b < fluence.size(); ++b)
          fluence[b] = paths_.mirrors().reflectance(mirrors, b);
      }
      for (std::size_t b = 0; b < fluence.size(); ++b) fluence[b] *= part.irradiance[b];
    }
}

void SkySource::look_even(const Vec3& place, std::span<const double> extinction, std::optional<int> without,
                          LightBeams& beams, EvenLight& light) const {
  beams.clear();
  add_beams({CellIndex(0), place}, Sight::clear, coarse_light, beams);
  light.clear();
  for (std::size_t i = 0; i < beams.size(); ++i) {
    const MirrorSet mirrors = images_[i / parts_.size()];
    if (without && (mirrors >> *without & 1) != 0) continue;
    for (std::size_t b = 0; b < light.fluence.size(); ++b) {
      const double arrives = beams.fluence(i)[b] * std::exp(-extinction[b]);
      light.fluence[b] += arrives;
      light.flux[b] += arrives * beams.direction(i);
    }
  }
}

}  // namespace etendue
