// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <variant>

namespace etendue {

/// p = 1/(4 pi).
struct PhaseIsotropic {
  bool operator==(const PhaseIsotropic&) const = default;
};

/// Henyey and Greenstein (1941): p(mu) = (1 - g^2) / (4 pi (1 + g^2 - 2 g mu)^(3/2)), -1 < g < 1.
struct PhaseHenyeyGreenstein {
  double asymmetry = 0;  ///< g = mean cosine
  bool operator==(const PhaseHenyeyGreenstein&) const = default;
};

/// How light turns when it scatters; the integral over the sphere is 1.
using PhaseFunction = std::variant<PhaseIsotropic, PhaseHenyeyGreenstein>;

/// Value at the cosine `mu` of the angle of deflection [1/sr].
double phase_value(const PhaseFunction& phase, double mu);

/// Legendre moment of degree l: the integral of p(mu) P_l(mu) over the sphere; 1 for l = 0, g for l = 1.
double phase_moment(const PhaseFunction& phase, int degree);

/// The mean cosine g.
double phase_asymmetry(const PhaseFunction& phase);

std::string phase_name(const PhaseFunction& phase);

}  // namespace etendue
