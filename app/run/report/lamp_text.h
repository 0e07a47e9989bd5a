// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>

#include "app/case/case.h"
#include "solver/problem/problem.h"

namespace etendue {

/// A line for each point and spot: its power, lumens and luminous efficacy; of many lamps the first few. One
/// for each beam, with a warning where much of it misses its walls. And one for each beam of a wall, sun and
/// sky.
std::string lamp_text(const Problem& problem, const Case& input);

}  // namespace etendue
