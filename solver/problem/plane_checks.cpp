// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/problem/plane_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "solver/problem/problem_checks.h"

namespace etendue {
namespace {

// Normals of flat sides miss their axis by the rounding of coordinates only.
constexpr double alignment = 1e-9;

bool is_cold_mirror(const Wall& wall) {
  return std::ranges::all_of(wall.specular, [](double share) { return share == 1; }) &&
         std::ranges::all_of(wall.radiance, [](double radiance) { return radiance == 0; });
}

}  // namespace

void check_plane_walls(const Problem& problem, std::vector<Fault>& faults) {
  const TetrahedralMesh& mesh = problem.mesh();
  std::vector<char> told(problem.walls().size(), 0);
  for (const Wall& wall : problem.walls())
    if (wall.is_glossy())
      faults.push_back(fault_at(origin_of(wall, "glossy"), "",
                                "not in flatland (it reflects into all directions of space); use diffuse or "
                                "specular, or another direction set"));
  for (int f = 0; f < mesh.boundary_face_count(); ++f) {
    const FaceIndex face(f);
    const auto index = static_cast<std::size_t>(mesh.wall(face));
    if (told[index]) continue;
    const Wall& wall = problem.wall(mesh.wall(face));
    if (wall.refractive_index != 1) {
      told[index] = 1;
      faults.push_back(fault_at(origin_of(wall, "refractive_index"), "",
                                "refracts, and flatland does not know that (not in this version); use "
                                "another direction set"));
      continue;
    }
    const double along_z = std::abs(mesh.area_normal(face).normalized().z());
    if (along_z <= alignment || (along_z >= 1 - alignment && is_cold_mirror(wall))) continue;
    told[index] = 1;
    const Vec3 at = mesh.centroid(face);
    const bool flat = along_z >= 1 - alignment;
    faults.push_back(fault_at(
        origin_of(wall, "specular"), "",
        fmt::format("the wall at ({:.6g}, {:.6g}, {:.6g}) {} (nothing in flatland depends on z); use {}",
                    at.x(), at.y(), at.z(),
                    flat ? "faces along z and is no cold mirror" : "is neither upright nor across z",
                    flat ? "specular = 1 and no radiance for it, or another direction set"
                         : "a domain between two planes z = const, or another direction set")));
  }
}

}  // namespace etendue
