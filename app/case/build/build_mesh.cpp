// SPDX-License-Identifier: AGPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "app/case/build/build.h"
#include "app/case/build/mesh_names.h"
#include "app/case/volume_bounds.h"
#include "base/unreadable_file.h"
#include "mesh/files/fields/field_file.h"
#include "mesh/files/mesh_file.h"
#include "mesh/geometry/arrangement/arrangement.h"
#include "mesh/geometry/arrangement/voxel_surface.h"
#include "mesh/geometry/surface_files/surface_file.h"
#include "mesh/tetrahedra/generation/narrow_gaps.h"
#include "mesh/tetrahedra/generation/red_refinement.h"
#include "mesh/tetrahedra/generation/tetrahedralize.h"

namespace etendue {
namespace {

/// Cells that the numbers of faces and points still count.
constexpr double largest_mesh = 2e8;

/// Reads a file that a key of the case names. A FileError names the key too.
template <class Read>
auto read_named(const InputFile& file, const Read& read) {
  try {
    return read();
  } catch (const FileError& error) {
    throw unreadable_file(file.origin, file.path, error.what());
  }
}

SurfaceComplex surface_of(const MeshCase& mesh, const Log& log) {
  if (!mesh.surface) {
    SurfaceComplex surface = arrange(mesh.geometry, log);
    check_gaps(surface, mesh.origin);
    return surface;
  }
  return read_named(*mesh.surface, [&] {
    return read_surface(mesh.surface->path, {mesh.scale, mesh.regions, mesh.surface->origin, mesh.up}, log);
  });
}

/// The sound mesh with its cells cut into eight as often as wanted.
TetrahedralMesh refined(RawMesh raw, const MeshCase& wanted) {
  if (wanted.refine == 0) return TetrahedralMesh(raw);
  const TetrahedralMesh check(raw);
  const double cells = std::ldexp(check.cell_count(), 3 * wanted.refine);
  if (cells > largest_mesh)
    throw InputError(
        fault_at({wanted.origin.file, wanted.origin.line, "mesh.refine"}, std::to_string(wanted.refine),
                 fmt::format("would make {:.3g} cells; cut {} cells less often", cells, check.cell_count())));
  for (int times = 0; times < wanted.refine; ++times) raw = red_refinement(raw);
  return TetrahedralMesh(raw);
}

RawMesh filled(const Case& input, const SurfaceComplex& surface, const Log& log) {
  // Before meshing, which may take long.
  check_names(input, names_of(surface));
  const TetrahedraOptions options{volume_bounds(input.mesh, surface.region_names), input.mesh.quality,
                                  input.mesh.origin, input.mesh.max_cells};
  return tetrahedralize(surface, options, log);
}

RawMesh mesh_of_voxels(const Case& input, const FieldData& image, FacetSize size, const Log& log) {
  const LabelsCase& labels = *input.mesh.labels;
  VoxelSurface voxels = voxel_surface(image, labels.labels, labels.file.origin, size);
  const double scale = input.mesh.scale;
  for (Vec3& point : voxels.surface.points) point *= scale;
  for (RegionSeed& seed : voxels.surface.seeds) seed.point *= scale;
  for (Vec3& hole : voxels.surface.holes) hole *= scale;
  for (SurfaceFacet& facet : voxels.surface.facets)
    for (Vec3& opening : facet.openings) opening *= scale;
  RawMesh mesh = filled(input, voxels.surface, log);
  for (Vec3& point : mesh.points)
    point = with_z_up(scale * voxels.origin + voxels.axes * point, input.mesh.up);
  return mesh;
}

/// Voxels are meshed in the image's own axes, where their planes are exact, and turned into their place then.
RawMesh mesh_of_labels(const Case& input, const Log& log) {
  const LabelsCase& labels = *input.mesh.labels;
  const FieldData image =
      read_named(labels.file, [&] { return read_field({.path = labels.file.path, .array = labels.array}); });
  if (!image.image)
    throw InputError(fault_at(labels.file.origin, "\"" + labels.file.path.string() + "\"",
                              "holds no image; use .vti or .nii"));
  try {
    return mesh_of_voxels(input, image, FacetSize::largest, log);
  } catch (const TooManyCells&) {
    throw;
  } catch (const InputError& error) {
    // TetGen 1.5 fails on some large facets with very many corners.
    if (log) log(std::string(error.what()) + "; again with a facet for each face of a voxel");
    return mesh_of_voxels(input, image, FacetSize::elementary, log);
  }
}

}  // namespace

TetrahedralMesh build_mesh(const Case& input, const Log& log) {
  if (input.mesh.labels) return refined(mesh_of_labels(input, log), input.mesh);
  if (!input.mesh.file) return refined(filled(input, surface_of(input.mesh, log), log), input.mesh);
  RawMesh raw = read_named(*input.mesh.file, [&] {
    return read_mesh(input.mesh.file->path, input.mesh.scale, input.mesh.file->origin, input.mesh.up);
  });
  const TetrahedralMesh mesh = refined(std::move(raw), input.mesh);
  check_names(input, names_of(mesh));
  return mesh;
}

}  // namespace etendue
