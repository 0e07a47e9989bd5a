// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <utility>
#include <variant>
#include <vector>

#include "base/piecewise_linear.h"

namespace etendue {

/// A property by the temperature T [K]. Beyond the temperatures for which it is known it is that of the
/// nearest.
class TemperatureCurve {
 public:
  struct Polynomial {
    std::vector<double> terms;  ///< factors of T^0, T^1 and so on
    double lowest, highest;     ///< temperatures for which it is known [K]
  };
  struct Table {
    std::vector<double> kelvin;  ///< rising [K]
    std::vector<double> values;  ///< as many; linear between
  };

  /// The same at all temperatures.
  TemperatureCurve(double value) : form_(Table{{0}, {value}}) {}
  TemperatureCurve(Polynomial form) : form_(std::move(form)) {}
  TemperatureCurve(Table form) : form_(std::move(form)) {}

  /// With the derivative by the temperature [1/K], which is 0 beyond the temperatures for which it is known.
  ValueAndSlope with_slope_at(double kelvin) const;
  double at(double kelvin) const { return with_slope_at(kelvin).value; }
  bool is_constant() const;

  const std::variant<Polynomial, Table>& form() const { return form_; }

 private:
  std::variant<Polynomial, Table> form_;
};

}  // namespace etendue
