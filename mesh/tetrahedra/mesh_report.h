// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "mesh/tetrahedra/tetrahedral_mesh.h"

namespace etendue {

/// What a person wants to know of a mesh before solving on it.
struct MeshReport {
  std::vector<double> region_volumes;  ///< [region] [length^3]
  std::vector<int> region_cells;       ///< [region]
  std::vector<double> wall_areas;      ///< [wall] [length^2]
  std::vector<int> wall_faces;         ///< [wall]
  double smallest_volume = 0;          ///< [length^3]
  double largest_volume = 0;           ///< [length^3]
  /// Radius ratio 3 r_in / r_circum, 1 for the regular tetrahedron: counts in ten equal bins over [0, 1].
  std::array<int, 10> quality_histogram{};
  double worst_quality = 1;
  Vec3 worst_centroid = Vec3::Zero();
};

MeshReport mesh_report(const TetrahedralMesh& mesh);

/// As text, with the unit of length (a table over regions, one over walls, the histogram).
std::string to_string(const MeshReport& report, const TetrahedralMesh& mesh, const std::string& length_unit);

}  // namespace etendue
