// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "solver/problem/bands.h"

namespace etendue {

/// Four gray gases and the clear one for water vapour and carbon dioxide at 1 atm, 330 to 2400 K, for a molar
/// ratio of the two from 0.01 to 4 (Bordbar, Wecel and Hyppanen, Combustion and Flame 161 (2014) 2435).
GrayGases bordbar_gases(double molar_ratio);

/// Temperatures for which they are known [K]: the fit begins at 300 K, where for some ratios it gives the
/// gray gases more than all power.
inline constexpr double bordbar_lowest = 330, bordbar_highest = 2400;

/// Temperature by which the polynomials of their weights are divided [K].
inline constexpr double bordbar_kelvin = 1200;

/// Three gray gases and the clear one, 600 to 2400 K, for a molar ratio of water vapour to carbon dioxide of
/// 1 or 2 (Smith, Shen and Friedman, Journal of Heat Transfer 104 (1982) 602).
GrayGases smith_gases(int molar_ratio);

}  // namespace etendue
