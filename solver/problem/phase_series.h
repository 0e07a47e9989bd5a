// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace etendue {

/// A Legendre series: p(mu) = sum over l of (2l + 1)/(4 pi) chi_l P_l(mu).
struct PhaseLegendre {
  std::vector<double> moments = {1};  ///< chi_l from l = 0; those beyond are 0
  bool operator==(const PhaseLegendre&) const = default;
};
double value_of(const PhaseLegendre& phase, double mu);
double moment_of(const PhaseLegendre& phase, int degree);
std::string name_of(const PhaseLegendre& phase);

/// Why these moments are those of no phase function, and what is accepted; empty where they are. Series may
/// dip below zero by a thousandth of their mean, as cut series do.
std::string series_problem(const std::vector<double>& moments);

}  // namespace etendue
