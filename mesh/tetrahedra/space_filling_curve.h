// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/vec3.h"

namespace etendue {

/// The place of a lattice point along the Hilbert curve through the cube of 2^21 points a side.
/// Skilling, J. (2004): Programming the Hilbert curve. AIP Conf. Proc. 707, 381.
std::uint64_t hilbert_key(std::uint32_t x, std::uint32_t y, std::uint32_t z);

/// The indices of points in their order along the Hilbert curve through their bounding cube: neighbours
/// in memory are neighbours in space. Points with the same key keep their order.
std::vector<std::int32_t> curve_order(std::span<const Vec3> points);

}  // namespace etendue
