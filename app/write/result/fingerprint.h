// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/case/case.h"
#include "mesh/tetrahedra/tetrahedral_mesh.h"

namespace etendue {

/// A short text that another mesh will not have: of its points, cells, regions, walls and their names.
std::string mesh_hash(const TetrahedralMesh& mesh);

/// A part of a case that its solution depends on, and a short text that another such part will not have.
struct CasePart {
  std::string name;  ///< the first word of its tables, e.g. "media"
  std::string hash;
  bool operator==(const CasePart&) const = default;
};

/// The parts of a case that the answer depends on beside the mesh, sorted by name: not the title, nor how
/// it is solved, nor what is read off the solution and written.
std::vector<CasePart> case_parts(const Case& input);

/// Names of the parts that are not the same in both.
std::vector<std::string> different_parts(const std::vector<CasePart>& a, const std::vector<CasePart>& b);

}  // namespace etendue
