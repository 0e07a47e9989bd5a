// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/case/case.h"
#include "solver/problem/problem.h"

namespace etendue {

/// Where the power of a light of kind "beam" goes at the walls, of all bands [units.power].
struct BeamPower {
  std::string name;
  double power = 0;            ///< of the whole beam
  double entering = 0;         ///< comes into the domain
  double turned_back = 0;      ///< is reflected by the walls from outside, or absorbed in their glazing
  double beside = 0;           ///< passes beside the walls; not the part behind symmetry planes
  double behind_symmetry = 0;  ///< behind mirrors in whose planes the axis lies
};

std::vector<BeamPower> beam_powers(const Problem& problem, const Case& input);

/// Part of the power beside the walls above which a run warns.
constexpr double much_beside = 1e-3;

}  // namespace etendue
