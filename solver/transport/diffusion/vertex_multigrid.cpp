// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/diffusion/vertex_multigrid.h"

#include <stdexcept>

#include "solver/transport/diffusion/aggregation.h"

namespace etendue {
namespace {

/// Cycles of one approximation, as a polynomial of Chebyshev.
constexpr int cycles = 2;

/// Coarsening that leaves more than this part of the unknowns is not worth another level.
constexpr double slowest_coarsening = 0.8;

using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// matrix x on this thread alone: Eigen would take as many as it finds.
Eigen::VectorXd product(const Matrix& matrix, const Eigen::VectorXd& x) {
  Eigen::VectorXd result(matrix.rows());
  for (Eigen::Index row = 0; row < matrix.rows(); ++row) {
    double sum = 0;
    for (Matrix::InnerIterator entry(matrix, row); entry; ++entry) sum += entry.value() * x(entry.col());
    result(row) = sum;
  }
  return result;
}

/// Gauss and Seidel's iteration through the unknowns in their order, or backwards, which is the transpose.
void relax(const Matrix& matrix, const Eigen::VectorXd& right, Eigen::VectorXd& x, bool backwards) {
  const Eigen::Index count = matrix.rows();
  for (Eigen::Index k = 0; k < count; ++k) {
    const Eigen::Index row = backwards ? count - 1 - k : k;
    double rest = right(row), diagonal = 0;
    for (Matrix::InnerIterator entry(matrix, row); entry; ++entry)
      if (entry.col() == row)
        diagonal = entry.value();
      else
        rest -= entry.value() * x(entry.col());
    x(row) = rest / diagonal;
  }
}

}  // namespace

VertexMultigrid::VertexMultigrid(const Eigen::SparseMatrix<double>& lower, int direct) {
  Matrix matrix = lower.selfadjointView<Eigen::Lower>();
  const auto entries = static_cast<double>(matrix.nonZeros());
  while (matrix.rows() > direct) {
    Matrix prolongation = smoothed_prolongation(matrix, static_cast<int>(levels_.size()));
    if (static_cast<double>(prolongation.cols()) > slowest_coarsening * static_cast<double>(matrix.rows()))
      break;
    Matrix restriction = prolongation.transpose();
    Matrix coarse = restriction * Matrix(matrix * prolongation);
    levels_.push_back({std::move(matrix), std::move(prolongation), std::move(restriction)});
    matrix = std::move(coarse);
    complexity_ += static_cast<double>(matrix.nonZeros()) / entries;
  }
  // Where unknowns are coupled weakly alone there is nothing to coarsen to.
  if (matrix.rows() > 0) coarsest_.compute(matrix);
  if (matrix.rows() > 0 && coarsest_.info() != Eigen::Success)
    throw std::domain_error("the matrix of diffusion is not positive definite");
  if (!levels_.empty()) measure_cycle();
}

Eigen::VectorXd VertexMultigrid::cycle(std::size_t level, const Eigen::VectorXd& right) const {
  if (level == levels_.size()) return right.size() > 0 ? coarsest_.solve(right).eval() : right;
  const Level& here = levels_[level];
  Eigen::VectorXd x = Eigen::VectorXd::Zero(right.size());
  relax(here.matrix, right, x, false);
  const Eigen::VectorXd residual = right - product(here.matrix, x);
  x += product(here.prolongation, cycle(level + 1, product(here.restriction, residual)));
  relax(here.matrix, right, x, true);
  return x;
}

void VertexMultigrid::measure_cycle() {
  using Vector = Eigen::Map<Eigen::VectorXd>;
  using ConstVector = Eigen::Map<const Eigen::VectorXd>;
  const Eigen::Index size = levels_[0].matrix.rows();
  spectrum_ = measure_spectrum(
      [&](auto from, auto to) {
        Vector(to.data(), size) = product(levels_[0].matrix, ConstVector(from.data(), size));
      },
      [&](auto from, auto to) { Vector(to.data(), size) = cycle(0, ConstVector(from.data(), size)); },
      static_cast<std::size_t>(size), 1);
}

Eigen::VectorXd VertexMultigrid::approximate(const Eigen::VectorXd& right) const {
  if (levels_.empty()) return coarsest_.solve(right);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(right.size()), step = x, residual = right;
  ChebyshevSteps factors(spectrum_);
  for (int k = 0; k < cycles; ++k) {
    if (k > 0) residual = right - product(levels_[0].matrix, x);
    const auto factor = factors.next();
    step = factor.keep * step + factor.add * cycle(0, residual);
    x += step;
  }
  return x;
}

}  // namespace etendue
