// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/solve/returned_light.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "solver/problem/mirror.h"

namespace etendue {

double brightest_wall(const Problem& problem) {
  double brightest = 0;
  for (const Wall& wall : problem.walls())
    for (std::size_t b = 0; b < wall.diffuse.size(); ++b)
      brightest = std::max(brightest, wall.mean_reflectance(b) - wall.specular[b] + wall.transmitted(b));
  return brightest;
}

double largest_albedo(const Problem& problem) {
  double largest = 0;
  for (std::size_t i = 0; i < problem.scattering().size(); ++i)
    if (problem.scattering()[i] > 0)
      largest =
          std::max(largest, problem.scattering()[i] / (problem.scattering()[i] + problem.absorption()[i]));
  return largest;
}

double scatterings_on_a_chord(const Problem& problem) {
  const TetrahedralMesh& mesh = problem.mesh();
  const auto bands = static_cast<std::size_t>(problem.band_count());
  double most = 0;
  for (std::size_t band = 0; band < bands; ++band) {
    double scattered = 0, surface = 0;
    for (std::size_t c = 0; c < mesh.volumes().size(); ++c)
      scattered += problem.scattering()[c * bands + band] * mesh.volumes()[c];
    for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f)
      surface += mesh.area(FaceIndex(f)) *
                 (1 - mirrored_part_of_isotropic(problem.wall(mesh.wall(FaceIndex(f))), band));
    if (scattered > 0) most = std::max(most, 4 * scattered / surface);
  }
  return most;
}

double most_returns(const Problem& problem) {
  Eigen::AlignedBox3d box;
  for (const Vec3& point : problem.mesh().points()) box.extend(point);
  const double across = box.diagonal().norm();
  double densest = 0;
  for (const double scattering : problem.scattering()) densest = std::max(densest, scattering);
  const double paths = std::max(densest * across, scatterings_on_a_chord(problem));
  const double kept = paths > 0 ? 1 - largest_albedo(problem) + 3 / (paths * paths) : 1;
  return 1 / std::min({kept, 1 - brightest_wall(problem), 1.0});
}

}  // namespace etendue
