// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/diffusion/aggregation.h"

#include <algorithm>
#include <cmath>

namespace etendue {
namespace {

using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// Couplings below this part of the mean of both diagonals are weak on the finest level; half as much on each
/// that follows.
constexpr double weak_part = 0.08;

/// A row that keeps less than this part of its diagonal, its weak couplings added to it, is not smoothed.
constexpr double smallest_diagonal = 0.1;

class Couplings {
 public:
  Couplings(const Matrix& matrix, double threshold)
      : matrix_(matrix), threshold_(threshold), diagonal_(matrix.diagonal()) {}

  bool is_strong(Eigen::Index row, const Matrix::InnerIterator& entry) const {
    const double value = entry.value();
    return entry.col() != row &&
           value * value > threshold_ * threshold_ * diagonal_(row) * diagonal_(entry.col());
  }
  template <class Action>
  void for_each_strong(Eigen::Index row, const Action& action) const {
    for (Matrix::InnerIterator entry(matrix_, row); entry; ++entry)
      if (is_strong(row, entry)) action(static_cast<std::size_t>(entry.col()), std::abs(entry.value()));
  }
  double diagonal(Eigen::Index row) const { return diagonal_(row); }
  const Matrix& matrix() const { return matrix_; }

 private:
  const Matrix& matrix_;
  double threshold_;
  Eigen::VectorXd diagonal_;
};

constexpr int nothing = -1;  ///< not in an aggregate

/// Whole neighbourhoods that touch no aggregate yet become one.
void seed(const Couplings& couplings, Aggregates& aggregates) {
  for (std::size_t i = 0; i < aggregates.of.size(); ++i) {
    if (aggregates.of[i] != nothing) continue;
    bool free = true, alone = true;
    couplings.for_each_strong(static_cast<Eigen::Index>(i), [&](std::size_t j, double) {
      alone = false;
      free = free && aggregates.of[j] == nothing;
    });
    if (alone || !free) continue;
    aggregates.of[i] = aggregates.count;
    couplings.for_each_strong(static_cast<Eigen::Index>(i),
                              [&](std::size_t j, double) { aggregates.of[j] = aggregates.count; });
    ++aggregates.count;
  }
}

/// Those left over join the aggregate that they are coupled to most.
void join(const Couplings& couplings, Aggregates& aggregates) {
  const std::vector<int> before = aggregates.of;
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (before[i] != nothing) continue;
    double strongest = 0;
    couplings.for_each_strong(static_cast<Eigen::Index>(i), [&](std::size_t j, double value) {
      if (before[j] == nothing || value <= strongest) return;
      strongest = value;
      aggregates.of[i] = before[j];
    });
  }
}

/// What is still left becomes aggregates of its own.
void gather_rest(const Couplings& couplings, Aggregates& aggregates) {
  for (std::size_t i = 0; i < aggregates.of.size(); ++i) {
    if (aggregates.of[i] != nothing) continue;
    bool found = false;
    couplings.for_each_strong(static_cast<Eigen::Index>(i), [&](std::size_t j, double) {
      if (aggregates.of[j] != nothing) return;
      aggregates.of[j] = aggregates.count;
      found = true;
    });
    if (!found) continue;
    aggregates.of[i] = aggregates.count++;
  }
}

/// The diagonal with the weak couplings of its row added, so that constants are treated alike.
double filtered_diagonal(const Couplings& couplings, Eigen::Index row) {
  double diagonal = couplings.diagonal(row);
  for (Matrix::InnerIterator entry(couplings.matrix(), row); entry; ++entry)
    if (entry.col() != row && !couplings.is_strong(row, entry)) diagonal += entry.value();
  return diagonal;
}

/// Gershgorin's bound on the eigenvalues of the strong couplings over their diagonal.
double largest_eigenvalue(const Couplings& couplings, const Eigen::VectorXd& diagonal) {
  double largest = 1;
  for (Eigen::Index row = 0; row < diagonal.size(); ++row) {
    if (diagonal(row) <= 0) continue;
    double sum = diagonal(row);
    couplings.for_each_strong(row, [&](std::size_t, double value) { sum += value; });
    largest = std::max(largest, sum / diagonal(row));
  }
  return largest;
}

}  // namespace

Aggregates aggregate(const Matrix& matrix, double threshold) {
  const Couplings couplings(matrix, threshold);
  Aggregates result;
  result.of.assign(static_cast<std::size_t>(matrix.rows()), nothing);
  seed(couplings, result);
  join(couplings, result);
  gather_rest(couplings, result);
  return result;
}

Matrix smoothed_prolongation(const Matrix& matrix, int level) {
  const double threshold = weak_part * std::pow(0.5, level);
  const Couplings couplings(matrix, threshold);
  const Aggregates aggregates = aggregate(matrix, threshold);
  Eigen::VectorXd diagonal(matrix.rows());
  for (Eigen::Index row = 0; row < matrix.rows(); ++row) {
    diagonal(row) = filtered_diagonal(couplings, row);
    if (diagonal(row) < smallest_diagonal * couplings.diagonal(row)) diagonal(row) = 0;
  }
  const double step = 4.0 / (3 * largest_eigenvalue(couplings, diagonal));
  std::vector<Eigen::Triplet<double>> entries;
  for (Eigen::Index row = 0; row < matrix.rows(); ++row) {
    const int own = aggregates.of[static_cast<std::size_t>(row)];
    if (own == nothing) continue;
    const double factor = diagonal(row) > 0 ? step / diagonal(row) : 0;
    entries.emplace_back(row, own, diagonal(row) > 0 ? 1 - step : 1);
    if (factor == 0) continue;
    for (Matrix::InnerIterator entry(matrix, row); entry; ++entry) {
      const int other = aggregates.of[static_cast<std::size_t>(entry.col())];
      if (couplings.is_strong(row, entry) && other != nothing)
        entries.emplace_back(row, other, -factor * entry.value());
    }
  }
  Matrix result(matrix.rows(), aggregates.count);
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

}  // namespace etendue
