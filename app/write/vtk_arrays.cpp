// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/write/vtk_arrays.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkErrorCode.h>
#include <vtkInformation.h>
#include <vtkInformationStringKey.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkPoints.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <system_error>

#include "mesh/base/errors.h"
#include "mesh/files/vtk_threads.h"

namespace etendue {
namespace {

/// A text as the value of an XML attribute. VTK writes names as they are, but units by itself like this.
std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '&')
      result += "&amp;";
    else if (c == '<')
      result += "&lt;";
    else if (c == '>')
      result += "&gt;";
    else if (c == '"')
      result += "&quot;";
    else
      result += c;
  }
  return result;
}

void label_array(vtkDataArray& array, const ArrayLabel& label) {
  array.SetName(escaped(label.name).c_str());
  for (std::size_t i = 0; i < label.components.size(); ++i)
    array.SetComponentName(static_cast<vtkIdType>(i), escaped(label.components[i]).c_str());
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

/// VTK prints its errors; here they are thrown.
class QuietVtk {
 public:
  QuietVtk() : before_(vtkObject::GetGlobalWarningDisplay()) { vtkObject::GlobalWarningDisplayOff(); }
  ~QuietVtk() { vtkObject::SetGlobalWarningDisplay(before_); }
  QuietVtk(const QuietVtk&) = delete;
  QuietVtk& operator=(const QuietVtk&) = delete;

 private:
  int before_;
};

std::string reason(unsigned long vtk_error) {
  if (vtk_error == vtkErrorCode::NoError) return "unknown reason";
  // Below VTK's own codes stand those of the system.
  if (vtk_error < vtkErrorCode::FirstVTKErrorCode)
    return std::generic_category().message(static_cast<int>(vtk_error));
  return vtkErrorCode::GetStringFromErrorCode(vtk_error);
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

void add_names(vtkFieldData& fields, const std::string& array, const std::vector<std::string>& names) {
  vtkNew<vtkStringArray> strings;
  strings->SetName(array.c_str());
  for (const std::string& name : names) strings->InsertNextValue(name);
  fields.AddArray(strings);
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

void write_vtk(vtkXMLWriter& writer, const std::filesystem::path& path, const std::filesystem::path& shown) {
  use_vtk_without_threads();
  const QuietVtk quiet;
  writer.SetFileName(path.c_str());
  writer.SetDataModeToAppended();
  writer.EncodeAppendedDataOff();
  writer.SetCompressorTypeToLZ4();  // twenty times as fast as zlib, and fields are a tenth longer
  writer.SetHeaderTypeToUInt64();
  const int written = writer.Write();
  if (written == 0 || writer.GetErrorCode() != vtkErrorCode::NoError)
    throw FileError(shown.string(), "cannot be written (" + reason(writer.GetErrorCode()) + ")");
}

}  // namespace etendue
