// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>

namespace etendue {

// Each model has its value at the cosine mu of the angle of deflection [1/sr], its Legendre moments (the
// integrals of p(mu) P_l(mu) over the sphere; 1 for l = 0) and a name for people.

/// p = 1/(4 pi).
struct PhaseIsotropic {
  bool operator==(const PhaseIsotropic&) const = default;
};
double value_of(const PhaseIsotropic& phase, double mu);
double moment_of(const PhaseIsotropic& phase, int degree);
std::string name_of(const PhaseIsotropic& phase);

/// Molecules and small spheres: p = 3 (1 + mu^2) / (16 pi).
struct PhaseRayleigh {
  bool operator==(const PhaseRayleigh&) const = default;
};
double value_of(const PhaseRayleigh& phase, double mu);
double moment_of(const PhaseRayleigh& phase, int degree);
std::string name_of(const PhaseRayleigh& phase);

/// Henyey and Greenstein (1941): p(mu) = (1 - g^2) / (4 pi (1 + g^2 - 2 g mu)^(3/2)), -1 < g < 1.
struct PhaseHenyeyGreenstein {
  double asymmetry = 0;  ///< g = mean cosine
  bool operator==(const PhaseHenyeyGreenstein&) const = default;
};
double value_of(const PhaseHenyeyGreenstein& phase, double mu);
double moment_of(const PhaseHenyeyGreenstein& phase, int degree);
std::string name_of(const PhaseHenyeyGreenstein& phase);

/// Two of them: weight p(g1) + (1 - weight) p(g2), mostly with g1 > 0 > g2.
struct PhaseDoubleHenyeyGreenstein {
  double first = 0;   ///< g1
  double second = 0;  ///< g2
  double weight = 1;  ///< of g1, 0 … 1
  bool operator==(const PhaseDoubleHenyeyGreenstein&) const = default;
};
double value_of(const PhaseDoubleHenyeyGreenstein& phase, double mu);
double moment_of(const PhaseDoubleHenyeyGreenstein& phase, int degree);
std::string name_of(const PhaseDoubleHenyeyGreenstein& phase);

/// Cornette and Shanks (1992): p(mu) = 3 (1 - g^2) (1 + mu^2) / (8 pi (2 + g^2) (1 + g^2 - 2 g mu)^(3/2)),
/// which is Rayleigh's at g = 0. The mean cosine is 3 g (4 + g^2) / (5 (2 + g^2)).
struct PhaseCornetteShanks {
  double parameter = 0;  ///< g, -1 < g < 1
  bool operator==(const PhaseCornetteShanks&) const = default;
};
double value_of(const PhaseCornetteShanks& phase, double mu);
double moment_of(const PhaseCornetteShanks& phase, int degree);
std::string name_of(const PhaseCornetteShanks& phase);

}  // namespace etendue
