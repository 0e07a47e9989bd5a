// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/case/case.h"

namespace etendue {

/// The largest volume that a cell of each region may have [length^3]; 0 where there is no bound.
std::vector<double> volume_bounds(const MeshCase& mesh, const std::vector<std::string>& regions);

}  // namespace etendue
