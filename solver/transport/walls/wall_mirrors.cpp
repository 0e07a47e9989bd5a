// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/walls/wall_mirrors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/errors.h"
#include "solver/angular/refraction/ordinate_reflectance.h"
#include "solver/problem/mirror.h"
#include "solver/transport/walls/same_plane.h"

namespace etendue {
WallMirrors::WallMirrors(const Problem& problem, const DirectionSet& directions,
                         const OrdinateSchedule& schedule, std::span<const double> half_range,
                         std::size_t face_length)
    : problem_(problem),
      directions_(directions),
      face_length_(face_length),
      mirror_of_(half_range.size(), -1) {
  const TetrahedralMesh& mesh = problem.mesh();
  std::vector<Fault> faults;
  std::vector<char> refused(problem.walls().size(), 0);
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f) {
    const FaceIndex face(f);
    const auto wall = static_cast<std::size_t>(mesh.wall(face));
    if (half_range[face.at()] <= out_of_reach) continue;
    if (refused[wall] || !is_mirror(problem.wall(mesh.wall(face)))) continue;
    const std::ptrdiff_t found = plane_of(face, schedule);
    if (found < 0) {
      refused[wall] = 1;
      faults.push_back(fault_of(face));
      continue;
    }
    const auto plane = static_cast<std::size_t>(found);
    mirror_of_[face.at()] = static_cast<std::int32_t>(mirrors_.size());
    mirrors_.push_back({plane, rows_[static_cast<std::size_t>(planes_[plane].pass)]++});
    faces_.push_back(f);
  }
  if (!faults.empty()) throw InputError(std::move(faults));
}

std::ptrdiff_t WallMirrors::plane_of(FaceIndex face, const OrdinateSchedule& schedule) {
  const Vec3 normal = problem_.mesh().area_normal(face).normalized();
  const double index = problem_.wall(problem_.mesh().wall(face)).refractive_index;
  const auto found = std::ranges::find_if(planes_, [&](const Plane& plane) {
    return (plane.normal - normal).norm() <= same_plane && plane.refractive_index == index;
  });
  if (found != planes_.end()) return found - planes_.begin();
  Plane plane = make_plane(face, schedule);
  if (std::ranges::count(plane.partner, -1) > 0) return -1;
  planes_.push_back(std::move(plane));
  return static_cast<std::ptrdiff_t>(planes_.size()) - 1;
}

WallMirrors::Plane WallMirrors::make_plane(FaceIndex face, const OrdinateSchedule& schedule) const {
  const Vec3 normal = problem_.mesh().area_normal(face).normalized();
  const Wall& wall = problem_.wall(problem_.mesh().wall(face));
  Plane plane{normal,
              wall.refractive_index,
              schedule.knows_reflections(normal) ? Pass::this_sweep : Pass::next_sweep,
              {},
              {}};
  for (std::int32_t m = 0; m < directions_.count(); ++m)
    plane.partner.push_back(directions_.mirrored(OrdinateIndex(m), normal));
  if (wall.refractive_index != 1) plane.reflected = ordinate_reflectances(directions_, wall, normal);
  return plane;
}

Fault WallMirrors::fault_of(FaceIndex face) const {
  const TetrahedralMesh& mesh = problem_.mesh();
  const Wall& mirror = problem_.wall(mesh.wall(face));
  Origin origin = mirror.origin;
  origin.key += mirror.refractive_index != 1 ? ".refractive_index" : ".specular";
  const Vec3 at = mesh.centroid(face), normal = mesh.area_normal(face).normalized();
  return fault_at(
      origin, "",
      fmt::format(
          "the mirror at ({:.6g}, {:.6g}, {:.6g}) with normal ({:.6g}, {:.6g}, {:.6g}) takes ordinates "
          "out of the {} set of order {} (a mirrored ordinate must be in it); use mirrors on planes "
          "across x, y or z with a set that is neither rotated nor refined, or diffuse reflectance",
          at.x(), at.y(), at.z(), normal.x(), normal.y(), normal.z(), directions_.name(),
          directions_.order()));
}

void WallMirrors::set_emission_range(std::vector<double>& range) const {
  for (const std::int32_t f : faces_) {
    const Plane& refracting = plane(*find(FaceIndex(f)));
    if (refracting.reflected.empty()) continue;
    double sum = 0;
    for (std::int32_t m = 0; m < directions_.count(); ++m)
      sum += directions_.weight(OrdinateIndex(m)) * (1 - refracting.reflected[static_cast<std::size_t>(m)]) *
             std::max(0.0, -refracting.normal.dot(directions_.direction(OrdinateIndex(m))));
    range[static_cast<std::size_t>(f)] = std::pow(refracting.refractive_index, 2) * sum;
  }
}

}  // namespace etendue
