// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <complex>
#include <span>

#include "solver/problem/problem.h"
#include "solver/solution/added_extinction.h"
#include "solver/time/slowness.h"

namespace etendue {

/// The transport equation of light that changes as e^(s t), (L2) of docs/theory/time.md, for several rates s
/// side by side:
///
///     w.grad u + (sigma_t + s n / c) u = integral of sigma_s p(w.w') u(w') dw' + q
struct LaplaceProblem {
  /// Its bands are [rate][band of the problem][real, imaginary part of the radiance].
  Problem problem;
  AddedExtinction extinction;
};

/// Makes the problem for rates [1/time] with Re s >= 0 and Im s >= 0. All that emits is real and does so
/// alike for all rates; light is left to the directions. `slowness` is [region]; the mesh must outlive the
/// result. Throws std::invalid_argument where a rate is outside of that quadrant.
LaplaceProblem laplace_problem(const Problem& problem, std::span<const std::complex<double>> rates,
                               const Slowness& slowness);

}  // namespace etendue
