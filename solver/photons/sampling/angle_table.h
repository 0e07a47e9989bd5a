// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

namespace etendue {

/// Draws the angle from the axis of a light whose intensity is linear between given angles and zero beyond
/// them: the density in the angle is intensity × sin. Each piece is cut so finely that the density is linear
/// in a part.
class AngleTable {
 public:
  AngleTable() = default;
  /// Angles rise [rad]; of the intensities only the shape counts. Empty: the same in all directions.
  AngleTable(std::span<const double> angles, std::span<const double> intensities);

  bool empty() const { return angle_.empty(); }
  double draw(double u) const;

 private:
  std::vector<double> angle_;       ///< [node]
  std::vector<double> density_;     ///< [node] of both sides of a part: 2 for each part
  std::vector<double> cumulative_;  ///< [part + 1]
};

}  // namespace etendue
