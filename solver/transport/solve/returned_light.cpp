// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/solve/returned_light.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <functional>

#include "solver/problem/mirror.h"

namespace etendue {
namespace {

/// Reflectance of a wall, mirrors left out.
double reflected_beside_mirrors(const Wall& wall, std::size_t band) {
  return wall.mean_reflectance(band) - wall.specular[band];
}

/// The most of 4 V sigma_s / S of a band, with `counted` the part of a wall's area that counts in a band.
double scatterings_by_surface(const Problem& problem,
                              const std::function<double(const Wall&, std::size_t)>& counted) {
  const TetrahedralMesh& mesh = problem.mesh();
  const auto bands = static_cast<std::size_t>(problem.band_count());
  double most = 0;
  for (std::size_t band = 0; band < bands; ++band) {
    double scattered = 0, surface = 0;
    for (std::size_t c = 0; c < mesh.volumes().size(); ++c)
      scattered += problem.scattering()[c * bands + band] * mesh.volumes()[c];
    for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f)
      surface += mesh.area(FaceIndex(f)) * counted(problem.wall(mesh.wall(FaceIndex(f))), band);
    if (scattered > 0) most = std::max(most, 4 * scattered / surface);
  }
  return most;
}

}  // namespace

double brightest_wall(const Problem& problem) {
  double brightest = 0;
  for (const Wall& wall : problem.walls())
    for (std::size_t b = 0; b < wall.diffuse.size(); ++b)
      brightest = std::max(brightest, reflected_beside_mirrors(wall, b) + wall.transmitted(b));
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
  return scatterings_by_surface(
      problem, [](const Wall& wall, std::size_t band) { return 1 - mirrored_part_of_isotropic(wall, band); });
}

double most_returns(const Problem& problem) {
  Eigen::AlignedBox3d box;
  for (const Vec3& point : problem.mesh().points()) box.extend(point);
  const double across = box.diagonal().norm();
  double densest = 0;
  for (const double scattering : problem.scattering()) densest = std::max(densest, scattering);
  // White walls send light back into a medium as mirrors do.
  const double before_loss = scatterings_by_surface(problem, [](const Wall& wall, std::size_t band) {
    return std::max(0.0, 1 - mirrored_part_of_isotropic(wall, band) - reflected_beside_mirrors(wall, band));
  });
  const double paths = std::max(densest * across, before_loss);
  const double kept = paths > 0 ? 1 - largest_albedo(problem) + 3 / (paths * paths) : 1;
  // Reflectances may exceed 1 by rounding.
  return 1 / std::clamp(std::min(kept, 1 - brightest_wall(problem)), 0.0, 1.0);
}

}  // namespace etendue
