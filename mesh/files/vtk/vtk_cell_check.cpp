// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/files/vtk/vtk_cell_check.h"

#include <vtkCellArray.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

namespace etendue {

std::string cell_problem(vtkUnstructuredGrid& grid) {
  const vtkIdType cells = grid.GetNumberOfCells(), points = grid.GetNumberOfPoints();
  vtkCellArray* array = grid.GetCells();
  vtkDataArray* offsets = array->GetOffsetsArray();
  vtkDataArray* connectivity = array->GetConnectivityArray();
  const vtkIdType entries = connectivity->GetNumberOfTuples();
  vtkUnsignedCharArray* types = grid.GetCellTypesArray();
  if (types == nullptr || types->GetNumberOfTuples() != cells || offsets->GetNumberOfTuples() != cells + 1)
    return "cell types and offsets: must be one for each cell (is it corrupt?)";
  for (vtkIdType cell = 0; cell < cells; ++cell) {
    const double first = offsets->GetTuple1(cell), last = offsets->GetTuple1(cell + 1);
    if (!(first >= 0 && first <= last && last <= static_cast<double>(entries)))
      return "cell " + std::to_string(cell) + ": its offset leads outside the connectivity (is it corrupt?)";
  }
  for (vtkIdType i = 0; i < entries; ++i)
    if (const double point = connectivity->GetTuple1(i); !(point >= 0 && point < static_cast<double>(points)))
      return "entry " + std::to_string(i) + " of the connectivity: point " + std::to_string(point) +
             " does not exist; there are " + std::to_string(points);
  return "";
}

}  // namespace etendue
