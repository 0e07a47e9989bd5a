// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

namespace etendue {

/// Part of a black body's power at wavelengths below this one [nm], of its temperature [K], in vacuum: the
/// fractional function F(0, lambda T) of Planck's law (Modest, Radiative Heat Transfer, eq. (1.24)).
double planck_fraction(double wavelength, double kelvin);

}  // namespace etendue
