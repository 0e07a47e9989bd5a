// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "solver/transport/diffusion/conjugate_gradients.h"

namespace etendue {

/// Bounds of a spectrum that is positive.
struct SpectrumBounds {
  double lowest = 1;
  double highest = 1;
};

/// Those of preconditioner times matrix, both symmetric and positive definite, from the tridiagonal matrix
/// that conjugate gradients build in a few steps (Saad 2003, section 6.7), with a margin. Throws
/// std::domain_error where they are not positive.
SpectrumBounds measure_spectrum(const LinearMap& matrix, const LinearMap& preconditioner, std::size_t size,
                                int threads);

/// Factors of Chebyshev's iteration for eigenvalues between two bounds (Saad 2003, algorithm 12.1): each step
/// is keep times the one before plus add times the preconditioned residual.
class ChebyshevSteps {
 public:
  struct Factors {
    double keep;
    double add;
  };
  explicit ChebyshevSteps(const SpectrumBounds& bounds);

  Factors next();

 private:
  double center_;
  double radius_;
  double previous_;
  bool first_ = true;
};

/// Steps after which at most `accuracy` of the error is left, in the norm of the energy.
double chebyshev_steps_for(double accuracy, const SpectrumBounds& bounds);

/// Holds something of everything, the same everywhere.
std::vector<double> rough_vector(std::size_t size);

}  // namespace etendue
