// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

namespace etendue {

/// Refractive index of window glass (Duffie and Beckman, Solar Engineering of Thermal Processes, 2013,
/// table 5.1.1).
inline constexpr double glass_index = 1.526;

/// Parallel panes of absorbing glass, equal and without coatings, of which the transmittance at normal
/// incidence is known. Light is reflected at each surface by Fresnel's formulas, in two polarizations, and
/// absorbed along its refracted path; reflections between surfaces are added up without interference, within
/// a pane (Duffie and Beckman 2013, equations 5.3.1 to 5.3.3) and between panes, polarization by
/// polarization.
class Glazing {
 public:
  /// `normal_transmittance` must be positive and at most clear_transmittance().
  Glazing(double normal_transmittance, double refractive_index = glass_index, int panes = 1);

  /// The transmittance at normal incidence of panes that absorb nothing.
  static double clear_transmittance(double refractive_index, int panes);

  /// Part of unpolarized light that is let through, by the cosine of the angle of incidence.
  double transmittance(double cosine) const;
  double reflectance(double cosine) const;
  /// Of light that is the same from all directions: 2 times the integral of transmittance(mu) mu d mu.
  double diffuse_transmittance() const;

 private:
  double index_;
  int panes_;
  double depth_ = 0;  ///< optical thickness of a pane for absorption, at normal incidence
};

}  // namespace etendue
