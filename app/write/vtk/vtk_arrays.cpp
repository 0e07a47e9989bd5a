// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/write/vtk/vtk_arrays.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkInformation.h>
#include <vtkInformationStringKey.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "app/write/image/color.h"

namespace etendue {
namespace {

void label_array(vtkDataArray& array, const ArrayLabel& label) {
  array.SetName(label.name.c_str());
  for (std::size_t i = 0; i < label.components.size(); ++i)
    array.SetComponentName(static_cast<vtkIdType>(i), label.components[i].c_str());
  if (!label.unit.empty()) array.GetInformation()->Set(vtkDataArray::UNITS_LABEL(), label.unit.c_str());
}

template <class Array, class Value>
vtkSmartPointer<vtkDataArray> copied(const ArrayLabel& label, int components, std::span<const Value> values) {
  vtkNew<Array> array;
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()) / components);
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  label_array(*array, label);
  return array.Get();
}

}  // namespace

vtkSmartPointer<vtkDataArray> vtk_array(const ArrayLabel& label, int components,
                                        std::span<const double> values) {
  return copied<vtkDoubleArray>(label, components, values);
}

vtkSmartPointer<vtkDataArray> vtk_array(const ArrayLabel& label, std::span<const std::int32_t> values) {
  return copied<vtkIntArray>(label, 1, values);
}

vtkSmartPointer<vtkDataArray> vtk_colors(const std::string& how, std::span<const std::uint8_t> rgb) {
  return copied<vtkUnsignedCharArray>({"color", {"red", "green", "blue"}, how}, 3, rgb);
}

void add_band_vectors(vtkDataSetAttributes& arrays, const ArrayLabel& label, std::span<const double> values) {
  const std::vector<std::string>& bands = label.components;
  std::vector<double> vectors(values.size() / bands.size());
  for (std::size_t band = 0; band < bands.size(); ++band) {
    for (std::size_t i = 0; i < vectors.size(); ++i) vectors[i] = values[i * bands.size() + band];
    const std::string name = bands.size() == 1 ? label.name : label.name + "_" + bands[band];
    arrays.AddArray(vtk_array({name, {"x", "y", "z"}, label.unit}, 3, vectors));
  }
}

vtkSmartPointer<vtkDataArray> color_array(const Bands& bands, std::span<const double> values,
                                          std::span<const double> weights, int points_per_weight,
                                          const std::string& unit) {
  const BandColor rule(bands);
  const WhiteBalance white(bands);
  const std::vector<double> rgb = linear_colors(rule, white, values, bands.names.size());
  const Exposure exposure = exposure_of(rgb, weights, points_per_weight);
  const std::string neutral = white.rule().empty() ? "" : "; " + white.rule();
  return vtk_colors(rule.rule() + neutral + "; " + describe(exposure, unit), display_colors(rgb, exposure));
}

void add_names(vtkFieldData& fields, const std::string& array, const std::vector<std::string>& names) {
  vtkNew<vtkStringArray> strings;
  strings->SetName(array.c_str());
  for (const std::string& name : names) strings->InsertNextValue(name);
  fields.AddArray(strings);
}

void add_bands(vtkFieldData& fields, const Bands& bands) {
  add_names(fields, "band_names", bands.names);
  if (!bands.edges.empty()) fields.AddArray(vtk_array({"band_edges", {}, "nm"}, 1, bands.edges));
}

void add_named_cells(vtkDataSet& data, const std::string& kind, std::span<const std::int32_t> numbers,
                     const std::vector<std::string>& names) {
  vtkNew<vtkStringArray> name_of_each;
  name_of_each->SetName((kind + "_name").c_str());
  name_of_each->SetNumberOfValues(static_cast<vtkIdType>(numbers.size()));
  for (std::size_t i = 0; i < numbers.size(); ++i)
    name_of_each->SetValue(static_cast<vtkIdType>(i), names[static_cast<std::size_t>(numbers[i])]);
  data.GetCellData()->AddArray(vtk_array({kind, {}, {}}, numbers));
  data.GetCellData()->AddArray(name_of_each);
  add_names(*data.GetFieldData(), kind + "_names", names);
}

std::array<vtkIdType, 4> positive_order(const TetrahedralMesh& mesh, CellIndex cell) {
  const auto& v = mesh.vertices(cell);
  const Vec3& origin = mesh.point(VertexIndex(v[0]));
  const Vec3 a = mesh.point(VertexIndex(v[1])) - origin;
  const Vec3 b = mesh.point(VertexIndex(v[2])) - origin;
  const Vec3 c = mesh.point(VertexIndex(v[3])) - origin;
  if (a.cross(b).dot(c) > 0) return {0, 1, 2, 3};
  return {0, 1, 3, 2};
}

vtkSmartPointer<vtkUnstructuredGrid> joined_cells(const TetrahedralMesh& mesh) {
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
  return grid.Get();
}

}  // namespace etendue
