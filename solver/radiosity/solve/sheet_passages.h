// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "solver/radiosity/patches/wall_patches.h"
#include "solver/radiosity/solve/radiosity_equation.h"

namespace etendue {

/// The patches on both sides of all sheets that have an area in common, each way. What passes has the same
/// area on both sides, so that no power is lost.
std::vector<SheetPassage> sheet_passages(const TetrahedralMesh& mesh, const WallPatches& patches);

}  // namespace etendue
