// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/diffusion/conjugate_gradients.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <vector>

namespace etendue {
namespace {

/// It decides the order of sums, so it must not depend on the number of threads.
constexpr std::size_t block_length = 4096;

/// to = a to + b from
void combine(double a, std::span<double> to, double b, std::span<const double> from, int threads) {
#pragma omp parallel for schedule(static) num_threads(threads)
  for (std::size_t i = 0; i < to.size(); ++i) to[i] = a * to[i] + b * from[i];
}

/// Eigenvalues of the tridiagonal matrix that step lengths a_k and growths b_k = (r,z)_k+1 / (r,z)_k stand
/// for: diagonal 1/a_k + b_k-1/a_k-1, beside it sqrt(b_k)/a_k (Saad 2003, equation 6.103).
std::vector<double> eigenvalues(const std::vector<double>& lengths, const std::vector<double>& growths) {
  const auto size = static_cast<Eigen::Index>(lengths.size());
  Eigen::VectorXd diagonal(size), beside(std::max<Eigen::Index>(size - 1, 0));
  for (std::size_t k = 0; k < lengths.size(); ++k) {
    const auto row = static_cast<Eigen::Index>(k);
    diagonal(row) = 1 / lengths[k] + (k > 0 ? growths[k - 1] / lengths[k - 1] : 0);
    if (row + 1 < size) beside(row) = std::sqrt(growths[k]) / lengths[k];
  }
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
  solver.computeFromTridiagonal(diagonal, beside, Eigen::EigenvaluesOnly);
  return {solver.eigenvalues().begin(), solver.eigenvalues().end()};
}

}  // namespace

double ordered_dot(std::span<const double> a, std::span<const double> b, int threads) {
  const std::size_t blocks = (a.size() + block_length - 1) / block_length;
  std::vector<double> partial(blocks, 0);
#pragma omp parallel for schedule(static) num_threads(threads)
  for (std::size_t block = 0; block < blocks; ++block) {
    const std::size_t end = std::min(a.size(), (block + 1) * block_length);
    double sum = 0;
    for (std::size_t i = block * block_length; i < end; ++i) sum += a[i] * b[i];
    partial[block] = sum;
  }
  double result = 0;
  for (const double sum : partial) result += sum;
  return result;
}

int conjugate_gradients(const LinearMap& matrix, const LinearMap& preconditioner,
                        std::span<const double> right, std::span<double> x,
                        const ConjugateGradientOptions& options) {
  std::fill(x.begin(), x.end(), 0.0);
  std::vector<double> residual(right.begin(), right.end()), smoothed(right.size()), image(right.size());
  preconditioner(residual, smoothed);
  std::vector<double> step = smoothed;
  double size = ordered_dot(residual, smoothed, options.threads);
  const double goal = options.tolerance * options.tolerance * size;
  int iterations = 0;
  std::vector<double> lengths, growths;
  // Written so that NaN ends it too.
  while (size > goal && iterations < options.max_iterations) {
    matrix(step, image);
    const double length = size / ordered_dot(step, image, options.threads);
    combine(1, x, length, step, options.threads);
    combine(1, residual, -length, image, options.threads);
    ++iterations;
    preconditioner(residual, smoothed);
    const double next = ordered_dot(residual, smoothed, options.threads);
    combine(next / size, step, 1, smoothed, options.threads);
    lengths.push_back(length);
    growths.push_back(next / size);
    size = next;
  }
  if (options.ritz_values != nullptr) *options.ritz_values = eigenvalues(lengths, growths);
  return iterations;
}

}  // namespace etendue
