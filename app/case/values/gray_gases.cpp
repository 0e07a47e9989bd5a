// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/values/gray_gases.h"

#include <array>
#include <cmath>
#include <initializer_list>

namespace etendue {
namespace {

using Quartic = std::array<double, 5>;

/// A gas of Bordbar, Wecel and Hyppanen (2014): polynomials of the molar ratio, constant terms first.
struct BordbarGas {
  Quartic absorption;                ///< [1/(m atm)]
  std::array<Quartic, 5> in_kelvin;  ///< factors of (T/1200 K)^0 to (T/1200 K)^4
};

constexpr std::array<BordbarGas, 4> bordbar = {
    {{{0.03404288, 0.06523048, -0.04636852, 0.01386835, -0.001444993},
      {{{0.7412956, -0.5244441, 0.582286, -0.2096994, 0.02420312},
        {-0.9412652, 0.2799577, -0.7672319, 0.3204027, -0.03910174},
        {0.8531866, 0.08230754, 0.528943, -0.2468463, 0.03109396},
        {-0.3342806, 0.1474987, -0.4160689, 0.1697627, -0.0204066},
        {0.04314362, -0.06886217, 0.1109773, -0.04208608, 0.004918817}}}},
     {{0.3509457, 0.7465138, -0.529309, 0.1594423, -0.01663261},
      {{{0.1552073, -0.4862117, 0.3668088, -0.1055508, 0.01058568},
        {0.6755648, 1.409271, -1.383449, 0.457521, -0.0501976},
        {-1.125394, -0.5913199, 0.9085441, -0.3334201, 0.03842361},
        {0.6040543, -0.05533854, -0.1733014, 0.07916083, -0.009893357},
        {-0.1105453, 0.04646634, -0.001612982, -0.003539835, 0.000612177}}}},
     {{4.57074, 2.168067, -1.498901, 0.4917165, -0.0542999},
      {{{0.2550242, 0.3805403, -0.4249709, 0.1429446, -0.01574075},
        {-0.6065428, 0.3494024, 0.1853509, -0.1013694, 0.01302441},
        {0.8123855, -1.102009, 0.4046178, -0.08118223, 0.006298101},
        {-0.453229, 0.6784475, -0.3432603, 0.08830883, -0.008415221},
        {0.08693093, -0.1306996, 0.07414464, -0.02029294, 0.002010969}}}},
     {{109.8169, -50.92359, 23.43236, -5.163892, 0.4393889},
      {{{-0.03451994, 0.2656726, -0.1225365, 0.03001508, -0.002820525},
        {0.4112046, -0.572835, 0.292449, -0.07980766, 0.007996603},
        {-0.5055995, 0.4579559, -0.2616436, 0.07648413, -0.007908356},
        {0.2317509, -0.1656759, 0.1052608, -0.03219347, 0.003386965},
        {-0.03754908, 0.02295193, -0.01600472, 0.005046318, -0.0005364326}}}}}};

double polynomial(const Quartic& terms, double x) {
  double sum = 0;
  for (auto term = terms.rbegin(); term != terms.rend(); ++term) sum = sum * x + *term;
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
  for (const BordbarGas& fit : bordbar) {
    FittedGas gas{polynomial(fit.absorption, molar_ratio), {}};
    for (std::size_t k = 0; k < fit.in_kelvin.size(); ++k)
      gas.weight.push_back(polynomial(fit.in_kelvin[k], molar_ratio) / std::pow(1200.0, k));
    gases.push_back(std::move(gas));
  }
  // The fit begins at 300 K, where for some ratios it gives the gray gases more than all power.
  return with_clear_gas(std::move(gases), 330, 2400);
}

GrayGases smith_gases(int molar_ratio) {
  if (molar_ratio == 1)
    return with_clear_gas({{0.4303, {5.150e-1, -2.303e-4, 0.9779e-7, -1.494e-11}},
                           {7.055, {0.7749e-1, 3.399e-4, -2.297e-7, 3.770e-11}},
                           {178.1, {1.907e-1, -1.824e-4, 0.5608e-7, -0.5122e-11}}},
                          600, 2400);
  return with_clear_gas({{0.4201, {6.508e-1, -5.551e-4, 3.029e-7, -5.353e-11}},
                         {6.516, {-0.2504e-1, 6.112e-4, -3.882e-7, 6.528e-11}},
                         {131.9, {2.718e-1, -3.118e-4, 1.221e-7, -1.612e-11}}},
                        600, 2400);
}

}  // namespace etendue
