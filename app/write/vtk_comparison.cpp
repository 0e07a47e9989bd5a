// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/write/vtk_comparison.h"

#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include "app/write/vtk_arrays.h"

namespace etendue {

void write_cells(const TetrahedralMesh& mesh, const std::vector<std::string>& bands,
                 const std::vector<NamedCells>& arrays, const std::filesystem::path& path,
                 const std::filesystem::path& shown) {
  const vtkSmartPointer<vtkUnstructuredGrid> grid = joined_cells(mesh);
  grid->GetCellData()->AddArray(vtk_array({"region", {}, {}}, mesh.cell_regions()));
  add_names(*grid->GetFieldData(), "region_names", mesh.region_names());
  add_names(*grid->GetFieldData(), "band_names", bands);
  for (const NamedCells& array : arrays)
    grid->GetCellData()->AddArray(
        vtk_array({array.name, bands, array.unit}, static_cast<int>(bands.size()), array.values));
  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetInputData(grid);
  write_vtk(*writer, path, shown);
}

}  // namespace etendue
