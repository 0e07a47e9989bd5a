// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/lights/beam_source.h"

#include <algorithm>

#include "solver/lights/beam_pieces.h"

namespace etendue {
namespace {

/// A direction that comes back to that of the beam through mirrors does so to rounding.
constexpr double same_direction = 1e-9;

/// What enters: the irradiance times the area of the walls as the beam sees it.
std::vector<double> power_of(const BeamLight& light, const TetrahedralMesh& mesh) {
  double area = 0;
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f)
    if (std::count(light.walls.begin(), light.walls.end(), mesh.wall(FaceIndex(f))) > 0)
      area += entering_area(light, mesh, FaceIndex(f));
  std::vector<double> power = light.irradiance;
  for (double& value : power) value *= area;
  return power;
}

}  // namespace

BeamSource::BeamSource(std::string name, const BeamLight& light, const LightPaths& paths)
    : LightSource(std::move(name), power_of(light, paths.problem().mesh())), light_(light), paths_(paths) {
  for (const MirrorSet mirrors : paths.mirrors().images_of_direction()) {
    const Vec3 direction = paths.mirrors().image_direction(mirrors, light.direction);
    // A beam along a mirror is its own image.
    const auto same = [&](const Vec3& other) { return (other - direction).norm() < same_direction; };
    if (std::ranges::any_of(directions_, same)) continue;
    directions_.push_back(direction);
    mirrors_.push_back(mirrors);
  }
}

bool BeamSource::arrives(const PointInCell& at, const Vec3& direction, std::span<double> fluence) const {
  const std::optional<WayOut> out = paths_.leave(at, -direction, fluence);
  if (!out || !((out->direction + light_.direction).norm() < same_direction) ||
      std::ranges::count(light_.walls, paths_.problem().mesh().wall(out->face)) == 0)
    return false;
  const double part = part_on_ray(out->point);
  for (std::size_t b = 0; b < fluence.size(); ++b) fluence[b] *= part * light_.irradiance[b];
  return part > 0;
}

double BeamSource::part_on_ray(const Vec3& point) const {
  return light_.profile ? relative_irradiance(*light_.profile, point) : 1;
}

void BeamSource::add_beams(const PointInCell& at, Sight sight, LightDetail, LightBeams& beams) const {
  for (const Vec3& direction : directions_) {
    const std::span<double> fluence = beams.add(direction);
    if (sight == Sight::clear) {
      const double part = part_on_ray(at.position);
      for (std::size_t b = 0; b < fluence.size(); ++b) fluence[b] = part * light_.irradiance[b];
      if (part == 0) beams.drop();
    } else if (!arrives(at, direction, fluence)) {
      beams.drop();
    }
  }
}

}  // namespace etendue
