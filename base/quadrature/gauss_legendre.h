// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

namespace etendue {

/// Nodes in (-1, 1), rising, and weights that sum to 2.
struct GaussRule {
  std::vector<double> nodes;
  std::vector<double> weights;
};

/// Gauss-Legendre rule of `count` points: exact for polynomials up to degree 2 count - 1. Nodes are exactly
/// antisymmetric and weights exactly symmetric.
GaussRule gauss_legendre(int count);

}  // namespace etendue
