// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "mesh/geometry/primitives/exact.h"

namespace etendue {

/// A facet in triangles that use its corners only (constrained Delaunay). Corners that were rounded off their
/// plane still lie in the planes of their triangles. `edges` have the facet on their left where `axis` is
/// dropped; `lone` are corners inside; `point` gives a corner's coordinates.
std::vector<std::array<int, 3>> facet_triangles(const std::vector<std::array<int, 2>>& edges,
                                                const std::vector<int>& lone, int axis,
                                                const std::function<const ExactPoint&(int)>& point);

}  // namespace etendue
