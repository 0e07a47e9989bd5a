// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "solver/angular/media/ray_matter.h"
#include "solver/uncollided/projection/cell_light.h"

namespace etendue {

/// Segment of a ray within a cell.
struct RaySegment {
  Vec3 entry;
  Vec3 direction;
  double length;
  std::array<double, 4> shape;  ///< functions at the entry
  std::array<double, 4> rise;   ///< of the shape functions along the segment [1/length]
};

/// `gradients` are the cell's shape_gradients().
RaySegment segment_through(const LitCell& cell, const std::array<Vec3, 4>& gradients, const Vec3& entry,
                           const Vec3& direction, double length);

/// Of the four functions that are linear in a cell [1/length].
std::array<Vec3, 4> shape_gradients(const LitCell& cell);

/// Adds the integrals of the shape functions along a segment for light that enters with these powers [band].
void add_segment(const RayMatter& matter, const LitCell& cell, const RaySegment& segment,
                 std::span<const double> power, NodalMoments& moments);

/// Adds what is absorbed and scatters of a fluence at a point, where that depends on its direction.
void add_losses(const std::array<double, 4>& shape, double measure, const PathCoefficients& coefficients,
                std::size_t band, double fluence, NodalMoments& moments);

}  // namespace etendue
