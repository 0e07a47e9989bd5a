// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "solver/radiosity/patches/wall_patches.h"

namespace etendue {

/// [patch] the patches that share an edge or a part of one with it, where the light on both is continuous:
/// in one plane and with nothing standing between them (flat_neighbours()). By rising number.
std::vector<std::vector<std::size_t>> patch_neighbours(const TetrahedralMesh& mesh,
                                                       const WallPatches& patches);

}  // namespace etendue
