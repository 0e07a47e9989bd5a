// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/files/fields/field_file.h"

#include <cstdio>
#include <fstream>

#include "base/errors.h"
#include "mesh/files/fields/field_data_bytes.h"
#include "mesh/files/fields/field_grid.h"
#include "mesh/files/vtk/vtk_child.h"

namespace etendue {
FieldData read_field(const FieldRequest& request) {
  if (!std::filesystem::is_directory(request.path) && !std::ifstream(request.path))
    throw FileError(request.path.string(), "cannot be opened");
  return take_field_data(read_in_child(
      request.path, [&](std::FILE* file) { write_field_data(file, read_field_by_vtk(request)); }));
}

}  // namespace etendue
