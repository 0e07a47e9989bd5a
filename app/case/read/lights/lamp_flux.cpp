// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/read/lights/lamp_flux.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/blackbody.h"
#include "solver/observe/color/photometry.h"

namespace etendue {

std::vector<double> lamp_spectrum(const Bands& bands, std::optional<double> kelvin) {
  std::vector<double> spectrum;
  for (std::size_t b = 0; b + 1 < bands.edges.size(); ++b) {
    const auto [low, high] = std::minmax(bands.edges[b], bands.edges[b + 1]);
    spectrum.push_back(kelvin ? planck_fraction(high, *kelvin) - planck_fraction(low, *kelvin) : high - low);
  }
  if (spectrum.empty()) spectrum.assign(bands.names.size(), 1);
  return spectrum;
}

std::vector<double> power_of_flux(double lumens, const std::vector<double>& spectrum, const Bands& bands,
                                  const std::string& power_unit) {
  const double watts = lumens / Photometry(bands).luminous(spectrum);
  std::vector<double> power = spectrum;
  for (double& value : power) value *= watts / *watts_of_unit(power_unit);
  return power;
}

std::string no_lumens_reason(const Bands& bands, const std::string& power_unit) {
  if (!watts_of_unit(power_unit))
    return fmt::format("lumens cannot be converted to units.power = \"{}\"; use W or mW, or give the power",
                       power_unit);
  const Photometry photometry(bands);
  if (!photometry.known())
    return "lumens need bands whose wavelengths are known; give bands.edges, e.g. [380, 780] for one band, "
           "or give "
           "the power";
  if (std::ranges::all_of(photometry.efficacy(), [](double efficacy) { return efficacy == 0; }))
    return "the eye sees none of the bands; use bands.edges between 360 and 830 nm, or give the power";
  return "";
}

}  // namespace etendue
