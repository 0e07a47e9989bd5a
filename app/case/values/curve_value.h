// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>

#include "app/case/case.h"
#include "solver/problem/temperature_curve.h"

namespace etendue {

/// A property by the temperature as a formula of a temperature [K] that is given as a text.
std::string curve_text(const TemperatureCurve& curve, const std::string& kelvin);

/// The property at a temperature [K]: a formula where the temperature is one.
Value curve_value(const TemperatureCurve& curve, const Value& kelvin);

}  // namespace etendue
