// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "solver/radiosity/patches/wall_patches.h"

namespace etendue {

/// Where patches are cut. Patches stay as they are where nothing is asked for.
struct RefinementRule {
  double change = 0;    ///< of the irradiance between neighbours, of its mean over all walls; 0: none is cut
  double smallest = 0;  ///< patches of this size and below are not cut [length]
};

/// [patch] Which are cut: those whose irradiance [patch][band] differs in some band from that of one of the
/// patch_neighbours() by more than the rule has it, and those that would be more than three times as large as
/// a neighbour (Cohen, Greenberg, Immel, Brock 1986; graded as in Baum, Mann, Smith, Winget 1991).
std::vector<bool> patches_to_cut(const TetrahedralMesh& mesh, const WallPatches& patches,
                                 const std::vector<double>& irradiance, const RefinementRule& rule);

}  // namespace etendue
