// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/case/case.h"
#include "solver/problem/problem.h"

namespace etendue {

/// Light that a lamp sends into the domain, as the eye sees it.
struct LampLight {
  std::string name;
  double power = 0;          ///< of all bands [units.power]
  double luminous_flux = 0;  ///< [lm]
  double efficacy = 0;       ///< luminous efficacy of its radiation in the bands [lm/W]
  std::string note;          ///< how it is tilted, where that counts; may be empty
};

/// Points and spots; none where the bands or the unit of power have no photometry.
std::vector<LampLight> lamp_lights(const Problem& problem, const Case& input);

/// Light of a sun or a sky on a level plane under all of it, before any glazing.
struct Daylight {
  std::string name;
  std::string note;         ///< how the sun stands; may be empty
  double irradiance = 0;    ///< of all bands [units.power/units.length^2]
  double illuminance = -1;  ///< [lx]; -1 where the bands or units have no photometry
};

/// Of the suns and skies of a case; walls.NAME.beam are none.
std::vector<Daylight> daylight(const Case& input);

/// A collimated beam as wide as its wall, walls.NAME.beam, of all bands.
struct WallBeam {
  std::string name;
  double irradiance = 0;  ///< across the beam [units.power/units.length^2]
  double power = 0;       ///< that arrives at the wall from outside [units.power]
};

std::vector<WallBeam> wall_beams(const Problem& problem, const Case& input);

}  // namespace etendue
