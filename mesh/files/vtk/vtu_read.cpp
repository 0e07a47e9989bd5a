// SPDX-License-Identifier: AGPL-3.0-or-later
#include <cstdio>
#include <string>
#include <string_view>

#include "base/array_bytes.h"
#include "mesh/files/vtk/raw_mesh_bytes.h"
#include "mesh/files/vtk/vtk_child.h"
#include "mesh/files/vtk/vtu_file.h"
#include "mesh/files/vtk/vtu_grid.h"
#include "mesh/files/vtk/vtu_header.h"

namespace etendue {

std::variant<RawMesh, PolyhedralMesh> read_vtu_file(const std::filesystem::path& path) {
  check_vtu_header(path);
  const std::string bytes = read_in_child(path, [&](std::FILE* file) {
    const std::variant<RawMesh, PolyhedralMesh> mesh = read_vtu_grid(path);
    write_array(file, std::vector<std::size_t>{mesh.index()});
    if (const auto* tetrahedra = std::get_if<RawMesh>(&mesh)) write_raw_mesh(file, *tetrahedra);
    if (const auto* polyhedra = std::get_if<PolyhedralMesh>(&mesh)) write_polyhedral_mesh(file, *polyhedra);
  });
  std::string_view rest = bytes;
  const auto named = [&](auto mesh) {
    mesh.file = path.string();
    return mesh;
  };
  if (take_value<std::size_t>(rest) == 0) return named(take_raw_mesh(rest));
  return named(take_polyhedral_mesh(rest));
}

}  // namespace etendue
