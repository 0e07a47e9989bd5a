// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/values/blackbody_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "app/case/values/curve_value.h"
#include "app/case/values/value_algebra.h"
#include "base/blackbody.h"
#include "solver/problem/band_blackbody.h"

namespace etendue {
namespace {

/// Edges of a band in rising order [nm].
std::pair<double, double> band_edges(const Bands& bands, int band) {
  const auto b = static_cast<std::size_t>(band);
  return std::minmax(bands.edges[b], bands.edges[b + 1]);
}

}  // namespace

Value blackbody_radiance(const Value& temperature, const Bands& bands, int band) {
  const double factor = std::pow(bands.refractive_index, 2) * stefan_boltzmann / std::numbers::pi;
  if (is_number(temperature)) return band_blackbody(bands, band, std::get<double>(temperature));
  Formula formula = term(temperature);
  const std::string kelvin = formula.text;
  formula.text = fmt::format("{:.17g}*{}^4", factor, kelvin);
  if (!bands.gas.gases.empty())
    formula.text += "*" + curve_text(bands.gas.gases[static_cast<std::size_t>(band)].weight, kelvin);
  if (bands.edges.empty()) return formula;
  const auto [low, high] = band_edges(bands, band);
  formula.text += fmt::format("*(blackbody_fraction({:.17g}*{})-blackbody_fraction({:.17g}*{}))", high,
                              kelvin, low, kelvin);
  return formula;
}

double fraction_outside_bands(double kelvin, const Bands& bands) {
  if (bands.edges.empty()) return 0;
  const auto [low, high] = std::minmax(bands.edges.front(), bands.edges.back());
  return 1 - (planck_fraction(high, kelvin) - planck_fraction(low, kelvin));
}

}  // namespace etendue
