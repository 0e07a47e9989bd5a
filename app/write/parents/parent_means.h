// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "app/write/result/run_result.h"

namespace etendue {

/// [parent] volumes of the cells that a mesh was cut from: the sums of their parts [length^3].
std::vector<double> parent_volumes(const TetrahedralMesh& mesh);

/// [parent] numbers of the regions.
std::vector<std::int32_t> parent_regions(const TetrahedralMesh& mesh);

/// [parent][component] means over the volume of [cell][component] values, so that integrals stay the same.
std::vector<double> parent_means(const TetrahedralMesh& mesh, std::span<const double> values,
                                 std::size_t components);

/// [face of the parents' mesh] mean over the area of the radiative heat flux into the wall, all bands
/// together [power/length^2]; 0 within.
std::vector<double> parent_heat_flux(const RunResult& result);

}  // namespace etendue
