// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/case/case.h"
#include "solver/angular/sets/direction_set.h"
#include "solver/problem/problem.h"

namespace etendue {

/// "smoke: henyey-greenstein, g = 0.6" for each medium that does not scatter isotropically, band by band
/// where they differ. A table's line tells what its values were divided by.
std::vector<std::string> phase_texts(const Case& input);

/// "smoke, band red: moments of degree 7 would leave 0.43 out; …" for each medium that scatters by more than
/// a mean: how scattering is discretised and why, bands that are treated alike together.
std::vector<std::string> plan_texts(const Problem& problem, const DirectionSet& directions);

/// The phase functions by the angle of deflection, closer near 0: lines of medium, band, degrees, p [1/sr]
/// (in the plane 1/rad), as CSV. Leaves, flakes and formulas of kernels follow by the direction that light
/// comes from, "NAME from (0 0 -1)" and two others, in the mean over azimuths.
std::string phase_values(const Case& input);

}  // namespace etendue
