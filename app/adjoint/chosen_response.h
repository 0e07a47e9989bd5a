// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/case/case.h"
#include "mesh/tetrahedra/search/cell_locator.h"
#include "solver/adjoint/response.h"
#include "solver/problem/problem.h"

namespace etendue {

/// A quantity whose importance is asked for by the name that the case gives it.
struct ChosenResponse {
  std::string name;      ///< "probe:desk"
  std::string quantity;  ///< "irradiance"
  std::string unit;
  std::string unit_by_power;  ///< of the response over power; empty where it is a number
  std::string unit_by_area;   ///< of the response over area
  Response response;
};

/// The responses of "probe:NAME" (its irradiance where it has a normal, else its fluence; one of a line is
/// "probe:NAME:INDEX"), "sensor:NAME" (irradiance, fluence or the mean irradiance of a grid), "wall:NAME"
/// (the power that arrives) and "region:NAME" (the power that is absorbed). Throws InputError with all that
/// are not known.
std::vector<ChosenResponse> choose_responses(const std::vector<std::string>& names, const Case& input,
                                             const Problem& problem, const CellLocator& locator);

}  // namespace etendue
