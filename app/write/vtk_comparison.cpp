// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/write/vtk_comparison.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include "app/write/vtk_arrays.h"

namespace etendue {

void write_cells(const TetrahedralMesh& mesh, const std::vector<std::string>& bands,
                 const std::vector<NamedCells>& arrays, const std::filesystem::path& path,
                 const std::filesystem::path& shown) {
  std::vector<double> coordinates;
  for (const Vec3& point : mesh.points()) coordinates.insert(coordinates.end(), point.begin(), point.end());
  vtkNew<vtkPoints> points;
  points->SetData(vtk_array({"points", {}, {}}, 3, coordinates));
  vtkNew<vtkCellArray> cells;
  for (int c = 0; c < mesh.cell_count(); ++c) {
    std::array<vtkIdType, 4> corners = positive_order(mesh, CellIndex(c));
    for (vtkIdType& corner : corners) corner = mesh.vertices(CellIndex(c))[static_cast<std::size_t>(corner)];
    cells->InsertNextCell(4, corners.data());
  }
  vtkNew<vtkUnstructuredGrid> grid;
  grid->SetPoints(points);
  grid->SetCells(VTK_TETRA, cells);
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
