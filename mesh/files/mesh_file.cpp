// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/files/mesh_file.h"

#include <algorithm>
#include <cctype>
#include <string>

#include "mesh/files/gmsh_file.h"
#include "mesh/files/tetgen_files.h"
#include "mesh/files/vtk/vtu_file.h"

namespace etendue {
namespace {

std::string lower_ending(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return ending;
}

RawMesh read_unscaled(const std::filesystem::path& path, const Origin& origin) {
  const std::string ending = lower_ending(path);
  if (ending == ".msh") return read_gmsh_file(path);
  if (ending == ".vtu") return read_vtu_file(path);
  if (ending == ".node" || ending == ".ele" || ending == ".face") return read_tetgen_files(path);
  throw InputError(
      fault_at(origin, "\"" + path.string() + "\"",
               "is not the name of a mesh file; use .msh (Gmsh), .vtu (VTK) or .node, .ele, .face "
               "(TetGen)"));
}

}  // namespace

RawMesh read_mesh(const std::filesystem::path& path, double scale, const Origin& origin, UpAxis up) {
  RawMesh mesh = read_unscaled(path, origin);
  for (Vec3& point : mesh.points) point = with_z_up(scale * point, up);
  return mesh;
}

void write_mesh(const std::filesystem::path& path, const TetrahedralMesh& mesh,
                const MeshFileOptions& options) {
  if (lower_ending(path) != ".vtu")
    throw InputError("\"" + path.string() + "\": meshes are written as VTK; use a name that ends in .vtu");
  write_vtu_file(path, mesh, options);
}

}  // namespace etendue
