// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/angular/kernels/dense_kernel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/errors.h"
#include "base/text/vector_text.h"
#include "solver/angular/harmonics/harmonics.h"

namespace etendue {
namespace {

// The scaling is repeated until factors change by less than this: sums over hundreds of terms round to it.
constexpr double settled = 1e-14;
// Sums that are off by more than this after so many steps mean that there is no scaling.
constexpr double acceptable = 1e-11;
constexpr int most_scaling_steps = 5000;

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

/// The factors do not exist, or an ordinate is cut off.
class NoScaling : public InputError {
 public:
  using InputError::InputError;
};

/// An ordinate whose light should be scattered though the matrix sends nothing anywhere. What scatters
/// nowhere may keep its zeros.
void check_sums(const Eigen::VectorXd& sums, const Eigen::VectorXd& total, const DirectionSet& set) {
  for (Eigen::Index n = 0; n < sums.size(); ++n) {
    const char* problem =
        sums(n) == 0 && total(n) != 0
            ? "is scattered only where the direction set has no ordinate; use more directions"
        : sums(n) != 0 && total(n) == 0
            ? "is scattered into an ordinate by a peak that integrals over the kernel miss; use "
              "a wider peak or a matrix"
            : nullptr;
    if (problem != nullptr)
      throw InputError(fmt::format("light in the direction {} {}",
                                   vector_text(set.directions()[static_cast<std::size_t>(n)]), problem));
  }
}

/// Factors b with b_m sum over n of A_mn w_n b_n = total_m (Sinkhorn and Knopp 1967, the symmetric form with
/// a geometric mean of steps). A is symmetric. Where both sides are 0, so are the factors' rows.
Eigen::VectorXd symmetric_factors(const Eigen::MatrixXd& a, const Eigen::VectorXd& weights,
                                  const Eigen::VectorXd& total) {
  Eigen::VectorXd b = Eigen::VectorXd::Ones(a.rows());
  double change = 1;
  for (int step = 0; step < most_scaling_steps && change > settled; ++step) {
    const Eigen::VectorXd sums = a * (weights.array() * b.array()).matrix();
    double largest = 0;
    for (Eigen::Index m = 0; m < b.size(); ++m) {
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
    throw NoScaling(
        "the scattering matrix cannot be scaled to its energy and mean cosine on this direction set (too few "
        "ordinates see each other through it); use more directions");
  return b;
}

bool is_symmetric(const Eigen::MatrixXd& rate) {
  return (rate - rate.transpose()).cwiseAbs().maxCoeff() <= 1e-13 * rate.cwiseAbs().maxCoeff();
}

/// [m][n] rate(m, -n), which is symmetric where the kernel is reciprocal; ordinates 2k and 2k + 1 are
/// opposite.
Eigen::MatrixXd from_opposite(const Eigen::MatrixXd& rate) {
  Eigen::MatrixXd result(rate.rows(), rate.cols());
  for (Eigen::Index n = 0; n < rate.cols(); ++n) result.col(n) = rate.col(n ^ 1);
  return result;
}

Eigen::VectorXd from_opposite(const Eigen::VectorXd& values) {
  Eigen::VectorXd result(values.size());
  for (Eigen::Index n = 0; n < values.size(); ++n) result(n) = values(n ^ 1);
  return result;
}

void scale_columns(Eigen::MatrixXd& rate, const Eigen::VectorXd& sums, const Eigen::VectorXd& total) {
  for (Eigen::Index n = 0; n < rate.cols(); ++n)
    if (total(n) != 0) rate.col(n) *= total(n) / sums(n);
}

}  // namespace

void scale_to_momentum_transfer(Eigen::MatrixXd& rate, const std::vector<double>& transfer,
                                const DirectionSet& set, KeepSymmetry keep) {
  const Eigen::Map<const Eigen::VectorXd> weights = weights_of(set);
  const Eigen::VectorXd total = Eigen::Map<const Eigen::VectorXd>(transfer.data(), rate.cols());
  const Eigen::MatrixXd matrix = transfer_matrix(rate, set);
  const Eigen::VectorXd sums = matrix.transpose() * weights;
  check_sums(sums, total, set);
  try {
    if (is_symmetric(rate)) {
      const Eigen::VectorXd b = symmetric_factors(matrix, weights, total);
      rate = b.asDiagonal() * rate * b.asDiagonal();
      return;
    }
    const Eigen::MatrixXd opposite = from_opposite(matrix);
    if (is_symmetric(opposite)) {
      const Eigen::VectorXd b = symmetric_factors(opposite, weights, from_opposite(total));
      rate = b.asDiagonal() * rate * from_opposite(b).asDiagonal();
      return;
    }
  } catch (const NoScaling&) {
    if (keep == KeepSymmetry::always) throw;
  }
  scale_columns(rate, sums, total);
}

void scale_to_row_sums(Eigen::MatrixXd& rate, const std::vector<double>& total, const DirectionSet& set) {
  const Eigen::VectorXd b =
      symmetric_factors(rate, weights_of(set), Eigen::Map<const Eigen::VectorXd>(total.data(), rate.cols()));
  rate = b.asDiagonal() * rate * b.asDiagonal();
}

DenseKernel without_diagonal(Eigen::MatrixXd rate, std::vector<double> total, const DirectionSet& set) {
  const Eigen::VectorXd ahead = rate.diagonal().cwiseProduct(weights_of(set));
  rate.diagonal().setZero();
  const Eigen::RowVectorXd leaving = weights_of(set).transpose() * rate;
  return {
      std::move(rate), {leaving.begin(), leaving.end()}, std::move(total), {ahead.begin(), ahead.end()}, {}};
}

DenseKernel with_forward_part(Eigen::MatrixXd rate, std::vector<double> total, std::vector<double> transfer,
                              const DirectionSet& set) {
  DenseKernel kernel = without_diagonal(std::move(rate), std::move(total), set);
  for (std::size_t n = 0; n < kernel.ahead.size(); ++n) kernel.ahead[n] = kernel.total[n] - kernel.leaving[n];
  kernel.transfer = std::move(transfer);
  return kernel;
}

DenseKernel dense_kernel(const PhaseFunction& phase, const DirectionSet& set) {
  Eigen::MatrixXd rate(set.count(), set.count());
  for (Eigen::Index n = 0; n < rate.cols(); ++n)
    for (Eigen::Index m = 0; m <= n; ++m)
      rate(m, n) = rate(n, m) = m == n ? 0 : phase_value(phase, 1 - one_minus_cosine(set, m, n));
  const auto count = static_cast<std::size_t>(set.count());
  std::vector<double> transfer(count, 1 - phase_asymmetry(phase));
  try {
    scale_to_momentum_transfer(rate, transfer, set);
  } catch (const InputError& error) {
    // Leaves, flakes and kernels have no moments.
    throw InputError(error.faults().front().text + ", or scattering_method = \"moments\"");
  }
  return with_forward_part(std::move(rate), std::vector<double>(count, 1), std::move(transfer), set);
}

DenseKernel galerkin_kernel(const PhaseFunction& phase, const DirectionSet& set) {
  const DiscreteHarmonics harmonics = complete_harmonics(set);
  Eigen::MatrixXd values(set.count(), harmonics.count());
  Eigen::VectorXd moments(harmonics.count());
  for (int k = 0; k < harmonics.count(); ++k) {
    moments(k) = phase_moment(phase, harmonics.degree_of(k)) / full_range(set.space());
    for (int m = 0; m < set.count(); ++m) values(m, k) = harmonics.value(k, OrdinateIndex(m));
  }
  const auto count = static_cast<std::size_t>(set.count());
  DenseKernel kernel = without_diagonal(values * moments.asDiagonal() * values.transpose(),
                                        std::vector<double>(count, 1), set);
  kernel.transfer.assign(count, 1 - phase_asymmetry(phase));
  return kernel;
}

namespace {

/// What the matrix does to light of one ordinate.
struct Outcome {
  double sent = 0;      ///< into others
  double momentum = 0;  ///< lost
};

Outcome outcome(const DenseKernel& kernel, const DirectionSet& set, Eigen::Index n) {
  Outcome sum;
  for (Eigen::Index m = 0; m < kernel.rate.rows(); ++m) {
    const double rate = set.weights()[static_cast<std::size_t>(m)] * kernel.rate(m, n);
    sum.sent += rate;
    sum.momentum += rate * one_minus_cosine(set, m, n);
  }
  return sum;
}

double reciprocity_error(const Eigen::MatrixXd& rate) {
  const double largest = rate.cwiseAbs().maxCoeff();
  const Eigen::MatrixXd opposite = from_opposite(rate);
  return largest > 0 ? (opposite - opposite.transpose()).cwiseAbs().maxCoeff() / largest : 0;
}

}  // namespace

DenseAccuracy dense_accuracy(const DenseKernel& kernel, const DirectionSet& set) {
  const Eigen::VectorXd arriving = kernel.rate * weights_of(set);
  const bool symmetric = is_symmetric(kernel.rate);
  DenseAccuracy accuracy;
  double scattered = 0;  // of isotropic light
  for (Eigen::Index n = 0; n < kernel.rate.cols(); ++n) {
    const auto at = static_cast<std::size_t>(n);
    const double leaving = kernel.leaving[at], total = kernel.total[at];
    if (total == 0) continue;
    const Outcome light = outcome(kernel, set, n);
    double difference =
        std::max({std::abs(light.sent - leaving), std::abs(leaving + kernel.ahead[at] - total),
                  std::abs(light.sent + kernel.ahead[at] - total)});
    if (symmetric) difference = std::max(difference, std::abs(arriving(n) - leaving));
    accuracy.energy_error = std::max(accuracy.energy_error, difference / total + kernel.uncertainty);
    if (!kernel.transfer.empty() && kernel.transfer[at] > 0)
      accuracy.momentum_error =
          std::max(accuracy.momentum_error,
                   std::abs(light.momentum - kernel.transfer[at]) / kernel.transfer[at] + kernel.uncertainty);
    const double forward = 1 - leaving / total, weight = set.weights()[at];
    accuracy.asymmetry += weight * (total - light.momentum);
    const bool is_first = scattered == 0;
    accuracy.smallest_forward = is_first ? forward : std::min(accuracy.smallest_forward, forward);
    accuracy.largest_forward = is_first ? forward : std::max(accuracy.largest_forward, forward);
    scattered += weight * total;
  }
  if (scattered > 0) accuracy.asymmetry /= scattered;
  accuracy.reciprocity_error = reciprocity_error(kernel.rate);
  const double all = kernel.rate.cwiseAbs().sum();
  if (all > 0) {
    accuracy.smallest = kernel.rate.minCoeff() / kernel.rate.mean();
    accuracy.negative_share = -kernel.rate.cwiseMin(0).sum() / all;
  }
  return accuracy;
}

}  // namespace etendue
