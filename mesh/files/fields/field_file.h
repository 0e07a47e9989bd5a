// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "base/field_data.h"

namespace etendue {

/// An array of a file.
struct FieldRequest {
  std::filesystem::path path;
  std::string array;                   ///< empty: the only one that there is
  std::optional<FieldValues> on = {};  ///< empty: cells if they have the array, else points
  std::optional<int> component = {};   ///< from 0; must be given where there are several
  std::optional<double> time = {};     ///< of OpenFOAM [s]; empty: the last
};

/// Reads an array of a VTK unstructured grid (.vtu; its cells are cut into tetrahedra), a VTK image (.vti), a
/// NIfTI image (.nii, .nii.gz; a value for each voxel) or an OpenFOAM case (its folder, its controlDict or a
/// .foam file) by VTK, in a child process. Throws FileError where the file cannot be opened, InputError where
/// what it holds is wrong.
FieldData read_field(const FieldRequest& request);

}  // namespace etendue
