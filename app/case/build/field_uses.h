// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/case/case.h"
#include "mesh/tetrahedra/tetrahedral_mesh.h"

namespace etendue {

/// A field from a file where a case uses it.
struct FieldUse {
  std::string field;    ///< e.g. `kappa of gas.vtu`
  std::string key;      ///< absorption, … or radiance
  std::string place;    ///< the region or wall
  double smallest = 0;  ///< among the points that cells are integrated by, or the vertices of a wall
  double largest = 0;
  double mean = 0;  ///< over the volume or area
};

/// All fields of a case in the regions and on the walls of a mesh. Throws InputError with the place where a
/// field does not cover a region or wall.
std::vector<FieldUse> field_uses(const Case& input, const TetrahedralMesh& mesh);

}  // namespace etendue
