// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/angular/kernels/directional_kernel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "base/errors.h"
#include "base/text/vector_text.h"
#include "solver/materials/kernels/kernel_formula.h"
#include "solver/materials/kernels/leaf_canopy.h"
#include "solver/materials/kernels/micro_flakes.h"

namespace etendue {
namespace {

using std::numbers::pi;

/// Values that a person wrote with some digits agree to this part of the largest.
constexpr double written_agreement = 1e-9;

/// Part of itself by which the integral of a formula may be off: a tenth of what solutions on 100 directions
/// are.
constexpr double largest_uncertainty = 1e-3;

const Vec3& direction(const DirectionSet& set, Eigen::Index m) {
  return set.directions()[static_cast<std::size_t>(m)];
}

std::string from_into(const DirectionSet& set, Eigen::Index from, Eigen::Index into) {
  return fmt::format("from {} into {}", vector_text(direction(set, from)), vector_text(direction(set, into)));
}

void check_signs(const Eigen::MatrixXd& rate, const DirectionSet& set) {
  for (Eigen::Index n = 0; n < rate.cols(); ++n)
    for (Eigen::Index m = 0; m < rate.rows(); ++m)
      if (!(rate(m, n) >= 0 && std::isfinite(rate(m, n))))
        throw InputError(fmt::format("the kernel is {:.6g} {}; must be a finite number of at least 0",
                                     rate(m, n), from_into(set, n, m)));
}

/// k(w -> v) = k(-v -> -w); ordinates 2k and 2k + 1 are opposite.
void check_reciprocity(const Eigen::MatrixXd& rate, const DirectionSet& set) {
  const double scale = written_agreement * rate.maxCoeff();
  for (Eigen::Index n = 0; n < rate.cols(); ++n)
    for (Eigen::Index m = 0; m < rate.rows(); ++m)
      if (std::abs(rate(m, n) - rate(n ^ 1, m ^ 1)) > scale)
        throw InputError(
            fmt::format("the kernel is {:.6g} {} and {:.6g} the opposite way; it is not reciprocal, "
                        "leave `reciprocal` out or make k(w, v) = k(-v, -w)",
                        rate(m, n), from_into(set, n, m), rate(n ^ 1, m ^ 1)));
}

/// sigma_t - sigma_s(w) where the extinction is given, which must leave nothing negative.
std::vector<double> absorbed(double extinction, const std::vector<double>& scattered,
                             const DirectionSet& set) {
  std::vector<double> absorbing;
  for (std::size_t n = 0; n < scattered.size(); ++n) {
    if (scattered[n] > extinction * (1 + written_agreement))
      throw InputError(
          fmt::format("the kernel scatters {:.6g} of each unit of length out of the direction {}, more than "
                      "the extinction "
                      "{:.6g} takes; give more extinction, or absorption in its place",
                      scattered[n], vector_text(set.directions()[n]), extinction));
    absorbing.push_back(std::max(0.0, extinction - scattered[n]));
  }
  return absorbing;
}

/// Energy is only as good as the integral of the formula.
void check_resolved(const OutgoingMoments& moments, const Vec3& before) {
  if (!(moments.uncertainty <= largest_uncertainty))
    throw InputError(fmt::format(
        "what the kernel scatters out of the direction {}, {:.6g}, is uncertain by {:.2g} of itself (at most "
        "{:.0e} is accepted); it is too sharp for a formula, use a phase function or a matrix",
        vector_text(before), moments.scattered, moments.uncertainty, largest_uncertainty));
}

double mean_over_directions(const std::vector<double>& values, const DirectionSet& set) {
  return std::inner_product(values.begin(), values.end(), set.weights().begin(), 0.0) / (4 * pi);
}

/// Ross's kernel (1/pi) Gamma(w' -> w), Gamma the mean over leaves of |w.n||w'.n| times the reflectance where
/// light comes and goes on one side of the leaf, the transmittance where it goes through.
DirectionalKernel make(const LeafCanopy& leaves, const DirectionSet& set) {
  const LeafNormals normals = leaf_normals(leaves.angles);
  const auto count = static_cast<Eigen::Index>(normals.normals.size());
  Eigen::MatrixXd above(set.count(), count), below(set.count(), count);
  for (Eigen::Index m = 0; m < set.count(); ++m)
    for (Eigen::Index i = 0; i < count; ++i) {
      const double cosine = direction(set, m).dot(normals.normals[static_cast<std::size_t>(i)]);
      above(m, i) = std::max(cosine, 0.0);
      below(m, i) = std::max(-cosine, 0.0);
    }
  const Eigen::Map<const Eigen::VectorXd> shares(normals.shares.data(), count);
  const Eigen::MatrixXd same =
      above * shares.asDiagonal() * above.transpose() + below * shares.asDiagonal() * below.transpose();
  const Eigen::MatrixXd across = above * shares.asDiagonal() * below.transpose();
  Eigen::MatrixXd rate =
      (leaves.transmittance * same + leaves.reflectance * (across + across.transpose())) / pi;
  DirectionalKernel result;
  result.reference = 0.5;
  std::vector<double> scattered;
  for (const Vec3& w : set.directions()) {
    const double projection = leaf_projection(leaves.angles, w);
    scattered.push_back(projection * (leaves.reflectance + leaves.transmittance));
    result.absorbing.push_back(projection * (1 - leaves.reflectance - leaves.transmittance));
  }
  if (rate.maxCoeff() > 0) scale_to_row_sums(rate, scattered, set);
  result.kernel = without_diagonal(std::move(rate), std::move(scattered), set);
  return result;
}

/// Straight ahead flakes have no value: momentum, which does not ask for it, says the rest, as of a phase
/// function.
DirectionalKernel make(const MicroFlakes& flakes, const DirectionSet& set) {
  Eigen::MatrixXd rate(set.count(), set.count());
  for (Eigen::Index n = 0; n < rate.cols(); ++n)
    for (Eigen::Index m = 0; m < rate.rows(); ++m)
      rate(m, n) = m == n ? 0 : flake_value(flakes, direction(set, n), direction(set, m));
  DirectionalKernel result;
  result.reference = mean_flake_projection(flakes);
  std::vector<double> scattered, transfer;
  for (const Vec3& w : set.directions()) {
    const double projection = flake_projection(flakes, w);
    scattered.push_back(projection * flakes.albedo);
    transfer.push_back(flake_momentum_transfer(flakes, w) * flakes.albedo);
    result.absorbing.push_back(projection * (1 - flakes.albedo));
  }
  scale_to_momentum_transfer(rate, transfer, set);
  result.kernel = with_forward_part(std::move(rate), std::move(scattered), std::move(transfer), set);
  return result;
}

DirectionalKernel make(const KernelFormula& formula, const DirectionSet& set) {
  Eigen::MatrixXd rate(set.count(), set.count());
  for (Eigen::Index n = 0; n < rate.cols(); ++n)
    for (Eigen::Index m = 0; m < rate.rows(); ++m) {
      // The matrix has no use for the forward value, which a peak may not even have.
      rate(m, n) = m == n ? 0 : formula.at(direction(set, n), direction(set, m));
    }
  check_signs(rate, set);
  if (formula.reciprocal) check_reciprocity(rate, set);
  std::vector<double> scattered, transfer;
  double uncertainty = 0;
  for (const Vec3& w : set.directions()) {
    const OutgoingMoments moments = outgoing_moments(formula, w);
    check_resolved(moments, w);
    scattered.push_back(moments.scattered);
    transfer.push_back(moments.transfer);
    uncertainty = std::max(uncertainty, moments.uncertainty);
  }
  DirectionalKernel result;
  result.reference = mean_scattering(formula);
  if (formula.extinction) {
    result.absorbing = absorbed(*formula.extinction, scattered, set);
    result.reference = *formula.extinction;
  }
  scale_to_momentum_transfer(rate, transfer, set,
                             formula.reciprocal ? KeepSymmetry::always : KeepSymmetry::if_possible);
  result.kernel = with_forward_part(std::move(rate), std::move(scattered), std::move(transfer), set);
  result.kernel.uncertainty = uncertainty;
  return result;
}

DirectionalKernel make(const KernelMatrix& matrix, const DirectionSet& set) {
  if (matrix.count != set.count())
    throw InputError(
        fmt::format("the kernel's matrix is for {} directions and the {} set of order {} has {}; use "
                    "a matrix for this set, in the order that `etendue directions -o` writes",
                    matrix.count, set.name(), set.order(), set.count()));
  Eigen::MatrixXd rate =
      Eigen::Map<const Eigen::MatrixXd>(matrix.values.data(), matrix.count, matrix.count);  // [into][from]
  check_signs(rate, set);
  if (matrix.reciprocal) check_reciprocity(rate, set);
  const Eigen::Map<const Eigen::VectorXd> weights(set.weights().data(), set.count());
  const Eigen::RowVectorXd sums = weights.transpose() * rate;
  std::vector<double> scattered(sums.begin(), sums.end());
  DirectionalKernel result;
  result.reference = mean_over_directions(scattered, set);
  if (matrix.extinction) {
    result.absorbing = absorbed(*matrix.extinction, scattered, set);
    result.reference = *matrix.extinction;
  }
  result.kernel = without_diagonal(std::move(rate), std::move(scattered), set);
  return result;
}

DirectionalKernel make(const std::monostate&, const DirectionSet&) { return {}; }

}  // namespace

DirectionalKernel directional_kernel(const DirectionalScattering& scattering, const DirectionSet& set) {
  return std::visit([&set](const auto& matter) { return make(matter, set); }, scattering);
}

}  // namespace etendue
