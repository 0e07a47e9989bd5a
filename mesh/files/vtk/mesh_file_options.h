// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "mesh/files/vtk/vtk_encoding.h"

namespace etendue {

/// A named list of texts in the field data of a file.
struct FieldTexts {
  std::string name;
  std::vector<std::string> texts;
};

/// Form and additional content of a written mesh file.
struct MeshFileOptions {
  VtkEncoding encoding = VtkEncoding::inline_base64;
  std::vector<FieldTexts> field_texts = {};  ///< beside the names of regions and walls
};

}  // namespace etendue
