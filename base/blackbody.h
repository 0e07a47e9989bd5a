// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

namespace etendue {

/// The Stefan-Boltzmann constant [W/(m^2 K^4)] (CODATA 2018).
inline constexpr double stefan_boltzmann = 5.670374419e-8;

/// Fraction of the power of a blackbody at wavelengths below lambda, in vacuum, as a function of the product
/// lambda T [nm K]: the fractional function F(0, lambda T) of Planck's law (Modest, Radiative Heat Transfer,
/// eq. (1.24)), to 1e-14. 0 where the product is not positive.
double blackbody_fraction(double wavelength_temperature);

/// Derivative of blackbody_fraction [1/(nm K)].
double blackbody_fraction_slope(double wavelength_temperature);

/// Fraction of the power of a blackbody of temperature `kelvin` [K] at wavelengths below `wavelength` [nm].
inline double planck_fraction(double wavelength, double kelvin) {
  return blackbody_fraction(wavelength * kelvin);
}

}  // namespace etendue
