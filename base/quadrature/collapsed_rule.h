// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <bitset>
#include <span>

#include "base/quadrature/simplex_rules.h"

namespace etendue {

/// Corners of a cell or a face beside which light varies steeply.
template <std::size_t corners>
struct SteepCorners {
  std::bitset<corners> surface;  ///< on what shines: with the distance from it
  std::bitset<corners> rim;      ///< on its rim: with the angle about it
};

/// Points of a simplex, collapsed towards its steep corners (Duffy 1982): with T the simplex of some of them,
/// O that of all other corners, and x = (1 - s) y + s z for y in T and z in O, a product of rules for y, for
/// z and for t = sqrt(s), which lie closer near T. It is made for functions that are smooth in y and z but
/// not in s. Beside a surface that shines fluence goes like h log h: T are the corners on it. Beside its rim
/// fluence depends on the direction from there: T are the corners on the rim, and the points of O are
/// collapsed in turn towards the surface. Exact to degree 2 at least. Empty where no corner is steep, or all
/// are.
template <std::size_t corners>
std::span<const SimplexPoint<corners>> collapsed_rule(const SteepCorners<corners>& steep);

}  // namespace etendue
