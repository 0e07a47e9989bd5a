// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>

#include <vtkSmartPointer.h>

class vtkDataSet;

namespace etendue {

/// Reads a .vtu, .vti, .nii or .nii.gz file, or the inside of an OpenFOAM case at a time (empty: the last).
/// Throws InputError with what VTK has to complain about.
vtkSmartPointer<vtkDataSet> read_data_set(const std::filesystem::path& path, std::optional<double> time);

}  // namespace etendue
