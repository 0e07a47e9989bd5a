// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/write/vtk/vtk_output.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkInformation.h>
#include <vtkInformationStringKey.h>
#include <vtkPointData.h>

#include "app/write/result/program_version.h"
#include "app/write/vtk/vtk_arrays.h"
#include "mesh/files/vtk/vtk_write.h"

namespace etendue {
namespace {

/// A text as the value of an XML attribute.
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

/// Escapes the names of arrays and components, which VTK 9.1 writes unchanged, unlike units.
void escape_names(vtkDataSetAttributes& arrays) {
  for (int i = 0; i < arrays.GetNumberOfArrays(); ++i) {
    vtkAbstractArray& array = *arrays.GetAbstractArray(i);
    array.SetName(escaped(array.GetName()).c_str());
    for (int c = 0; array.HasAComponentName() && c < array.GetNumberOfComponents(); ++c)
      if (const char* name = array.GetComponentName(c); name != nullptr)
        array.SetComponentName(c, escaped(name).c_str());
  }
}

void append_units(vtkDataSetAttributes& arrays, std::vector<std::string>& lines) {
  for (int i = 0; i < arrays.GetNumberOfArrays(); ++i) {
    vtkAbstractArray& array = *arrays.GetAbstractArray(i);
    if (!array.HasInformation() || !array.GetInformation()->Has(vtkDataArray::UNITS_LABEL())) continue;
    lines.push_back(std::string(array.GetName()) + ": " +
                    array.GetInformation()->Get(vtkDataArray::UNITS_LABEL()));
  }
}

std::vector<std::string> unit_lines(vtkDataSet& data, const std::string& length_unit) {
  std::vector<std::string> lines;
  if (!length_unit.empty()) lines.push_back(coordinate_unit(length_unit));
  append_units(*data.GetPointData(), lines);
  append_units(*data.GetCellData(), lines);
  return lines;
}

}  // namespace

std::string coordinate_unit(const std::string& length_unit) { return "coordinates: " + length_unit; }

std::vector<FieldTexts> origin_texts(const std::string& title) {
  std::vector<FieldTexts> texts;
  if (!title.empty()) texts.push_back({"title", {title}});
  texts.push_back({"program", {"etendue " + program_version()}});
  return texts;
}

void write_vtk(vtkDataSet& data, const VtkFile& file) {
  for (const FieldTexts& field : origin_texts(file.title))
    add_names(*data.GetFieldData(), field.name, field.texts);
  add_names(*data.GetFieldData(), "units", unit_lines(data, file.length_unit));
  escape_names(*data.GetPointData());
  escape_names(*data.GetCellData());
  write_vtk_file(data, file.path, file.shown, file.encoding, VtkCompression::lz4);
}

}  // namespace etendue
