// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/observe/color/photometric_units.h"

#include <algorithm>
#include <numbers>

namespace etendue {
namespace {

constexpr double foot = 0.3048;  // [m], exact since 1959
constexpr double centimetre = 1e-2;
using std::numbers::pi;

// Wyszecki and Stiles, Color Science (1982), table 4.10: units of luminance with pi are those of a perfect
// diffuser under the illuminance of the same name.
const std::vector<PhotometricUnit> all = {
    {"lux", "lx", PhotometricDimension::illuminance, 1},
    {"phot", "ph", PhotometricDimension::illuminance, 1 / (centimetre * centimetre)},
    {"footcandle", "fc", PhotometricDimension::illuminance, 1 / (foot * foot)},
    {"radlux", "lm/m^2", PhotometricDimension::luminous_exitance, 1},
    {"radphot", "lm/cm^2", PhotometricDimension::luminous_exitance, 1 / (centimetre * centimetre)},
    {"lm/ft^2", "lm/ft^2", PhotometricDimension::luminous_exitance, 1 / (foot * foot)},
    {"nit", "cd/m^2", PhotometricDimension::luminance, 1},
    {"stilb", "sb", PhotometricDimension::luminance, 1 / (centimetre * centimetre)},
    {"lambert", "L", PhotometricDimension::luminance, 1 / (centimetre * centimetre) / pi},
    {"footlambert", "fL", PhotometricDimension::luminance, 1 / (foot * foot) / pi},
    {"apostilb", "asb", PhotometricDimension::luminance, 1 / pi},
    {"blondel", "blondel", PhotometricDimension::luminance, 1 / pi},
    {"lumen", "lm", PhotometricDimension::luminous_flux, 1},
    {"candela", "cd", PhotometricDimension::luminous_intensity, 1},
    {"talbot", "lm s", PhotometricDimension::luminous_energy, 1},
};

}  // namespace

std::span<const PhotometricUnit> photometric_units() { return all; }

std::vector<std::string> photometric_unit_names(PhotometricDimension dimension) {
  std::vector<std::string> names;
  for (const PhotometricUnit& unit : all) {
    if (unit.dimension != dimension) continue;
    names.push_back(unit.symbol);
    if (unit.name != unit.symbol) names.push_back(unit.name);
  }
  return names;
}

const PhotometricUnit* find_photometric_unit(const std::string& name) {
  const auto found = std::ranges::find_if(
      all, [&](const PhotometricUnit& unit) { return unit.name == name || unit.symbol == name; });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace etendue
