// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>

class vtkUnstructuredGrid;

namespace etendue {

/// Names the first fault in the lists of an unstructured grid, which VTK follows without a check;
/// empty: nothing.
std::string cell_problem(vtkUnstructuredGrid& grid);

}  // namespace etendue
