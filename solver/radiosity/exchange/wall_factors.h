// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "solver/radiosity/exchange/exchange.h"
#include "solver/radiosity/patches/wall_patches.h"

namespace etendue {

/// Form factors of whole walls, [wall][wall]: F_ab is the part of what wall a sends, evenly and diffusely,
/// that arrives at wall b. A_a F_ab = A_b F_ba, and each row sums to one. Rows of walls without patches are
/// zero.
std::vector<double> factors_of_walls(const Exchange& exchange, const WallPatches& patches, std::size_t walls);

}  // namespace etendue
