// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "app/case/case.h"
#include "app/case/section.h"

namespace etendue {

/// The geometry of a case. Files are resolved against the folder of the case.
MeshCase read_mesh_section(Section mesh, const std::filesystem::path& case_folder);

/// Boxes, spheres and cylinders in the order of the file, and the patches.
Geometry read_geometry(Section& mesh);

/// A path that the case names; one that the command line names is relative to the working directory.
std::filesystem::path resolve_path(const TomlNode& node, const std::filesystem::path& case_folder);

}  // namespace etendue
