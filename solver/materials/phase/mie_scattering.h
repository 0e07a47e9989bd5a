// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <complex>
#include <string>
#include <variant>

#include "solver/materials/phase/phase_series.h"

namespace etendue {

/// Spheres of one size.
struct OneSize {
  double radius = 0;
};

/// n(r) = exp(-ln^2(r/median) / (2 ln^2 deviation)) / (sqrt(2 pi) r ln deviation).
struct LogNormalSizes {
  double median = 0;
  double deviation = 1;  ///< geometric standard deviation, above 1
};

/// n(r) proportional to r^((1 - 3v)/v) exp(-r/(effective v)) (Hansen 1971).
struct GammaSizes {
  double effective = 0;  ///< mean radius weighted with the cross section pi r^2
  double variance = 0;   ///< v, relative variance weighted alike, 0 … 0.5
};

using Sizes = std::variant<OneSize, LogNormalSizes, GammaSizes>;

/// What a cloud of spheres does to light of one wavelength. Lengths in one unit of any kind.
struct MieScattering {
  double extinction_cross_section = 0;  ///< mean of pi r^2 Q_ext [length^2]
  double scattering_cross_section = 0;  ///< mean of pi r^2 Q_sca [length^2]
  double area = 0;                      ///< mean of pi r^2 [length^2]
  PhaseLegendre phase;                  ///< the whole series, to rounding
};

/// Why these spheres cannot be computed, and what is accepted; empty where they can. The wavelength is that
/// in the surrounding medium, the index n + i k relative to it.
std::string mie_problem(const Sizes& sizes, std::complex<double> index, double wavelength);

/// The mean over the sizes, by the trapezoid rule over ln r. Arguments for which mie_problem is empty.
MieScattering mie_scattering(const Sizes& sizes, std::complex<double> index, double wavelength);

}  // namespace etendue
