// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/write/result/beam_power.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "app/case/build/round_beam.h"
#include "solver/problem/lights/beam_pieces.h"
#include "solver/uncollided/rays/mirror_images.h"

namespace etendue {
namespace {

/// In radii of the beam, or as a cosine: an axis so near to a plane lies in it.
constexpr double in_plane_to = 1e-6;

/// The beams in which a light of the case comes in; by several glazed walls it has a name for each.
std::vector<Light> beams_of(const LightCase& light, const Problem& problem) {
  std::vector<Light> beams;
  for (const Light& each : problem.lights())
    if (std::holds_alternative<BeamLight>(each.kind) &&
        (each.name == light.name || each.name.starts_with(light.name + " through ")))
      beams.push_back(each);
  return beams;
}

/// Mirrors that cut a beam along its axis leave half of it each.
double part_before_symmetry(const LightCase& light, const MirrorPlanes& planes) {
  std::vector<Vec3> normals;
  for (int plane = 0; plane < planes.count(); ++plane) {
    const Vec3& normal = planes.normal(plane);
    if (std::abs(normal.dot(light.direction)) < in_plane_to &&
        std::abs(normal.dot(light.position) - planes.offset(plane)) < in_plane_to * light.radius &&
        std::ranges::none_of(normals, [&](const Vec3& n) { return std::abs(n.dot(normal)) > in_plane_to; }))
      normals.push_back(normal);
  }
  return std::pow(0.5, normals.size());
}

double entering_power(const std::vector<Light>& beams, const TetrahedralMesh& mesh) {
  double power = 0;
  for (const Light& each : beams) {
    const auto& beam = std::get<BeamLight>(each.kind);
    const double irradiance = std::accumulate(beam.irradiance.begin(), beam.irradiance.end(), 0.0);
    for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f)
      if (std::ranges::count(beam.walls, mesh.wall(FaceIndex(f))) > 0)
        power += irradiance * entering_area(beam, mesh, FaceIndex(f));
  }
  return power;
}

}  // namespace

std::vector<BeamPower> beam_powers(const Problem& problem, const Case& input) {
  std::vector<BeamPower> found;
  const auto is_beam = [](const LightCase& light) { return light.kind == LightKind::beam; };
  if (std::ranges::none_of(input.lights, is_beam)) return found;
  const MirrorPlanes planes(problem);
  for (const LightCase& light : input.lights) {
    if (!is_beam(light)) continue;
    const std::vector<Light> beams = beams_of(light, problem);
    BeamPower& beam = found.emplace_back();
    beam.name = light.name;
    const std::vector<double>& power = values_of(light.strength);
    beam.power = std::accumulate(power.begin(), power.end(), 0.0);
    beam.entering = entering_power(beams, problem.mesh());
    const double on_walls = part_on_walls(light, beams, problem.mesh());
    const double before = std::max(part_before_symmetry(light, planes), on_walls);
    beam.behind_symmetry = beam.power * (1 - before);
    beam.beside = beam.power * (before - on_walls);
    beam.turned_back = std::max(0.0, beam.power * on_walls - beam.entering);
  }
  return found;
}

}  // namespace etendue
