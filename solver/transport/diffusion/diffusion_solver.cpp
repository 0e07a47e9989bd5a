// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/diffusion/diffusion_solver.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace etendue {
namespace {

/// Steps of the smoother before and after the coarse level.
constexpr int smoothing_steps = 3;
/// The smoother works on eigenvalues from the largest down to this part of it.
constexpr double smoothed_part = 0.06;
/// The power iteration approaches the largest eigenvalue from below.
constexpr double eigenvalue_margin = 1.1;
constexpr int power_iterations = 8;

/// The energy of constants, what is lost, relative to the trace. Below this rounding decides it.
constexpr double smallest_loss = 100 * std::numeric_limits<double>::epsilon();

/// Whether constants lose so much that rounding leaves it there. Written so that NaN does not.
bool loses(const CellMatrices& matrices) {
  double loss = 0, trace = 0;
  for (const Eigen::Matrix4d& matrix : matrices) {
    loss += matrix.sum();
    trace += matrix.trace();
  }
  return loss > smallest_loss * trace;
}

}  // namespace

DiffusionSolver::DiffusionSolver(const TetrahedralMesh& mesh, const VertexSpace& vertices,
                                 const DiffusionCoefficients& coefficients, double accuracy, int threads)
    : DiffusionSolver(mesh, vertices, coefficients, cell_matrices(mesh, coefficients), accuracy, threads) {}

DiffusionSolver::DiffusionSolver(const TetrahedralMesh& mesh, const VertexSpace& vertices,
                                 const DiffusionCoefficients& coefficients, const CellMatrices& matrices,
                                 double accuracy, int threads)
    : vertices_(vertices), threads_(threads), matrix_(diffusion_matrix(mesh, coefficients, matrices)) {
  if (!loses(matrices)) throw std::domain_error("hardly anything is absorbed or leaves");
  coarse_.emplace(vertices.assemble([&](CellIndex cell) { return matrices[cell.at()]; }));
  invert_diagonal();
  largest_ = eigenvalue_margin * largest_eigenvalue();
  measure_cycle(accuracy);
}

void DiffusionSolver::invert_diagonal() {
  inverse_.reserve(static_cast<std::size_t>(matrix_.cell_count()));
  for (std::int32_t c = 0; c < matrix_.cell_count(); ++c)
    inverse_.push_back(matrix_.diagonal(CellIndex(c)).inverse());
}

double DiffusionSolver::largest_eigenvalue() const {
  NodalVector x = rough_vector(4 * inverse_.size()), y(x.size());
  double value = 1;
  for (int k = 0; k < power_iterations; ++k) {
    matrix_.multiply(x, y, threads_);
    for (std::size_t c = 0; c < inverse_.size(); ++c)
      nodes_of(std::span<double>(x), c) = inverse_[c] * nodes_of(std::span<const double>(y), c);
    value = std::sqrt(ordered_dot(x, x, threads_));
    for (double& entry : x) entry /= value;
  }
  return value;
}

// Block Jacobi, accelerated on the upper part of its eigenvalues; `residual` is that of x.
void DiffusionSolver::smooth(std::span<const double> right, std::span<double> x, std::span<double> residual,
                             std::span<double> step) const {
  ChebyshevSteps factors({smoothed_part * largest_, largest_});
  for (int k = 0; k < smoothing_steps; ++k) {
    if (k > 0) matrix_.residual(right, x, residual, threads_);
    const auto factor = factors.next();
#pragma omp parallel for schedule(static) num_threads(threads_)
    for (std::size_t c = 0; c < inverse_.size(); ++c) {
      nodes_of(step, c) =
          factor.keep * nodes_of(step, c) + factor.add * (inverse_[c] * nodes_of(residual, c));
      nodes_of(x, c) += nodes_of(step, c);
    }
  }
}

void DiffusionSolver::correct_coarse(std::span<const double> residual, std::span<double> x) const {
  Eigen::VectorXd right(vertices_.size());
  vertices_.gather(residual, {right.data(), static_cast<std::size_t>(right.size())});
  const Eigen::VectorXd solution = coarse_->approximate(right);
  vertices_.add_spread({solution.data(), static_cast<std::size_t>(solution.size())}, x, threads_);
}

void DiffusionSolver::precondition(std::span<const double> right, std::span<double> x) const {
  NodalVector residual(right.begin(), right.end()), step(right.size(), 0);
  std::fill(x.begin(), x.end(), 0.0);
  smooth(right, x, residual, step);
  matrix_.residual(right, x, residual, threads_);
  correct_coarse(residual, x);
  matrix_.residual(right, x, residual, threads_);
  std::fill(step.begin(), step.end(), 0.0);
  smooth(right, x, residual, step);
}

void DiffusionSolver::measure_cycle(double accuracy) {
  spectrum_ =
      measure_spectrum([this](auto from, auto to) { matrix_.multiply(from, to, threads_); },
                       [this](auto from, auto to) { precondition(from, to); }, 4 * inverse_.size(), threads_);
  steps_ =
      static_cast<int>(std::clamp(chebyshev_steps_for(accuracy, spectrum_), 1.0, double{longest_polynomial}));
}

void DiffusionSolver::approximate(std::span<const double> right, std::span<double> x) const {
  NodalVector residual(right.begin(), right.end()), cycle(right.size()), step(right.size(), 0);
  std::fill(x.begin(), x.end(), 0.0);
  ChebyshevSteps factors(spectrum_);
  for (int k = 0; k < steps_; ++k) {
    if (k > 0) matrix_.residual(right, x, residual, threads_);
    precondition(residual, cycle);
    const auto factor = factors.next();
    for (std::size_t i = 0; i < step.size(); ++i) {
      step[i] = factor.keep * step[i] + factor.add * cycle[i];
      x[i] += step[i];
    }
  }
}

int DiffusionSolver::solve(std::span<const double> right, std::span<double> x, double tolerance,
                           int max_iterations) const {
  const LinearMap matrix = [this](std::span<const double> from, std::span<double> to) {
    matrix_.multiply(from, to, threads_);
  };
  const LinearMap cycle = [this](std::span<const double> from, std::span<double> to) {
    precondition(from, to);
  };
  return conjugate_gradients(matrix, cycle, right, x, {tolerance, max_iterations, threads_});
}

}  // namespace etendue
