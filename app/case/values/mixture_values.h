// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "app/case/case.h"

namespace etendue {

inline constexpr double lowest_molar_ratio = 0.01, highest_molar_ratio = 4;

/// Absorption of a gas of bordbar_gases() by the partial pressure [1/(m atm)], where the molar ratio is one
/// of the place: a formula where it is one. Beyond 0.01 to 4 it is that of the nearest.
Value bordbar_absorption(int gas, const Value& molar_ratio);

/// The fraction of a blackbody's power that such a gas has, by the temperature [K].
Value bordbar_weight(int gas, const Value& molar_ratio, const Value& kelvin);

}  // namespace etendue
