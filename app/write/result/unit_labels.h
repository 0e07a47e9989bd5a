// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>

#include "app/case/case.h"

namespace etendue {

/// Labels of derived units, made from those of length and power; nothing is converted.
struct UnitLabels {
  explicit UnitLabels(const Units& units, AngularSpace space = AngularSpace::sphere);

  std::string length;
  std::string volume;
  std::string area;
  std::string power;
  std::string flux;         ///< of fluence, net flux, irradiance and exitance: power/length^2
  std::string radiance;     ///< power/(length^2 sr), in the plane per rad
  std::string intensity;    ///< power/sr
  std::string coefficient;  ///< 1/length
  std::string emission;     ///< power/(length^3 sr), in the plane per rad
};

}  // namespace etendue
