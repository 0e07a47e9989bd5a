// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/solver/transport/diffusive_slab.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "tests/solver/transport/sample_problems.h"

namespace etendue {

Problem diffusive_slab(const TetrahedralMesh& mesh, double epsilon) {
  const Medium medium = uniform_medium(1, epsilon, 1 / epsilon - epsilon, epsilon / (4 * M_PI));
  std::vector<Medium> media;
  for (const std::string& name : mesh.region_names()) {
    media.push_back(medium);
    media.back().name = name;
  }
  std::vector<Wall> walls;
  for (const std::string& name : mesh.wall_names()) {
    walls.push_back(uniform_wall(1, 0, 0, name == "xmin" || name == "xmax" ? 0 : 1));
    walls.back().name = name;
  }
  return Problem(mesh, Bands{}, media, walls);
}

double diffusive_slab_fluence(const Vec3& point) {
  const double k = std::sqrt(3.0);
  return 1 - std::cosh(k * (point.x() - 0.5)) / std::cosh(k / 2);
}

double diffusive_slab_tolerance(double epsilon) { return std::max(1e-6, 1e-15 / (epsilon * epsilon)); }

}  // namespace etendue
