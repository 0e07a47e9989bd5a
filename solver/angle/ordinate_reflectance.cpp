// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/angle/ordinate_reflectance.h"

#include <algorithm>
#include <cmath>

#include "solver/problem/mirror.h"

namespace etendue {

std::vector<double> ordinate_reflectances(const DirectionSet& directions, const Wall& wall,
                                          const Vec3& normal) {
  std::vector<double> reflected;
  double sum = 0, whole = 0, movable = 0;
  for (std::int32_t m = 0; m < directions.count(); ++m) {
    const double weight = directions.weight(OrdinateIndex(m));
    const double cosine = std::abs(normal.dot(directions.direction(OrdinateIndex(m))));
    reflected.push_back(mean_fresnel_reflectance(cosine, weight, wall.refractive_index));
    const double part = reflected.back();
    sum += weight * cosine * part;
    movable += weight * cosine * part * (1 - part);
    whole += weight * cosine;
  }
  const double missing = whole * mirrored_part_of_isotropic(wall, 0) - sum;
  const double moved = movable > 0 ? std::clamp(missing / movable, -1.0, 1.0) : 0;
  for (double& part : reflected) part += moved * part * (1 - part);
  return reflected;
}

}  // namespace etendue
