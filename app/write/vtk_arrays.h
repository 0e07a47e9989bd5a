// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLWriter.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "mesh/tetrahedra/tetrahedral_mesh.h"

namespace etendue {

/// A point or cell array: its name, a name for each component (may be empty) and its unit.
struct ArrayLabel {
  std::string name;
  std::vector<std::string> components;
  std::string unit;
};

/// Copies of values that lie tuple after tuple.
vtkSmartPointer<vtkDataArray> vtk_array(const ArrayLabel& label, int components,
                                        std::span<const double> values);
vtkSmartPointer<vtkDataArray> vtk_array(const ArrayLabel& label, std::span<const std::int32_t> values);
vtkSmartPointer<vtkDataArray> vtk_colors(const std::string& how, std::span<const std::uint8_t> rgb);

/// Adds a list of names to the field data.
void add_names(vtkFieldData& fields, const std::string& array, const std::vector<std::string>& names);

/// The vertices of a cell, 0 … 3, in an order that VTK takes for a tetrahedron of positive volume. Sorted by
/// number, about half of the cells stand the other way.
std::array<vtkIdType, 4> positive_order(const TetrahedralMesh& mesh, CellIndex cell);

/// The cells of a mesh, which share its points.
vtkSmartPointer<vtkUnstructuredGrid> joined_cells(const TetrahedralMesh& mesh);

/// Writes appended, compressed binary data. What VTK has to say about failures is in the FileError; `shown`
/// is the path in its message.
void write_vtk(vtkXMLWriter& writer, const std::filesystem::path& path, const std::filesystem::path& shown);

}  // namespace etendue
