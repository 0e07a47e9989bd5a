// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/files/vtk/vtu_grid.h"

#include <array>
#include <new>
#include <string>

#include <vtkCellArray.h>
#include <vtkCellType.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>

#include "mesh/files/vtk/refused_file.h"
#include "mesh/files/vtk/vtk_messages.h"
#include "mesh/files/vtk/vtu_names.h"
#include "mesh/files/vtk/vtu_polyhedra.h"

namespace etendue {
namespace {

vtkSmartPointer<vtkUnstructuredGrid> read_grid(const std::string& file) {
  const VtkMessages messages;
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName(file.c_str());
  try {
    reader->Update();
  } catch (const std::bad_alloc&) {
    refuse_file(file, "VTK needs more memory than there is to read it (is it corrupt?)");
  }
  vtkSmartPointer<vtkUnstructuredGrid> grid = reader->GetOutput();
  if (messages.any() || reader->GetErrorCode() != 0)
    refuse_file(file, "VTK cannot read it (" + messages.first() + "); is it cut short or corrupt?");
  if (grid == nullptr || grid->GetNumberOfCells() == 0) refuse_file(file, "holds no cells; mesh the volume");
  return grid;
}

/// VTK follows offsets without looking where they lead.
void check_offsets(const std::string& file, vtkUnstructuredGrid& grid) {
  const vtkIdType cells = grid.GetNumberOfCells();
  vtkCellArray* array = grid.GetCells();
  vtkDataArray* offsets = array->GetOffsetsArray();
  const vtkIdType entries = array->GetConnectivityArray()->GetNumberOfTuples();
  vtkUnsignedCharArray* types = grid.GetCellTypesArray();
  if (types == nullptr || types->GetNumberOfTuples() != cells || offsets->GetNumberOfTuples() != cells + 1)
    refuse_file(file, "cell types and offsets: must be one for each cell (is it corrupt?)");
  for (vtkIdType cell = 0; cell < cells; ++cell) {
    const double first = offsets->GetTuple1(cell);
    const double last = offsets->GetTuple1(cell + 1);
    if (!(first >= 0 && first <= last && last <= static_cast<double>(entries)))
      refuse_file(file, "cell " + std::to_string(cell) +
                            ": its offset leads outside the connectivity (is it corrupt?)");
  }
}

/// Tetrahedra, and triangles of walls.
class TetrahedraOfVtu {
 public:
  TetrahedraOfVtu(const std::string& file, vtkUnstructuredGrid& grid)
      : file_(file), grid_(grid), names_(file, grid) {}

  RawMesh read() {
    mesh_.file = file_;
    mesh_.points = points_of(grid_);
    for (vtkIdType cell = 0; cell < grid_.GetNumberOfCells(); ++cell) {
      const int type = grid_.GetCellTypesArray()->GetValue(cell);
      if (type == VTK_TETRA) read_tetrahedron(cell);
      if (type == VTK_TRIANGLE) read_triangle(cell);
    }
    mesh_.region_names = names_.region_names();
    mesh_.wall_names = names_.wall_names();
    return std::move(mesh_);
  }

 private:
  template <std::size_t N>
  std::array<int, N> corners_of(vtkIdType cell) const {
    const std::vector<int> points = points_of_cell(file_, grid_, cell, N);
    std::array<int, N> corners{};
    std::copy(points.begin(), points.end(), corners.begin());
    return corners;
  }

  void read_tetrahedron(vtkIdType cell) {
    mesh_.cells.push_back(corners_of<4>(cell));
    mesh_.cell_numbers.push_back(cell);
    mesh_.cell_regions.push_back(names_.region(cell));
  }

  void read_triangle(vtkIdType cell) {
    const std::array<int, 3> corners = corners_of<3>(cell);
    const int wall = names_.wall(cell);
    if (wall == -1) return;
    mesh_.triangles.push_back(corners);
    mesh_.triangle_walls.push_back(wall);
  }

  const std::string& file_;
  vtkUnstructuredGrid& grid_;
  VtuNames names_;
  RawMesh mesh_;
};

}  // namespace

std::variant<RawMesh, PolyhedralMesh> read_vtu_grid(const std::filesystem::path& path) {
  const std::string file = path.string();
  const vtkSmartPointer<vtkUnstructuredGrid> grid = read_grid(file);
  check_offsets(file, *grid);
  if (has_other_volumes(file, *grid)) {
    VtuNames names(file, *grid);
    return polyhedra_of_vtu(file, *grid, &names);
  }
  return TetrahedraOfVtu(file, *grid).read();
}

}  // namespace etendue
