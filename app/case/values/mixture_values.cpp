// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/values/mixture_values.h"

#include <vector>

#include "app/case/values/curve_value.h"
#include "app/case/values/gray_gas_lines.h"
#include "app/case/values/gray_gases.h"
#include "app/case/values/value_algebra.h"

namespace etendue {
namespace {

/// A quantity of a gas by the molar ratio, constant term first. The clear gas, number 0, has the power that
/// the others leave.
std::vector<double> terms_of(int gas, BordbarLine::Quantity quantity) {
  std::vector<double> terms(5, 0.0);
  if (gas == 0 && quantity == BordbarLine::weight_0) terms.front() = 1;
  const double sign = gas == 0 ? -1 : 1;
  for (const BordbarLine& line : bordbar_lines()) {
    if (line.quantity != quantity || (gas != 0 && line.gas != gas)) continue;
    const double of_line[] = {line.ratio_0, line.ratio_1, line.ratio_2, line.ratio_3, line.ratio_4};
    for (std::size_t k = 0; k < terms.size(); ++k) terms[k] += sign * of_line[k];
  }
  return terms;
}

Value by_ratio(int gas, BordbarLine::Quantity quantity, const Value& molar_ratio) {
  return curve_value(
      TemperatureCurve::Polynomial{terms_of(gas, quantity), lowest_molar_ratio, highest_molar_ratio},
      molar_ratio);
}

}  // namespace

Value bordbar_absorption(int gas, const Value& molar_ratio) {
  return gas == 0 ? Value(0.0) : by_ratio(gas, BordbarLine::absorption, molar_ratio);
}

Value bordbar_weight(int gas, const Value& molar_ratio, const Value& kelvin) {
  using enum BordbarLine::Quantity;
  const Value t = curve_value(
      TemperatureCurve::Polynomial{{0, 1 / bordbar_kelvin}, bordbar_lowest, bordbar_highest}, kelvin);
  std::vector<Value> terms;
  for (const auto quantity : {weight_0, weight_1, weight_2, weight_3, weight_4})
    terms.push_back(by_ratio(gas, quantity, molar_ratio));
  return polynomial(t, terms);
}

}  // namespace etendue
