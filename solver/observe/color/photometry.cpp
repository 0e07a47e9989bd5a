// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/observe/color/photometry.h"

#include <map>
#include <numeric>

#include "solver/observe/color/band_color.h"
#include "solver/observe/color/color_matching.h"

namespace etendue {
namespace {

const std::vector<std::string> primaries = {"red", "green", "blue"};

}  // namespace

double photon_energy(double wavelength) { return planck * speed_of_light / (wavelength * 1e-9); }

std::optional<double> watts_of_unit(const std::string& power_label) {
  if (power_label == "W") return 1;
  if (power_label == "mW") return 1e-3;
  return std::nullopt;
}

std::optional<SiScale> si_scale(const std::string& length_label, const std::string& power_label) {
  static const std::map<std::string, double> lengths = {{"m", 1}, {"cm", 1e-2}, {"mm", 1e-3}, {"km", 1e3}};
  const auto length = lengths.find(length_label);
  const std::optional<double> power = watts_of_unit(power_label);
  if (length == lengths.end() || !power) return std::nullopt;
  return SiScale{*power, length->second};
}

Photometry::Photometry(const Bands& bands) {
  for (std::size_t b = 0; b + 1 < bands.edges.size(); ++b) {
    efficacy_.push_back(greatest_efficacy * mean_color_matching(bands.edges[b], bands.edges[b + 1])[1]);
    // The mean of lambda/(h c) over the band.
    photons_.push_back(1 / photon_energy((bands.edges[b] + bands.edges[b + 1]) / 2));
  }
  if (!bands.edges.empty()) {
    rule_ = "V(lambda), 683 lm/W";
  } else if (bands.names == primaries) {
    for (const LinearColor& primary : {LinearColor{1, 0, 0}, {0, 1, 0}, {0, 0, 1}})
      efficacy_.push_back(greatest_efficacy * luminance(primary));
    rule_ = "red, green and blue as linear sRGB, luminance weighted by V, 683 lm/W";
  }
}

double Photometry::luminous(std::span<const double> radiant) const {
  return std::inner_product(efficacy_.begin(), efficacy_.end(), radiant.begin(), 0.0);
}

}  // namespace etendue
