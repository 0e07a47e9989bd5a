// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "app/case/case.h"
#include "mesh/tetrahedra/tetrahedral_mesh.h"

namespace etendue {

/// An array over cells, [cell][band].
struct NamedCells {
  std::string name;
  std::string unit;
  std::span<const double> values;
};

/// Writes cell data on a mesh as VTU, a component for each band. `shown` is named in a FileError.
void write_cells(const TetrahedralMesh& mesh, const Case& input, const std::vector<NamedCells>& arrays,
                 const std::filesystem::path& path, const std::filesystem::path& shown);

}  // namespace etendue
