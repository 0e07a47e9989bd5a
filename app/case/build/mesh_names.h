// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <set>
#include <string>
#include <vector>

#include "app/case/case.h"
#include "mesh/geometry/primitives/surface_complex.h"
#include "mesh/tetrahedra/tetrahedral_mesh.h"

namespace etendue {

/// Names that a geometry or mesh really has: some cell or boundary facet carries each.
struct MeshNames {
  std::set<std::string> regions;
  std::set<std::string> walls;
};

MeshNames names_of(const SurfaceComplex& surface);
MeshNames names_of(const TetrahedralMesh& mesh);

/// Throws InputError with every name in the case that nothing carries, and every region or wall that has no
/// entry while there is no "*".
void check_names(const Case& input, const MeshNames& names);

/// Reports every region and wall in the case that its primitives cannot give, whatever overlaps what. Nothing
/// where the geometry is in a file.
void check_possible_names(const Case& input, std::vector<Fault>& faults);

}  // namespace etendue
