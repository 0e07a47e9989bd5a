// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace etendue {

/// Eight numbers that are worked on side by side.
using Eight = Eigen::Array<double, 8, 1>;

/// E_1, E_2 and E_3 of eight numbers: E_n(x) is the integral of e^(-x t) / t^n from 1 to infinity.
struct ExponentialIntegrals {
  Eight first, second, third;
};

/// To 1e-11 of e^-x, for x >= 0; E_1 is finite at zero (Abramowitz and Stegun 1964, eqs. 5.1.11, 5.1.14
/// and 5.1.22).
ExponentialIntegrals exponential_integrals(const Eight& x);

}  // namespace etendue
