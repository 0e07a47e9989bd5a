// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "solver/problem/problem.h"

namespace etendue {

/// Cells of a medium in which a kernel by formula is one and the same.
struct KernelPlace {
  Vec3 place;  ///< the centroid of the first
  std::vector<CellIndex> cells;
};

/// The places of a formula that is no product of a factor of the place and one of the directions, as 48 pairs
/// of directions at the centroids of a region's cells tell: it is then another kernel at each. Cells where
/// the values are the same are together. Empty for a product.
std::vector<KernelPlace> kernel_places(const KernelFormula& kernel, const TetrahedralMesh& mesh, int region);

/// The same of one medium and band; empty where that has no formula.
std::vector<KernelPlace> kernel_places(const Problem& problem, int region, int band);

}  // namespace etendue
