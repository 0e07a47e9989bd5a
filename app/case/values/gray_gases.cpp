// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/values/gray_gases.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "app/case/values/gray_gas_lines.h"

namespace etendue {
namespace {

double at_ratio(const BordbarLine& line, double molar_ratio) {
  double sum = 0;
  for (const double term : {line.ratio_4, line.ratio_3, line.ratio_2, line.ratio_1, line.ratio_0})
    sum = sum * molar_ratio + term;
  return sum;
}

/// A gray gas of a fit: its absorption [1/(m atm)], and factors of T^0, T^1 and so on [K] of its weight.
struct FittedGas {
  double absorption;
  std::vector<double> weight;
};

/// The gas that does not absorb and has what the others leave of the power, and then the others.
GrayGases with_clear_gas(std::vector<FittedGas> fitted, double lowest, double highest) {
  FittedGas clear{0, std::vector<double>(fitted.front().weight.size(), 0.0)};
  clear.weight.front() = 1;
  for (const FittedGas& gas : fitted)
    for (std::size_t k = 0; k < clear.weight.size(); ++k) clear.weight[k] -= gas.weight[k];
  fitted.insert(fitted.begin(), std::move(clear));
  GrayGases mixture{{}, lowest, highest};
  for (FittedGas& gas : fitted)
    mixture.gases.push_back(
        {gas.absorption, TemperatureCurve::Polynomial{std::move(gas.weight), lowest, highest}});
  return mixture;
}

}  // namespace

GrayGases bordbar_gases(double molar_ratio) {
  std::vector<FittedGas> gases;
  for (const BordbarLine& line : bordbar_lines()) {
    gases.resize(std::max(gases.size(), static_cast<std::size_t>(line.gas)),
                 {0, std::vector<double>(5, 0.0)});
    FittedGas& gas = gases[static_cast<std::size_t>(line.gas - 1)];
    const int power = line.quantity - BordbarLine::weight_0;
    const double value = at_ratio(line, molar_ratio);
    if (line.quantity == BordbarLine::absorption)
      gas.absorption = value;
    else
      gas.weight[static_cast<std::size_t>(power)] = value / std::pow(bordbar_kelvin, power);
  }
  return with_clear_gas(std::move(gases), bordbar_lowest, bordbar_highest);
}

GrayGases smith_gases(int molar_ratio) {
  std::vector<FittedGas> gases;
  for (const SmithLine& line : smith_lines())
    if (line.molar_ratio == molar_ratio)
      gases.push_back({line.absorption, {line.weight_0, line.weight_1, line.weight_2, line.weight_3}});
  return with_clear_gas(std::move(gases), 600, 2400);
}

}  // namespace etendue
