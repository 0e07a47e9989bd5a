// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "solver/transport/kernel/cell_balance.h"

namespace etendue {

// Non-negative nodal values in place of the four values u of a cell, without touching its balance
// (docs/theory/theory.md). As in cell_balance.h all is multiplied by 12. The balance is c . u = B with the
// column sums c of the matrix and B the sum of the right-hand side, equation (10): inflow and emission equal
// outflow and extinction. Where B >= 0 there are non-negative values that balance.

/// c_j = alpha_mass + 4 beta_mass + 4 (P - p_j) >= 0, the same sum for the consistent and the lumped mass.
template <class T>
ETENDUE_KERNEL_INLINE void balance_weights(const ProjectedAreas<T>& areas, const T& alpha_mass,
                                           const T& beta_mass, T (&c)[4]) {
  for (int j = 0; j < 4; ++j) c[j] = alpha_mass + 4.0 * beta_mass + 4.0 * (areas.total - areas.outgoing[j]);
}

/// Sets negative values to zero and scales the others back to the balance (zero and rescale).
ETENDUE_KERNEL_INLINE void rescale_to_balance(const double (&c)[4], double balance, double (&u)[4]) {
  double sum = 0;
  for (int i = 0; i < 4; ++i) {
    u[i] = u[i] > 0 ? u[i] : 0;
    sum += c[i] * u[i];
  }
  // Without weight at the positive vertices nothing leaves from there, and the balance is that of zeros.
  const double factor = sum > 0 ? balance / sum : 1;
  for (int i = 0; i < 4; ++i) u[i] *= factor;
}

/// The nearest non-negative values that balance: they minimise the sum of (x_i - u_i)^2 under c . x = B, x >=
/// 0. So x_i = max(0, u_i + lambda c_i). Those at zero are found one by one; since clipping adds to the
/// balance, lambda falls from pass to pass and none of them comes back (Yee et al. 2020, QPZ).
ETENDUE_KERNEL_INLINE void project_on_balance(const double (&c)[4], double balance, double (&u)[4]) {
  bool positive[4];
  for (int i = 0; i < 4; ++i) positive[i] = u[i] > 0;
  double lambda = 0;
  for (int pass = 0; pass < 4; ++pass) {
    double sum = 0, square = 0;
    for (int i = 0; i < 4; ++i)
      if (positive[i]) {
        sum += c[i] * u[i];
        square += c[i] * c[i];
      }
    lambda = square > 0 ? (balance - sum) / square : 0;
    bool done = true;
    for (int i = 0; i < 4; ++i)
      if (positive[i] && !(u[i] + lambda * c[i] >= 0)) {
        positive[i] = false;
        done = false;
      }
    if (done) break;
  }
  for (int i = 0; i < 4; ++i) {
    const double value = u[i] + lambda * c[i];
    u[i] = positive[i] && value > 0 ? value : 0;
  }
}

}  // namespace etendue
