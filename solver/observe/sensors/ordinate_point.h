// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "mesh/tetrahedra/search/cell_locator.h"
#include "solver/solution/direction_set_solution.h"

namespace etendue {

/// Light at a point, [band] [power/length^2].
struct OrdinatesAtPoint {
  std::vector<double> irradiance;  ///< on the side of a plane that its normal points to
  std::vector<double> fluence;
};

/// The sums over the ordinates at a point,
///
///     E = sum over n of w_n max(0, -w_n.normal) u_n,        phi = sum over n of w_n u_n,
///
/// from their radiance, which the solution must have kept; where the point lies in several cells the mean
/// over them, weighted by volume. Rays of the directions are in them.
OrdinatesAtPoint ordinates_at_point(const TetrahedralMesh& mesh, const DirectionSetSolution& swept,
                                    std::span<const CellPoint> cells, const Vec3& normal);

}  // namespace etendue
