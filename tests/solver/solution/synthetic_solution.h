// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>
#include <numbers>

#include "solver/problem/problem.h"
#include "solver/solution/solution.h"

namespace etendue {

/// A solution whose fluence and net flux take these values at the vertices, dark at the walls.
inline Solution solution_from(const Problem& problem, const std::function<double(const Vec3&, int)>& fluence,
                              const std::function<Vec3(const Vec3&, int)>& net_flux) {
  const TetrahedralMesh& mesh = problem.mesh();
  Solution solution;
  const int bands = problem.band_count();
  for (int c = 0; c < mesh.cell_count(); ++c)
    for (const int v : mesh.vertices(CellIndex(c))) {
      const Vec3& point = mesh.point(VertexIndex(v));
      for (int band = 0; band < bands; ++band) solution.fluence.push_back(fluence(point, band));
      for (int axis = 0; axis < 3; ++axis)
        for (int band = 0; band < bands; ++band) solution.net_flux.push_back(net_flux(point, band)[axis]);
    }
  const std::size_t faces = static_cast<std::size_t>(mesh.boundary_face_count());
  solution.irradiance.assign(faces * 3 * static_cast<std::size_t>(bands), 0.0);
  solution.exitance = solution.irradiance;
  solution.half_range.assign(faces, std::numbers::pi);
  return solution;
}

}  // namespace etendue
