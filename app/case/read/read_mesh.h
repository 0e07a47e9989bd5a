// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "app/case/case.h"
#include "app/case/keys/section.h"

namespace etendue {

/// The geometry of a case. Files are resolved against the folder of the case.
MeshCase read_mesh_section(Section mesh, const std::filesystem::path& case_folder);

/// Boxes, spheres and cylinders in the order of the file, and the patches.
Geometry read_geometry(Section& mesh);

}  // namespace etendue
