// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/angle/dense_kernel.h"

#include <algorithm>
#include <cmath>

#include "mesh/base/errors.h"
#include "solver/angle/harmonics.h"

namespace etendue {
namespace {

// The scaling is repeated until factors change by less than this: sums over hundreds of terms round to it.
constexpr double settled = 1e-14;
// Sums that are off by more than this after so many steps mean that there is no scaling.
constexpr double acceptable = 1e-11;
constexpr int most_steps = 5000;

Eigen::Map<const Eigen::VectorXd> weights_of(const DirectionSet& set) {
  return {set.weights().data(), set.count()};
}

/// [m][n] 1 - w_m.w_n = |w_m - w_n|^2/2: without cancellation between neighbours.
double one_minus_cosine(const DirectionSet& set, Eigen::Index m, Eigen::Index n) {
  return 0.5 * (set.directions()[static_cast<std::size_t>(m)] - set.directions()[static_cast<std::size_t>(n)])
                   .squaredNorm();
}

/// rate .* (1 - cosine)
Eigen::MatrixXd transfer_matrix(const Eigen::MatrixXd& rate, const DirectionSet& set) {
  Eigen::MatrixXd transfer(rate.rows(), rate.cols());
  for (Eigen::Index n = 0; n < rate.cols(); ++n)
    for (Eigen::Index m = 0; m < rate.rows(); ++m)
      transfer(m, n) = m == n ? 0 : rate(m, n) * one_minus_cosine(set, m, n);
  return transfer;
}

/// Factors b with b_m sum over n of A_mn w_n b_n = total_m (Sinkhorn and Knopp 1967, the symmetric form with
/// a geometric mean of steps). A is symmetric.
Eigen::VectorXd symmetric_factors(const Eigen::MatrixXd& a, const Eigen::VectorXd& weights,
                                  const Eigen::VectorXd& total) {
  Eigen::VectorXd b = Eigen::VectorXd::Ones(a.rows());
  double change = 1;
  for (int step = 0; step < most_steps && change > settled; ++step) {
    const Eigen::VectorXd sums = a * (weights.array() * b.array()).matrix();
    double largest = 0;
    for (Eigen::Index m = 0; m < b.size(); ++m) {
      // What scatters nowhere keeps its zeros, whatever its factor.
      if (sums(m) == 0 && total(m) == 0) continue;
      const double next = std::sqrt(b(m) * total(m) / sums(m));
      largest = std::max(largest, std::abs(next - b(m)) / next);
      b(m) = next;
    }
    change = largest;
    if (!std::isfinite(change)) break;
  }
  const Eigen::VectorXd sums = (b.array() * (a * (weights.array() * b.array()).matrix()).array()).matrix();
  const double scale = total.cwiseAbs().maxCoeff();
  if (!((sums - total).cwiseAbs().maxCoeff() <= acceptable * scale))
    throw InputError(
        "the scattering matrix cannot be scaled to its energy and mean cosine on this direction set (too few "
        "ordinates see each other through it); use more directions");
  return b;
}

bool is_symmetric(const Eigen::MatrixXd& rate) {
  return (rate - rate.transpose()).cwiseAbs().maxCoeff() <= 1e-13 * rate.cwiseAbs().maxCoeff();
}

}  // namespace

void scale_to_momentum_transfer(Eigen::MatrixXd& rate, const std::vector<double>& transfer,
                                const DirectionSet& set) {
  const Eigen::Map<const Eigen::VectorXd> weights = weights_of(set);
  const Eigen::Map<const Eigen::VectorXd> total(transfer.data(), rate.cols());
  const Eigen::MatrixXd matrix = transfer_matrix(rate, set);
  if (is_symmetric(rate)) {
    const Eigen::VectorXd b = symmetric_factors(matrix, weights, total);
    rate = b.asDiagonal() * rate * b.asDiagonal();
    return;
  }
  const Eigen::RowVectorXd sums = weights.transpose() * matrix;
  for (Eigen::Index n = 0; n < rate.cols(); ++n)
    if (sums(n) > 0) rate.col(n) *= total(n) / sums(n);
}

void scale_to_row_sums(Eigen::MatrixXd& rate, const std::vector<double>& total, const DirectionSet& set) {
  const Eigen::VectorXd b =
      symmetric_factors(rate, weights_of(set), Eigen::Map<const Eigen::VectorXd>(total.data(), rate.cols()));
  rate = b.asDiagonal() * rate * b.asDiagonal();
}

DenseKernel without_diagonal(Eigen::MatrixXd rate, std::vector<double> total, const DirectionSet& set) {
  rate.diagonal().setZero();
  const Eigen::RowVectorXd leaving = weights_of(set).transpose() * rate;
  return {std::move(rate), {leaving.begin(), leaving.end()}, std::move(total)};
}

DenseKernel dense_kernel(const PhaseFunction& phase, const DirectionSet& set) {
  Eigen::MatrixXd rate(set.count(), set.count());
  for (Eigen::Index n = 0; n < rate.cols(); ++n)
    for (Eigen::Index m = 0; m <= n; ++m)
      rate(m, n) = rate(n, m) = m == n ? 0 : phase_value(phase, 1 - one_minus_cosine(set, m, n));
  const auto count = static_cast<std::size_t>(set.count());
  try {
    scale_to_momentum_transfer(rate, std::vector<double>(count, 1 - phase_asymmetry(phase)), set);
  } catch (const InputError& error) {
    // Leaves, flakes and kernels have no moments.
    throw InputError(error.faults().front().text + ", or scattering_method = \"moments\"");
  }
  return without_diagonal(std::move(rate), std::vector<double>(count, 1), set);
}

DenseKernel galerkin_kernel(const PhaseFunction& phase, const DirectionSet& set) {
  const DiscreteHarmonics harmonics = complete_harmonics(set);
  Eigen::MatrixXd values(set.count(), harmonics.count());
  Eigen::VectorXd moments(harmonics.count());
  for (int k = 0; k < harmonics.count(); ++k) {
    moments(k) = phase_moment(phase, harmonics.degree_of(k)) / full_range(set.space());
    for (int m = 0; m < set.count(); ++m) values(m, k) = harmonics.value(k, OrdinateIndex(m));
  }
  return without_diagonal(values * moments.asDiagonal() * values.transpose(),
                          std::vector<double>(static_cast<std::size_t>(set.count()), 1), set);
}

DenseAccuracy dense_accuracy(const DenseKernel& kernel, const DirectionSet& set) {
  const Eigen::Map<const Eigen::VectorXd> weights = weights_of(set);
  DenseAccuracy accuracy;
  double scattering_angle = 0;  // of the ordinates that scatter at all
  const bool symmetric = is_symmetric(kernel.rate);
  const Eigen::VectorXd arriving =
      symmetric ? Eigen::VectorXd(kernel.rate * weights) : Eigen::VectorXd(kernel.rate.transpose() * weights);
  for (Eigen::Index n = 0; n < kernel.rate.cols(); ++n) {
    const double leaving = kernel.leaving[static_cast<std::size_t>(n)];
    const double total = kernel.total[static_cast<std::size_t>(n)];
    if (total == 0) continue;
    const double forward = 1 - leaving / total;
    double cosine = forward;
    for (Eigen::Index m = 0; m < kernel.rate.rows(); ++m)
      cosine += weights(m) * kernel.rate(m, n) / total * (1 - one_minus_cosine(set, m, n));
    // What leaves an ordinate is counted by construction; as much must arrive where all radiances are equal.
    accuracy.energy_error = std::max(accuracy.energy_error, std::abs(arriving(n) - leaving) / total);
    accuracy.asymmetry += weights(n) * cosine;
    const bool is_first = scattering_angle == 0;
    accuracy.smallest_forward = is_first ? forward : std::min(accuracy.smallest_forward, forward);
    accuracy.largest_forward = is_first ? forward : std::max(accuracy.largest_forward, forward);
    scattering_angle += weights(n);
  }
  if (scattering_angle > 0) accuracy.asymmetry /= scattering_angle;
  const double all = kernel.rate.cwiseAbs().sum();
  if (all > 0) {
    accuracy.smallest = kernel.rate.minCoeff() / kernel.rate.mean();
    accuracy.negative_share = -kernel.rate.cwiseMin(0).sum() / all;
  }
  return accuracy;
}

}  // namespace etendue
