// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vtkDataSet.h>

#include <filesystem>
#include <string>
#include <vector>

#include "mesh/files/mesh_file.h"
#include "mesh/files/vtk/vtk_encoding.h"

namespace etendue {

/// Field data that every VTK file has: `title` (where there is one) and `program` with its version.
std::vector<FieldTexts> origin_texts(const std::string& title);

/// The line of `units` about the points.
std::string coordinate_unit(const std::string& length_unit);

/// A VTK file that is to be written.
struct VtkFile {
  const std::filesystem::path& path;
  const std::filesystem::path& shown;  ///< the path in error messages
  VtkEncoding encoding;
  const std::string& title;      ///< of the case; may be empty
  std::string length_unit = {};  ///< of the coordinates; empty: they are no lengths
};

/// Adds to the field data the origin and `units`, a line for each array that has a unit ("fluence: W/m^2"),
/// then writes the data compressed. Throws FileError with the reason.
void write_vtk(vtkDataSet& data, const VtkFile& file);

}  // namespace etendue
