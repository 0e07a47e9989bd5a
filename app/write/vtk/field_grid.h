// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>

#include "app/write/result/run_result.h"

namespace etendue {

/// Content of fields.vtu.
vtkSmartPointer<vtkUnstructuredGrid> field_grid(const RunResult& result);

}  // namespace etendue
