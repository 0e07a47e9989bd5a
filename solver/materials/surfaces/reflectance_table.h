// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "solver/materials/surfaces/reflectance.h"

namespace etendue {

/// What was measured of a surface without a grain, point by point.
struct ReflectancePoint {
  double angle_in;   ///< from the normal to the light [degree]
  double angle_out;  ///< from the normal to the reflected light [degree]
  double azimuth;    ///< between both, about the normal, 0 … 180 [degree]; 180: to the mirror's side
  double value;      ///< f_r [1/sr]
};

/// A measured reflectance: linear between the points of a grid in both angles and the azimuth, constant
/// beyond its ends. Light may go both ways: the angles in and out are the same, and values that differ by a
/// small part when they are exchanged are replaced by their mean.
class ReflectanceTable : public Reflectance {
 public:
  /// The points of a whole grid, in any order, that has no problem; values are multiplied by `factor`.
  ReflectanceTable(const std::vector<ReflectancePoint>& points, double factor);

  /// Why the points are no reflectance: no grid, angles out of range, values below 0, or f_r that differs
  /// when the directions are exchanged, with the angles. Empty where they are one.
  static std::string problem_of(const std::vector<ReflectancePoint>& points);

  double value(double cos_in, double cos_out, double between) const override;
  ReflectedRay sample(double cos_in, double u, double v) const override;

 private:
  double exact_albedo(double cos_in) const;
  double at(double angle_in, double angle_out, double azimuth) const;
  double node(std::size_t in, std::size_t out, std::size_t azimuth) const {
    return values_[(in * angles_.size() + out) * azimuths_.size() + azimuth];
  }

  std::vector<double> angles_;    ///< in and out [radian]
  std::vector<double> azimuths_;  ///< [radian]
  std::vector<double> values_;    ///< [in][out][azimuth] [1/sr]
};

}  // namespace etendue
