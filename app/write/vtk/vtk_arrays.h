// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkDataSetAttributes.h>
#include <vtkFieldData.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "mesh/tetrahedra/tetrahedral_mesh.h"
#include "solver/problem/bands.h"

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
/// Adds three components x, y, z for each band under the name `NAME_BAND`, or `NAME` where there is one band.
/// `label.components` are the bands; `values` are [point][3][band].
void add_band_vectors(vtkDataSetAttributes& arrays, const ArrayLabel& label, std::span<const double> values);
/// `color`: values [point][band] as 8-bit colors. `weights` are volumes or areas of groups of
/// `points_per_weight` points, from which the exposure follows.
vtkSmartPointer<vtkDataArray> color_array(const Bands& bands, std::span<const double> values,
                                          std::span<const double> weights, int points_per_weight,
                                          const std::string& unit);
vtkSmartPointer<vtkDataArray> vtk_colors(const std::string& how, std::span<const std::uint8_t> rgb);

/// Adds a list of names to the field data.
void add_names(vtkFieldData& fields, const std::string& array, const std::vector<std::string>& names);
/// Adds `band_names`, and `band_edges` [nm] where the bands have edges.
void add_bands(vtkFieldData& fields, const Bands& bands);
/// Adds `kind` (a number for each cell), `kind_name` (its name) and the names in the field data:
/// `kind_names`.
void add_named_cells(vtkDataSet& data, const std::string& kind, std::span<const std::int32_t> numbers,
                     const std::vector<std::string>& names);

/// The vertices of a cell, 0 … 3, in an order that VTK takes for a tetrahedron of positive volume. Sorted by
/// number, about half of the cells stand the other way.
std::array<vtkIdType, 4> positive_order(const TetrahedralMesh& mesh, CellIndex cell);

/// The cells of a mesh, which share its points.
vtkSmartPointer<vtkUnstructuredGrid> joined_cells(const TetrahedralMesh& mesh);

}  // namespace etendue
