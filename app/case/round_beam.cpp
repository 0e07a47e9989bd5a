// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/round_beam.h"

#include <fmt/format.h>

#include <algorithm>

#include "solver/lights/beam_pieces.h"

namespace etendue {
namespace {

BeamProfile::Shape shape_of(const LightCase& light) {
  return light.gaussian ? BeamProfile::Shape::gaussian : BeamProfile::Shape::disc;
}

/// Part of the whole beam that has to come in.
constexpr double least_part = 1e-6;

}  // namespace

void shape_beam(const LightCase& light, BeamLight& beam) {
  if (light.radius <= 0) return;  // was refused
  const Vec3 across = light.direction.unitOrthogonal();
  beam.profile = {shape_of(light), light.position, across / light.radius,
                  light.direction.cross(across) / light.radius};
  for (double& irradiance : beam.irradiance) irradiance /= profile_area(shape_of(light), light.radius);
}

void refract_profile(const Vec3& direction_outside, const Vec3& normal, const Vec3& on_wall,
                     BeamLight& inside) {
  BeamProfile& profile = *inside.profile;
  profile.center += normal.dot(on_wall - profile.center) / normal.dot(direction_outside) * direction_outside;
  for (Vec3* axis : {&profile.across, &profile.upright})
    *axis -= axis->dot(inside.direction) / normal.dot(inside.direction) * normal;
}

void require_hit(const LightCase& light, const std::vector<Light>& beams, const TetrahedralMesh& mesh,
                 std::vector<Fault>& faults) {
  double area = 0;
  for (const Light& each : beams) {
    const auto& beam = std::get<BeamLight>(each.kind);
    for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f)
      if (std::ranges::count(beam.walls, mesh.wall(FaceIndex(f))) > 0)
        area += entering_area(beam, mesh, FaceIndex(f));
  }
  if (area > least_part * profile_area(shape_of(light), light.radius)) return;
  faults.push_back(fault_at(
      light.origin, "",
      fmt::format("the light \"{}\" misses the walls by which it may come in (its axis passes through "
                  "[{:.4g}, {:.4g}, {:.4g}]); move it, turn it, or name other walls",
                  light.name, light.position.x(), light.position.y(), light.position.z())));
}

}  // namespace etendue
