// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

namespace etendue {

/// Albedo of a surface, reflected into all directions, as a function of the angle of incidence: values at
/// angles of equal distance from 0 to 90 degrees, with cubics through four of them between.
class AlbedoTable {
 public:
  AlbedoTable() = default;
  /// Of a function of the cosine of incidence.
  explicit AlbedoTable(const std::function<double(double)>& albedo);

  double at(double cos_in) const;
  /// Of light that is the same from all directions: twice the integral of albedo times cosine.
  double mean() const { return mean_; }
  double largest() const { return largest_; }
  double angle_of_largest() const { return angle_of_largest_; }  ///< of incidence [degree]

 private:
  double at_angle(double angle) const;

  std::vector<double> values_;
  double mean_ = 0, largest_ = 0, angle_of_largest_ = 0;
};

}  // namespace etendue
