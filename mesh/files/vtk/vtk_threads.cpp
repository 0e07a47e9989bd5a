// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Compiled as C++17: the header of VTK 9.1 declares constructors in a way that C++20 forbids.
#include "mesh/files/vtk/vtk_threads.h"

#include <vtkObject.h>
#include <vtkSMPTools.h>

namespace etendue {

void use_vtk_without_threads() { vtkSMPTools::SetBackend("Sequential"); }

}  // namespace etendue
