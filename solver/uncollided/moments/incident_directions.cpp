// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/uncollided/moments/incident_directions.h"

#include <algorithm>
#include <cmath>

#include "solver/problem/phase_list.h"

namespace etendue {
namespace {

/// Divisions of the grid's octahedron: so many times the width 1 - |g| of the narrowest phase function,
/// within these bounds. A multiple of 4, so that coarser grids are parts of it
/// (docs/user/lights.md, First collisions).
constexpr double divisions_per_width = 6;
constexpr int fewest_divisions = 32, most_cube_divisions = 48;

int divisions_for(const Problem& problem) {
  double narrowest = 1;
  const PhaseList list(problem);
  for (const PhaseFunction& phase : list.phases())
    narrowest = std::min(narrowest, 1 - std::abs(phase_asymmetry(phase)));
  const double wanted = divisions_per_width / std::max(narrowest, 1e-3);
  return 4 *
         static_cast<int>(std::ceil(std::clamp<double>(wanted, fewest_divisions, most_cube_divisions) / 4));
}

}  // namespace

IncidentDirections::IncidentDirections(const Problem& problem, std::span<const Vec3> beams)
    : beams_(beams.begin(), beams.end()), grid_(divisions_for(problem)) {}

OctahedralGrid::Weights IncidentDirections::weights(const Vec3& direction, AngularDetail detail) const {
  for (std::size_t i = 0; i < beams_.size(); ++i)
    if (beams_[i] == direction) {
      const auto same = static_cast<std::int32_t>(i);
      return {{same, same, same}, {1, 0, 0}};
    }
  const int stride = detail == AngularDetail::fine ? 1 : detail == AngularDetail::medium ? 2 : 4;
  OctahedralGrid::Weights weights = grid_.weights(direction, stride);
  for (std::int32_t& point : weights.point) point += static_cast<std::int32_t>(beams_.size());
  return weights;
}

}  // namespace etendue
