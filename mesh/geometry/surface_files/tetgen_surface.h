// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>

#include "mesh/geometry/primitives/surface_complex.h"
#include "mesh/geometry/surface_files/surface_file.h"

namespace etendue {

/// A TetGen .poly or .smesh file, with its .node file where it has no points of its own (Si 2015, 5.2).
/// Facets are walls named by their marker; the file's region list names regions by attribute.
SurfaceComplex read_tetgen_surface(const std::filesystem::path& path, const SurfaceFileOptions& options);

}  // namespace etendue
