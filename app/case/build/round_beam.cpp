// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/build/round_beam.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "app/case/fibre.h"
#include "mesh/tetrahedra/search/ray_mesh.h"
#include "solver/problem/lights/beam_pieces.h"

namespace etendue {
namespace {

BeamProfile::Shape shape_of(const LightCase& light) {
  return light.gaussian ? BeamProfile::Shape::gaussian : BeamProfile::Shape::disc;
}

/// Part of the whole beam that has to come in, and that may: the whole but for the rule of its integral.
constexpr double least_part = 1e-6, most_parts = 1 + 1e-4;
/// Over the size of the domain: a position so near to a wall lies on it.
constexpr double near_wall = 1e-6;

double size_of(const TetrahedralMesh& mesh) {
  double size = 0;
  for (const Vec3& point : mesh.points()) size = std::max(size, (point - mesh.points().front()).norm());
  return size;
}

/// From the position back along the beam to where it leaves the domain; 0 outside.
double distance_inside(const LightCase& light, const CellLocator& locator, const TetrahedralMesh& mesh) {
  const std::vector<CellPoint> cells = locator.find(light.position);
  double distance = 0;
  const RayMesh rays(mesh);
  for (const CellPoint& at : cells)
    distance = std::max(distance, rays.walk(at.cell, light.position, -light.direction,
                                            std::numeric_limits<double>::infinity(), [](CellIndex, double) {})
                                      .distance);
  return distance;
}

/// Outside, along its axis.
BeamLight whole_beam(const LightCase& light) {
  BeamLight beam{light.direction, values_of(light.strength), {}};
  shape_beam(light, beam);
  return beam;
}

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

// On a flat wall the beams before and behind it have the same profile, and each of a fibre's beams has the
// same part of the power.
double part_on_walls(const LightCase& light, std::span<const Light> beams, const TetrahedralMesh& mesh) {
  const bool fibre = light.numerical_aperture > 0;
  const BeamLight outside = whole_beam(light);
  const std::vector<BeamLight> parts =
      fibre ? fibre_parts(outside, light.numerical_aperture) : std::vector{outside};
  double part = 0;
  for (std::size_t i = 0; i < beams.size(); ++i) {
    const BeamLight& from = parts[i % parts.size()];
    BeamLight beam = std::get<BeamLight>(beams[i].kind);
    beam.direction = from.direction;
    double area = 0;
    for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f)
      if (std::ranges::count(beam.walls, mesh.wall(FaceIndex(f))) > 0)
        area += entering_area(beam, mesh, FaceIndex(f));
    part += area / (profile_area(shape_of(light), light.radius) * from.direction.dot(light.direction)) /
            static_cast<double>(parts.size());
  }
  return part;
}

void require_hit(const LightCase& light, const std::vector<Light>& beams, const CellLocator& locator,
                 const TetrahedralMesh& mesh, std::vector<Fault>& faults) {
  const auto refuse = [&](const std::string& problem) {
    faults.push_back(fault_at(light.origin, "", fmt::format("the light \"{}\" {}", light.name, problem)));
  };
  const Vec3& p = light.position;
  if (distance_inside(light, locator, mesh) > near_wall * size_of(mesh))
    return refuse(fmt::format(
        "begins inside the domain at [{:.4g}, {:.4g}, {:.4g}] (a beam comes in by a wall, also "
        "where its position lies behind the wall); put the position on the wall or outside, or use "
        "kind point, spot or disc for light that begins inside",
        p.x(), p.y(), p.z()));
  const double part = part_on_walls(light, beams, mesh);
  if (part <= least_part)
    return refuse(fmt::format(
        "misses the walls by which it may come in (its axis passes through [{:.4g}, {:.4g}, {:.4g}]); "
        "move it, turn it, or name other walls",
        p.x(), p.y(), p.z()));
  if (part > most_parts)
    refuse(
        fmt::format("passes through its walls more than once (with {:.4g} of its power in all; it goes out "
                    "and comes in again); name the wall by which it comes in first",
                    part));
}

}  // namespace etendue
