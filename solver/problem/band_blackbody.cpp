// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/problem/band_blackbody.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/blackbody.h"

namespace etendue {
namespace {

ValueAndSlope fraction_between(double one, double other, double kelvin) {
  const auto [low, high] = std::minmax(one, other);
  return {planck_fraction(high, kelvin) - planck_fraction(low, kelvin),
          high * blackbody_fraction_slope(high * kelvin) - low * blackbody_fraction_slope(low * kelvin)};
}

/// The fraction of a blackbody's power that is in a band, and its derivative by the temperature [1/K].
ValueAndSlope fraction_of(const Bands& bands, int band, double kelvin) {
  const auto b = static_cast<std::size_t>(band);
  if (!bands.gas.gases.empty()) return bands.gas.gases[b].weight.with_slope_at(kelvin);
  if (bands.edges.empty()) return {1, 0};
  return fraction_between(bands.edges[b], bands.edges[b + 1], kelvin);
}

}  // namespace

double band_blackbody(const Bands& bands, int band, double kelvin) {
  return std::pow(bands.refractive_index, 2) * stefan_boltzmann / std::numbers::pi * std::pow(kelvin, 4) *
         fraction_of(bands, band, kelvin).value;
}

double band_share_of_change(const Bands& bands, int band, double kelvin) {
  const ValueAndSlope fraction = fraction_of(bands, band, kelvin);
  return fraction.value + kelvin / 4 * fraction.slope;
}

double band_blackbody_slope(const Bands& bands, int band, double kelvin) {
  return std::pow(bands.refractive_index, 2) * 4 * stefan_boltzmann / std::numbers::pi * std::pow(kelvin, 3) *
         band_share_of_change(bands, band, kelvin);
}

}  // namespace etendue
