// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/write/vtk/vtk_importance.h"

#include <vtkCellData.h>
#include <vtkPointData.h>

#include "app/write/vtk/separate_parts.h"
#include "app/write/vtk/vtk_arrays.h"
#include "app/write/vtk/vtk_output.h"
#include "base/angular_space.h"
#include "solver/solution/node_means.h"

namespace etendue {
namespace {

std::vector<double> divided(std::vector<double> values, double by) {
  for (double& value : values) value /= by;
  return values;
}

void write(vtkDataSet& data, const ImportanceFields& fields, const std::filesystem::path& path,
           const std::filesystem::path& shown) {
  const Case& input = fields.input;
  add_bands(*data.GetFieldData(), fields.problem.bands());
  write_vtk(data, {path, shown, input.output.encoding, input.title, input.units.length});
}

}  // namespace

void write_importance(const ImportanceFields& fields, const std::filesystem::path& path,
                      const std::filesystem::path& shown) {
  const TetrahedralMesh& mesh = fields.problem.mesh();
  const std::vector<std::string>& bands = fields.problem.bands().names;
  const int count = fields.problem.band_count();
  const std::vector<double> values = divided(fields.importance.fluence, full_range(fields.problem.space()));
  const auto grid = separate_cells(mesh);
  add_named_cells(*grid, "region", mesh.cell_regions(), mesh.region_names());
  grid->GetPointData()->AddArray(vtk_array({"importance", bands, fields.unit}, count, values));
  grid->GetCellData()->AddArray(
      vtk_array({"importance_mean", bands, fields.unit}, count, node_means(values, 4, bands.size())));
  const auto add_gradient = [&](const std::string& name, std::vector<double> density) {
    for (std::size_t i = 0; i < density.size(); ++i) density[i] /= mesh.volumes()[i / bands.size()];
    grid->GetCellData()->AddArray(vtk_array({name, bands, fields.gradient_unit}, count, density));
  };
  if (fields.gradient != nullptr) add_gradient("gradient_absorption", fields.gradient->absorption);
  if (fields.gradient != nullptr) add_gradient("gradient_scattering", fields.gradient->scattering);
  write(*grid, fields, path, shown);
}

void write_importance_of_walls(const ImportanceFields& fields, const std::filesystem::path& path,
                               const std::filesystem::path& shown) {
  const TetrahedralMesh& mesh = fields.problem.mesh();
  std::vector<std::int32_t> walls;
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f) walls.push_back(mesh.wall(FaceIndex(f)));
  const auto surface = separate_faces(mesh);
  add_named_cells(*surface, "wall", walls, mesh.wall_names());
  surface->GetPointData()->AddArray(
      vtk_array({"importance", fields.problem.bands().names, fields.unit}, fields.problem.band_count(),
                divided(fields.importance.irradiance, half_range(fields.problem.space()))));
  write(*surface, fields, path, shown);
}

}  // namespace etendue
