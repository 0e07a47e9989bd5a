// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/files/vtk/vtu_names.h"

#include <cmath>
#include <limits>

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>

#include "mesh/files/vtk/refused_file.h"

namespace etendue {

VtuNames::VtuNames(const std::string& file, vtkUnstructuredGrid& grid)
    : file_(file),
      grid_(grid),
      regions_(integers("region")),
      walls_(integers("wall")),
      region_names_(names("region_names", used_regions_)),
      wall_names_(names("wall_names", used_walls_)) {}

int VtuNames::region(vtkIdType cell) {
  return used_regions_.index(
      regions_ == nullptr ? "domain" : name(region_names_, number(regions_, cell, "region"), cell, "region"));
}

int VtuNames::wall(vtkIdType cell) {
  const std::int64_t wall = walls_ == nullptr ? -1 : number(walls_, cell, "wall");
  return wall == -1 ? -1 : used_walls_.index(name(wall_names_, wall, cell, "wall"));
}

void VtuNames::fail(const std::string& problem) const { refuse_file(file_, problem); }

vtkDataArray* VtuNames::integers(const char* name) const {
  vtkAbstractArray* found = grid_.GetCellData()->GetAbstractArray(name);
  if (found == nullptr) return nullptr;
  vtkDataArray* array = vtkDataArray::SafeDownCast(found);
  if (array == nullptr || array->GetNumberOfComponents() != 1 ||
      array->GetNumberOfTuples() != grid_.GetNumberOfCells())
    fail(std::string("cell array ") + name + ": must be one integer for each cell");
  return array;
}

vtkStringArray* VtuNames::names(const char* name, NameTable& table) const {
  vtkAbstractArray* found = grid_.GetFieldData()->GetAbstractArray(name);
  if (found == nullptr) return nullptr;
  vtkStringArray* array = vtkStringArray::SafeDownCast(found);
  if (array == nullptr) fail(std::string("field array ") + name + ": must hold strings");
  for (vtkIdType i = 0; i < array->GetNumberOfValues(); ++i) table.index(array->GetValue(i));
  return array;
}

std::int64_t VtuNames::number(vtkDataArray* array, vtkIdType cell, const char* what) const {
  const double value = array->GetTuple1(cell);
  if (!(std::abs(value) <= std::numeric_limits<std::int32_t>::max()) || value != std::floor(value))
    fail("cell " + std::to_string(cell) + ": " + what + " = " + std::to_string(value) +
         ": must be an integer");
  return static_cast<std::int64_t>(value);
}

std::string VtuNames::name(vtkStringArray* names, std::int64_t number, vtkIdType cell,
                           const std::string& what) const {
  if (names == nullptr) return std::to_string(number);
  if (number < 0 || number >= names->GetNumberOfValues())
    fail("cell " + std::to_string(cell) + ": " + what + " = " + std::to_string(number) +
         ": has no name; there are " + std::to_string(names->GetNumberOfValues()) + " in " + what + "_names");
  return names->GetValue(number);
}

}  // namespace etendue
