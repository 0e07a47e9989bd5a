// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "base/angular_space.h"

namespace etendue {

/// A Legendre series: p(mu) = sum over l of (2l + 1)/(4 pi) chi_l P_l(mu).
struct PhaseLegendre {
  std::vector<double> moments = {1};  ///< chi_l from l = 0; those beyond are 0
  bool operator==(const PhaseLegendre&) const = default;
};
double value_of(const PhaseLegendre& phase, double mu);
double moment_of(const PhaseLegendre& phase, int degree);
std::string name_of(const PhaseLegendre& phase);
/// The same moments in the plane: p = 1/(2 pi) (1 + 2 sum of chi_k cos(k t)) where mu = cos t [1/rad].
double value_in_plane(const PhaseLegendre& phase, double mu);

/// Why these moments are those of no phase function, and what is accepted; empty where they are. Series may
/// dip below zero by a thousandth of their mean, as cut series do.
std::string series_problem(const std::vector<double>& moments, AngularSpace space = AngularSpace::sphere);

}  // namespace etendue
