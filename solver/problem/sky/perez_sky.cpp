// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/problem/sky/perez_sky.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace etendue {
namespace {

constexpr double solar_constant = 1367;  // [W/m^2], as in Perez et al. 1990

/// Lower ends of the classes of clearness; the first begins at 1.
constexpr std::array<double, clearness_bins - 1> lower_ends = {1.065, 1.23, 1.5, 1.95, 2.8, 4.5, 6.2};

using Coefficients = std::array<std::array<double, 4>, 5>;  // [a, b, c, d, e][1 .. 4]

// Perez et al. 1993, table 1.
constexpr std::array<Coefficients, clearness_bins> table = {{
    {{{1.3525, -0.2576, -0.2690, -1.4366},
      {-0.7670, 0.0007, 1.2734, -0.1233},
      {2.8000, 0.6004, 1.2375, 1.0000},
      {1.8734, 0.6297, 0.9738, 0.2809},
      {0.0356, -0.1246, -0.5718, 0.9938}}},
    {{{-1.2219, -0.7730, 1.4148, 1.1016},
      {-0.2054, 0.0367, -3.9128, 0.9156},
      {6.9750, 0.1774, 6.4477, -0.1239},
      {-1.5798, -0.5081, -1.7812, 0.1080},
      {0.2624, 0.0672, -0.2190, -0.4285}}},
    {{{-1.1000, -0.2515, 0.8952, 0.0156},
      {0.2782, -0.1812, -4.5000, 1.1766},
      {24.7219, -13.0812, -37.7000, 34.8438},
      {-5.0000, 1.5218, 3.9229, -2.6204},
      {-0.0156, 0.1597, 0.4199, -0.5562}}},
    {{{-0.5484, -0.6654, -0.2672, 0.7117},
      {0.7234, -0.6219, -5.6812, 2.6297},
      {33.3389, -18.3000, -62.2500, 52.0781},
      {-3.5000, 0.0016, 1.1477, 0.1062},
      {0.4659, -0.3296, -0.0876, -0.0329}}},
    {{{-0.6000, -0.3566, -2.5000, 2.3250},
      {0.2937, 0.0496, -5.6812, 1.8415},
      {21.0000, -4.7656, -21.5906, 7.2492},
      {-3.5000, -0.1554, 1.4062, 0.3988},
      {0.0032, 0.0766, -0.0656, -0.1294}}},
    {{{-1.0156, -0.3670, 1.0078, 1.4051},
      {0.2875, -0.5328, -3.8500, 3.3750},
      {14.0000, -0.9999, -7.1406, 7.5469},
      {-3.4000, -0.1078, -1.0750, 1.5702},
      {-0.0672, 0.4016, 0.3017, -0.4844}}},
    {{{-1.0000, 0.0211, 0.5025, -0.5119},
      {-0.3000, 0.1922, 0.7023, -1.6317},
      {19.0000, -5.0000, 1.2438, -1.9094},
      {-4.0000, 0.0250, 0.3844, 0.2656},
      {1.0468, -0.3788, -2.4517, 1.4656}}},
    {{{-1.0500, 0.0289, 0.4260, 0.3590},
      {-0.3250, 0.1156, 0.7781, 0.0025},
      {31.0625, -14.5000, -46.1148, 55.3750},
      {-7.2312, 0.4050, 13.3500, 0.6234},
      {1.5000, -0.6426, 1.8564, 0.5636}}},
}};

/// Kasten (1966), zenith angle [rad].
double air_mass(double zenith) {
  const double degrees = zenith * 180 / std::numbers::pi;
  return 1 / (std::cos(zenith) + 0.15 * std::pow(93.885 - degrees, -1.253));
}

}  // namespace

std::size_t clearness_bin(double clearness) {
  return static_cast<std::size_t>(std::ranges::upper_bound(lower_ends, clearness) - lower_ends.begin());
}

SkyConditions sky_conditions(double direct_normal, double diffuse_horizontal, double sun_zenith,
                             double eccentricity) {
  const double cubed = 1.041 * sun_zenith * sun_zenith * sun_zenith;
  return {((diffuse_horizontal + direct_normal) / diffuse_horizontal + cubed) / (1 + cubed),
          diffuse_horizontal * air_mass(sun_zenith) / (solar_constant * eccentricity)};
}

SkyShape perez_sky(const SkyConditions& conditions, double sun_zenith) {
  const std::size_t bin = clearness_bin(conditions.clearness);
  // The erratum: between overcast and clear the brightness is at least 0.2.
  const bool between = conditions.clearness > lower_ends[0] && conditions.clearness < lower_ends[4];
  const double delta = between ? std::max(conditions.brightness, 0.2) : conditions.brightness;
  const Coefficients& x = table[bin];
  const auto linear = [&](std::size_t i) {
    return x[i][0] + x[i][1] * sun_zenith + delta * (x[i][2] + x[i][3] * sun_zenith);
  };
  SkyShape sky{linear(0), linear(1), linear(2), linear(3), linear(4)};
  if (bin == 0) {
    sky.c = std::exp(std::pow(delta * (x[2][0] + x[2][1] * sun_zenith), x[2][2])) - x[2][3];
    sky.d = -std::exp(delta * (x[3][0] + x[3][1] * sun_zenith)) + x[3][2] + delta * x[3][3];
  }
  return sky;
}

}  // namespace etendue
