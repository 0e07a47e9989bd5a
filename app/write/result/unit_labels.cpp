// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/write/result/unit_labels.h"

namespace etendue {
namespace {

/// "W" over "m^2" is "W/m^2", "W" over "m^2 sr" is "W/(m^2 sr)", "1/s" over "m^2" is "1/(s m^2)".
std::string per(const std::string& power, const std::string& below) {
  const std::string reciprocal = "1/";
  if (power.rfind(reciprocal, 0) == 0) return "1/(" + power.substr(reciprocal.size()) + " " + below + ")";
  return below.find(' ') == std::string::npos ? power + "/" + below : power + "/(" + below + ")";
}

}  // namespace

UnitLabels::UnitLabels(const Units& units, AngularSpace space)
    : length(units.length),
      volume(units.length + "^3"),
      area(units.length + "^2"),
      power(units.power),
      flux(per(power, area)),
      radiance(per(power, area + (space == AngularSpace::sphere ? " sr" : " rad"))),
      intensity(per(power, space == AngularSpace::sphere ? "sr" : "rad")),
      coefficient("1/" + length),
      emission(per(power, volume + (space == AngularSpace::sphere ? " sr" : " rad"))) {}

}  // namespace etendue
