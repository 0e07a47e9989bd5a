// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/write/vtk/vtk_comparison.h"

#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkUnstructuredGrid.h>

#include "app/write/vtk/vtk_arrays.h"
#include "app/write/vtk/vtk_output.h"

namespace etendue {

void write_cells(const TetrahedralMesh& mesh, const Case& input, const std::vector<NamedCells>& arrays,
                 const std::filesystem::path& path, const std::filesystem::path& shown) {
  const std::vector<std::string>& bands = input.bands.names;
  const vtkSmartPointer<vtkUnstructuredGrid> grid = joined_cells(mesh);
  add_named_cells(*grid, "region", mesh.cell_regions(), mesh.region_names());
  add_bands(*grid->GetFieldData(), input.bands);
  for (const NamedCells& array : arrays)
    grid->GetCellData()->AddArray(
        vtk_array({array.name, bands, array.unit}, static_cast<int>(bands.size()), array.values));
  write_vtk(*grid, {path, shown, input.output.encoding, input.title, input.units.length});
}

}  // namespace etendue
