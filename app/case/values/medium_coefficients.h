// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>

#include "app/case/case.h"

namespace etendue {

/// Values that a person wrote with a few digits, and their sums, agree to this.
inline constexpr double written_agreement = 1e-9;

/// Absorption and scattering of one band, whichever two of the coefficients the case gives [1/length]:
///   extinction and albedo:      scattering = albedo extinction, absorption = (1 - albedo) extinction
///   extinction and one of them: the other is the difference
///   extinction alone:           it absorbs
///   else what is given, and 0.
struct MatterValues {
  Value absorption = 0.0;
  Value scattering = 0.0;
};
MatterValues matter_values(const MediumCase& medium, int band);

/// Emission of one band, from `power_density` where that is given [power/(length^3 sr)].
Value emission_value(const MediumCase& medium, int band);

/// Why the coefficients of a band contradict each other or do not suffice; empty where they are consistent.
std::string matter_problem(const MediumCase& medium, int band);
std::string emission_problem(const MediumCase& medium, int band);

}  // namespace etendue
