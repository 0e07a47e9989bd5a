// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>
#include <span>
#include <vector>

namespace etendue {

/// a.b, in blocks of fixed size that are added in their order: the same bits for any number of threads.
double ordered_dot(std::span<const double> a, std::span<const double> b, int threads);

/// y = M x for some symmetric positive definite M.
using LinearMap = std::function<void(std::span<const double> x, std::span<double> y)>;

struct ConjugateGradientOptions {
  double tolerance = 1e-2;  ///< of the residual in the norm of the preconditioner, relative to the first
  int max_iterations = 100;
  int threads = 1;
  /// Where it is not null: filled with rising approximations to eigenvalues of preconditioner times matrix.
  std::vector<double>* ritz_values = nullptr;
};

/// Preconditioned conjugate gradients (Hestenes and Stiefel 1952; Saad 2003, algorithm 9.1) from x = 0 for
/// matrix x = right. Returns the iterations that were done.
int conjugate_gradients(const LinearMap& matrix, const LinearMap& preconditioner,
                        std::span<const double> right, std::span<double> x,
                        const ConjugateGradientOptions& options);

}  // namespace etendue
