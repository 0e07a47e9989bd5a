// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/case/case.h"

namespace etendue {

/// [band] Relative power in the bands of a spectrum that is constant over the wavelengths, or of a black body
/// of this temperature [K]. Bands without edges have equal power.
std::vector<double> lamp_spectrum(const Bands& bands, std::optional<double> kelvin);

/// [band] Power [units.power] of a light of this spectrum and luminous flux [lm]: P_b = flux s_b/sum_c K_c
/// s_c with the luminous efficacies K_c of the bands that sensors use (Photometry), so that sensors find the
/// same lumens.
std::vector<double> power_of_flux(double lumens, const std::vector<double>& spectrum, const Bands& bands,
                                  const std::string& power_unit);

/// Why lumens cannot be converted to power in these bands and units, and what helps; empty where they can.
std::string no_lumens_reason(const Bands& bands, const std::string& power_unit);

}  // namespace etendue
