// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "solver/transport/diffusion/block_matrix.h"
#include "solver/transport/diffusion/chebyshev.h"
#include "solver/transport/diffusion/conjugate_gradients.h"
#include "solver/transport/diffusion/diffusion_matrix.h"
#include "solver/transport/diffusion/vertex_multigrid.h"
#include "solver/transport/diffusion/vertex_space.h"

namespace etendue {

/// Most cycles of one approximation.
inline constexpr int longest_polynomial = 8;

/// Solves the interior penalty form of diffusion again and again for one set of coefficients: conjugate
/// gradients with two levels, Chebyshev iteration on cell blocks for what jumps, and continuous functions for
/// what does not. Iterations do not grow with the mesh.
class DiffusionSolver {
 public:
  /// `vertices` must outlive it. `accuracy` is that of approximate(), as far as `longest_polynomial` goes.
  /// Throws std::domain_error where the matrix is singular to rounding, all but nothing being absorbed or
  /// leaving, or is not positive definite.
  DiffusionSolver(const TetrahedralMesh& mesh, const VertexSpace& vertices,
                  const DiffusionCoefficients& coefficients, double accuracy, int threads);

  const BlockMatrix& matrix() const { return matrix_; }
  /// matrix x = right to a relative tolerance; returns the iterations.
  int solve(std::span<const double> right, std::span<double> x, double tolerance, int max_iterations) const;
  /// x = a fixed polynomial of cycles on `right`: linear in it, so that it can precondition any Krylov
  /// method, and within about `accuracy` of the solution in the norm of the energy.
  void approximate(std::span<const double> right, std::span<double> x) const;
  int steps() const { return steps_; }  ///< cycles that approximate() does
  /// x = one cycle of both levels on `right`, symmetric and positive definite.
  void precondition(std::span<const double> right, std::span<double> x) const;

 private:
  DiffusionSolver(const TetrahedralMesh& mesh, const VertexSpace& vertices,
                  const DiffusionCoefficients& coefficients, const CellMatrices& matrices, double accuracy,
                  int threads);
  void invert_diagonal();
  double largest_eigenvalue() const;
  void measure_cycle(double accuracy);
  void smooth(std::span<const double> right, std::span<double> x, std::span<double> residual,
              std::span<double> step) const;
  void correct_coarse(std::span<const double> right, std::span<double> x) const;

  const VertexSpace& vertices_;
  int threads_;
  BlockMatrix matrix_;
  std::vector<Eigen::Matrix4d, Eigen::aligned_allocator<Eigen::Matrix4d>> inverse_;  ///< [cell]
  SpectrumBounds spectrum_;  ///< of a cycle times matrix_
  int steps_ = 1;
  double largest_ = 1;  ///< eigenvalue of inverse_ matrix_, bounded from above
  std::optional<VertexMultigrid> coarse_;
};

}  // namespace etendue
