// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/write/vtk/vtk_files.h"
#include "app/write/vtk/vtk_output.h"

namespace etendue {

MeshFileOptions mesh_file_options(const Case& input) {
  MeshFileOptions options{input.output.encoding, origin_texts(input.title)};
  options.field_texts.push_back({"units", {coordinate_unit(input.units.length)}});
  return options;
}

}  // namespace etendue
