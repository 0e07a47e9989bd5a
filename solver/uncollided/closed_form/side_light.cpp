// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/uncollided/closed_form/side_light.h"

#include <cmath>

#include "solver/uncollided/closed_form/exponential_integrals.h"
#include "solver/uncollided/closed_form/side_points.h"

namespace etendue {

FootIntegrals::FootIntegrals(double height, double extinction) {
  const ExponentialIntegrals of_height = exponential_integrals(Eight::Constant(extinction * height));
  second = of_height.second[0];
  third = of_height.third[0];
}

// df = d ds / (r^2 - h^2) has a pole where r = h, but there the differences vanish.
SideLight light_of_side(const SeenSide& side, double extinction, const FootIntegrals& below) {
  const double h = side.height;
  SideLight light;
  for_points_of_side(std::hypot(h, side.distance), side.first, side.last, [&](const SidePoints& points) {
    const auto& [r, s, length] = points;
    const Eight angle = side.distance * length / (side.distance * side.distance + s * s);
    const Eight slope = h / r;
    const ExponentialIntegrals integrals = exponential_integrals(extinction * r);
    light.fluence += (angle * (below.second - slope * integrals.second)).sum();
    light.upward += (angle * (below.third - slope * slope * integrals.third)).sum();
    light.outward += (length * slope / r * integrals.third).sum();
  });
  return light;
}

}  // namespace etendue
