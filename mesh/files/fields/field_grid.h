// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/files/fields/field_file.h"

namespace etendue {

/// As read_field, in this process: VTK's readers trust the file, and a corrupt one can take the process
/// along.
FieldData read_field_by_vtk(const FieldRequest& request);

}  // namespace etendue
