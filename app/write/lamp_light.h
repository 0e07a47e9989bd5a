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
};

/// Points and spots; none where the bands or the unit of power have no photometry.
std::vector<LampLight> lamp_lights(const Problem& problem, const Units& units);

}  // namespace etendue
