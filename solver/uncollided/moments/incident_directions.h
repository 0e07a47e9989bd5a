// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "solver/angular/sets/octahedral_grid.h"
#include "solver/uncollided/sources/light_source.h"

namespace etendue {

/// Resolution of the directions of a source: beams are kept as they are, points on all of the grid, lights
/// with an extent on every second or fourth of its points.
enum class AngularDetail { fine, medium, coarse };

/// The directions of travel of uncollided light where it scatters: those of the beams, and a grid on which
/// all others are interpolated linearly. The grid is the finer the more the phase functions of a problem
/// point forward.
class IncidentDirections {
 public:
  IncidentDirections(const Problem& problem, std::span<const Vec3> beams);

  std::size_t size() const { return beams_.size() + grid_.size(); }
  const Vec3& direction(std::size_t i) const {
    return i < beams_.size() ? beams_[i] : grid_.direction(i - beams_.size());
  }
  /// Directions around one and weights with which their sum is that one, exactly. A weight may be 0.
  OctahedralGrid::Weights weights(const Vec3& direction, AngularDetail detail) const;

 private:
  std::vector<Vec3> beams_;
  OctahedralGrid grid_;
};

}  // namespace etendue
