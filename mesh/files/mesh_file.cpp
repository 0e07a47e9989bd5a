// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/files/mesh_file.h"

#include <algorithm>
#include <cctype>
#include <memory>
#include <string>
#include <utility>
#include <variant>

#include "mesh/files/gmsh_file.h"
#include "mesh/files/openfoam/foam_mesh.h"
#include "mesh/files/tetgen_files.h"
#include "mesh/files/vtk/vtu_file.h"
#include "mesh/tetrahedra/generation/cut_polyhedra.h"

namespace etendue {
namespace {

std::string lower_ending(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return ending;
}

std::variant<RawMesh, PolyhedralMesh> read_unscaled(const std::filesystem::path& path, const Origin& origin) {
  if (std::error_code ignored; std::filesystem::is_directory(path, ignored)) return read_foam_mesh(path);
  const std::string ending = lower_ending(path);
  if (ending == ".msh") return read_gmsh_file(path);
  if (ending == ".vtu") return read_vtu_file(path);
  if (ending == ".node" || ending == ".ele" || ending == ".face") return read_tetgen_files(path);
  throw InputError(fault_at(origin, "\"" + path.string() + "\"",
                            "is not the name of a mesh file; use .msh (Gmsh), .vtu (VTK), .node, .ele, .face "
                            "(TetGen) or the folder of an OpenFOAM case"));
}

}  // namespace

RawMesh read_mesh(const std::filesystem::path& path, double scale, const Origin& origin, UpAxis up) {
  std::variant<RawMesh, PolyhedralMesh> mesh = read_unscaled(path, origin);
  std::visit(
      [&](auto& read) {
        for (Vec3& point : read.points) point = with_z_up(scale * point, up);
      },
      mesh);
  if (auto* polyhedra = std::get_if<PolyhedralMesh>(&mesh))
    return cut_polyhedra(std::make_shared<const PolyhedralMesh>(std::move(*polyhedra)));
  return std::get<RawMesh>(std::move(mesh));
}

void write_mesh(const std::filesystem::path& path, const TetrahedralMesh& mesh,
                const MeshFileOptions& options) {
  if (lower_ending(path) != ".vtu")
    throw InputError("\"" + path.string() + "\": meshes are written as VTK; use a name that ends in .vtu");
  write_vtu_file(path, mesh, options);
}

}  // namespace etendue
