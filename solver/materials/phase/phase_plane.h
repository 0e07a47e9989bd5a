// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "solver/materials/phase/phase_part.h"

namespace etendue {

/// A phase function of the plane (flatland): the integral over the circle is 1, and the moments are
///
///     chi_k = integral of p(cos t) cos(k t) dt over the circle,   p = 1/(2 pi) (1 + 2 sum of chi_k cos(k
///     t)).
///
/// It is a sum of parts. Henyey and Greenstein's has the moments g^k: (1 - g^2) / (2 pi (1 + g^2 - 2 g cos
/// t)); Cornette and Shanks's is that times (1 + cos^2 t), normalised; a Legendre series gives its moments to
/// the cosines; Rayleigh's function and tables keep their shape and are divided by their integral over the
/// circle.
class PhasePlane {
 public:
  /// Shares sum to 1.
  PhasePlane(std::vector<double> shares, std::vector<PhasePart> parts);

  bool operator==(const PhasePlane&) const = default;
  double value(double mu) const;  ///< [1/rad]
  double moment(int degree) const;
  std::string name() const;

 private:
  std::vector<double> shares_;
  std::vector<PhasePart> parts_;
  std::vector<double> integrals_;  ///< of tables over the circle, 1 for other parts
};
double value_of(const PhasePlane& phase, double mu);
double moment_of(const PhasePlane& phase, int degree);
std::string name_of(const PhasePlane& phase);

}  // namespace etendue
