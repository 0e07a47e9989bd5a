// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include <etendue/mesh.h>

#include "mesh/tetrahedra/tetrahedral_mesh.h"

namespace etendue::v0 {

struct Mesh::Impl {
  std::shared_ptr<const TetrahedralMesh> mesh;
  std::string source;  ///< table [mesh] of a case on this mesh, as TOML; empty: the one that it was made from
};

}  // namespace etendue::v0
