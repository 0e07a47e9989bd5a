// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/photons/sampling/angle_table.h"

#include <algorithm>
#include <cmath>

namespace etendue {
namespace {

constexpr int parts_of_a_piece = 400;

}  // namespace

AngleTable::AngleTable(std::span<const double> angles, std::span<const double> intensities) {
  if (angles.empty()) return;
  angle_.push_back(angles[0]);
  cumulative_.push_back(0);
  for (std::size_t i = 1; i < angles.size(); ++i) {
    if (angles[i] <= angles[i - 1]) continue;
    const double step = (angles[i] - angles[i - 1]) / parts_of_a_piece;
    const double rise = (intensities[i] - intensities[i - 1]) / parts_of_a_piece;
    for (int part = 0; part < parts_of_a_piece; ++part) {
      const auto density = [&](int node) {
        return (intensities[i - 1] + node * rise) * std::sin(angles[i - 1] + node * step);
      };
      angle_.push_back(angles[i - 1] + (part + 1) * step);
      density_.insert(density_.end(), {density(part), density(part + 1)});
      cumulative_.push_back(cumulative_.back() + step * (density(part) + density(part + 1)) / 2);
    }
  }
}

double AngleTable::draw(double u) const {
  const double wanted = u * cumulative_.back();
  const auto above = std::upper_bound(cumulative_.begin() + 1, cumulative_.end() - 1, wanted);
  const auto part = static_cast<std::size_t>(above - cumulative_.begin()) - 1;
  const double step = angle_[part + 1] - angle_[part];
  const double d0 = density_[2 * part], slope = density_[2 * part + 1] - d0;
  const double rest = (wanted - cumulative_[part]) / step;
  const double root = d0 + std::sqrt(std::max(0.0, d0 * d0 + 2 * slope * rest));
  return angle_[part] + (root > 0 ? std::clamp(2 * rest / root, 0.0, 1.0) : 0.0) * step;
}

}  // namespace etendue
