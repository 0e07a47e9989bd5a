// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>

#include "mesh/files/vtk/vtk_encoding.h"

class vtkDataSet;

namespace etendue {

enum class VtkCompression {
  zlib,  ///< read by programs without VTK too
  lz4,   ///< twenty times as fast as zlib, and fields are a tenth longer
};

/// Writes an unstructured grid or a surface as a VTK XML file. Throws FileError with the reason; `shown` is
/// the path in its message.
void write_vtk_file(vtkDataSet& data, const std::filesystem::path& path, const std::filesystem::path& shown,
                    VtkEncoding encoding, VtkCompression compression);

}  // namespace etendue
