// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/heat/thermal_property.h"

namespace etendue {

double ThermalProperty::at(const Vec3& point, double kelvin) const {
  if (!formula_) return of_place_.at(point);
  return (*formula_)(std::array{point.x(), point.y(), point.z(), kelvin});
}

CellSample ThermalProperty::sample(const std::array<Vec3, 4>& vertices,
                                   const std::array<double, 4>& kelvin) const {
  if (!formula_) return of_place_.sample(vertices);
  Vec3 centroid = Vec3::Zero();
  double mean = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    centroid += vertices[i] / 4;
    mean += kelvin[i] / 4;
  }
  const double value = at(centroid, mean);
  return {value, value, centroid, {}};
}

}  // namespace etendue
