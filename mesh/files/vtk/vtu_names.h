// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <vtkType.h>

#include "base/name_table.h"

class vtkDataArray;
class vtkStringArray;
class vtkUnstructuredGrid;

namespace etendue {

/// The regions and walls of a grid: cell arrays `region` and `wall` of numbers into the string arrays
/// `region_names` and `wall_names` of the field data, or of names themselves. Throws InputError.
class VtuNames {
 public:
  VtuNames(const std::string& file, vtkUnstructuredGrid& grid);

  /// Number of the region of a cell; without the array that of "domain".
  int region(vtkIdType cell);
  /// Number of the wall of a cell; -1: none.
  int wall(vtkIdType cell);
  const std::vector<std::string>& region_names() const { return used_regions_.names(); }
  const std::vector<std::string>& wall_names() const { return used_walls_.names(); }

 private:
  [[noreturn]] void fail(const std::string& problem) const;
  vtkDataArray* integers(const char* name) const;
  /// Also enters the names into the table in the order of the file.
  vtkStringArray* names(const char* name, NameTable& table) const;
  /// The number that a cell has in an array.
  std::int64_t number(vtkDataArray* array, vtkIdType cell, const char* what) const;
  std::string name(vtkStringArray* names, std::int64_t number, vtkIdType cell, const std::string& what) const;

  const std::string& file_;
  vtkUnstructuredGrid& grid_;
  NameTable used_regions_, used_walls_;
  vtkDataArray *regions_, *walls_;
  vtkStringArray *region_names_, *wall_names_;
};

}  // namespace etendue
