// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "solver/problem/bands.h"

namespace etendue {

/// Luminous efficacy of radiation at 555 nm [lm/W]; 683.002 by the SI of 2019 for the wavelength of 540 THz.
inline constexpr double greatest_efficacy = 683;
inline constexpr double planck = 6.62607015e-34;      ///< [J s], exact (SI 2019)
inline constexpr double speed_of_light = 299792458.;  ///< [m/s], exact

/// Energy of a photon [J] of a wavelength [nm].
double photon_energy(double wavelength);

/// What units of a case mean in the SI; the measures of photometry need them.
struct SiScale {
  double power;   ///< [W] that one unit is
  double length;  ///< [m]
};

/// What a unit of power is [W]: of the labels W and mW; of others it is not known.
std::optional<double> watts_of_unit(const std::string& power_label);

/// The labels m, cm, mm, km and W, mW are known; of others there is no scale.
std::optional<SiScale> si_scale(const std::string& length_label, const std::string& power_label);

/// How bands are seen and counted.
class Photometry {
 public:
  explicit Photometry(const Bands& bands);

  /// Returns whether there is something to see by.
  bool known() const { return !efficacy_.empty(); }
  /// "V(lambda), 683 lm/W" or the rule for bands called red, green and blue without edges: linear sRGB whose
  /// luminance is weighted by V.
  const std::string& rule() const { return rule_; }
  /// [band] lumens of a watt, the spectrum being constant in each band [lm/W]; empty where nothing is known.
  std::span<const double> efficacy() const { return efficacy_; }
  /// Sum over the bands: power in, lumens out, and so for all that is per area and solid angle.
  double luminous(std::span<const double> radiant) const;

  /// [band] photons of a joule, the power being constant over the wavelengths of a band [1/J]; empty without
  /// edges.
  std::span<const double> photons_per_joule() const { return photons_; }

 private:
  std::vector<double> efficacy_;
  std::vector<double> photons_;
  std::string rule_;
};

}  // namespace etendue
