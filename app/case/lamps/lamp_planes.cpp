// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/lamps/lamp_planes.h"

#include <algorithm>
#include <cmath>

namespace etendue {
namespace {

/// Planes that differ by less than this part of the largest intensity are measured alike.
constexpr double alike = 1e-9;

}  // namespace

void mirror_planes(double about, std::vector<double>& angles, LampPlanes& planes) {
  for (std::size_t i = angles.size(); i-- > 0;)
    if (angles[i] < about) {
      angles.push_back(2 * about - angles[i]);
      planes.push_back(LampPlanes::value_type(planes[i]));
    }
}

bool all_alike(const LampPlanes& planes) {
  double largest = 0, spread = 0;
  for (const std::vector<double>& plane : planes)
    for (std::size_t i = 0; i < plane.size(); ++i) {
      largest = std::max(largest, plane[i]);
      spread = std::max(spread, std::abs(plane[i] - planes.front()[i]));
    }
  return spread <= alike * largest;
}

}  // namespace etendue
