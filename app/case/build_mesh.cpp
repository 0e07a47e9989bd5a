// SPDX-License-Identifier: AGPL-3.0-or-later
#include <cmath>
#include <numbers>

#include "app/case/build.h"
#include "app/case/mesh_names.h"
#include "mesh/files/mesh_file.h"
#include "mesh/geometry/arrangement.h"
#include "mesh/geometry/surface_file.h"
#include "mesh/tetrahedra/tetrahedralize.h"

namespace etendue {
namespace {

// Of the regular tetrahedron with this edge.
double regular_volume(double edge) { return edge * edge * edge / (6 * std::numbers::sqrt2); }

// The bound for a region: its own, else that of "*", else 0.
double bound_of(const SizeBound& bound, const std::string& region) {
  for (const std::string& name : {region, std::string("*")})
    if (const auto found = bound.by_region.find(name); found != bound.by_region.end()) return found->second;
  return 0;
}

std::vector<double> volume_bounds(const MeshCase& mesh, const std::vector<std::string>& regions) {
  std::vector<double> bounds;
  for (const std::string& region : regions) {
    if (mesh.max_volume)
      bounds.push_back(bound_of(*mesh.max_volume, region));
    else
      bounds.push_back(mesh.edge_length ? regular_volume(bound_of(*mesh.edge_length, region)) : 0);
  }
  return bounds;
}

SurfaceComplex surface_of(const MeshCase& mesh, const Log& log) {
  if (!mesh.surface) return arrange(mesh.geometry, log);
  return read_surface(mesh.surface->path, {mesh.scale, mesh.regions, mesh.surface->origin}, log);
}

TetrahedralMesh mesh_from_surface(const Case& input, const Log& log) {
  const SurfaceComplex surface = surface_of(input.mesh, log);
  // Before meshing, which may take long.
  check_names(input, names_of(surface));
  const TetrahedraOptions options{volume_bounds(input.mesh, surface.region_names), input.mesh.quality,
                                  input.mesh.origin};
  return TetrahedralMesh(tetrahedralize(surface, options, log));
}

}  // namespace

TetrahedralMesh build_mesh(const Case& input, const Log& log) {
  if (!input.mesh.file) return mesh_from_surface(input, log);
  TetrahedralMesh mesh(read_mesh(input.mesh.file->path, input.mesh.scale, input.mesh.file->origin));
  check_names(input, names_of(mesh));
  return mesh;
}

}  // namespace etendue
