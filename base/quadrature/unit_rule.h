// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/quadrature/gauss_legendre.h"

namespace etendue {

/// The Gauss-Legendre rule on [0, 1]: nodes, and weights that sum to 1.
inline GaussRule unit_rule(int count) {
  GaussRule rule = gauss_legendre(count);
  for (double& node : rule.nodes) node = 0.5 * (1 + node);
  for (double& weight : rule.weights) weight *= 0.5;
  return rule;
}

}  // namespace etendue
