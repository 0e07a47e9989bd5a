// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/angular/kernels/dense_kernel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/errors.h"
#include "solver/angular/harmonics/harmonics.h"
#include "tests/solver/angular/sets/sets_to_test.h"

namespace etendue::dense_kernel_test {
namespace {

/// Sets of 80 or more directions of nearly equal weights.
std::vector<DirectionSet> quasi_uniform_sets() {
  return {directions_triangular(8), directions_triangular(16),     directions_ldfe_sq(1),
          directions_ldfe_sq(2),    directions_level_symmetric(8), directions_level_symmetric(16),
          directions_thurgood(4),   directions_thurgood(8),        directions_lebedev(15),
          directions_lebedev(23),   directions_lebedev(29),        directions_double_gauss(4)};
}

TEST(DenseKernel, KeepsEnergyAndAsymmetryOfPeaksOnEveryQuasiUniformSet) {
  for (const DirectionSet& set : quasi_uniform_sets())
    for (const double g : {0.3, 0.5, 0.8, 0.9, 0.95, 0.98}) {
      const DenseAccuracy accuracy = dense_accuracy(dense_kernel(PhaseHenyeyGreenstein{g}, set), set);
      EXPECT_LT(accuracy.energy_error, 1e-12) << label(set) << ", g = " << g;
      EXPECT_NEAR(accuracy.asymmetry, g, 1e-10) << label(set);
      EXPECT_LT(accuracy.momentum_error, 1e-10) << label(set) << ", g = " << g;
      EXPECT_LT(accuracy.reciprocity_error, 1e-12) << label(set) << ", g = " << g;
      EXPECT_GE(accuracy.smallest, 0) << label(set);
    }
}

std::vector<double> everywhere(const DirectionSet& set, double value) {
  return std::vector<double>(static_cast<std::size_t>(set.count()), value);
}

/// [into][from] values between ordinates, as they are.
Eigen::MatrixXd raw_values(const PhaseFunction& phase, const DirectionSet& set) {
  Eigen::MatrixXd rate(set.count(), set.count());
  for (int n = 0; n < set.count(); ++n)
    for (int m = 0; m < set.count(); ++m)
      rate(m, n) = phase_value(phase, set.direction(OrdinateIndex(m)).dot(set.direction(OrdinateIndex(n))));
  return rate;
}

TEST(DenseAccuracy, ShowsThatScalingIsMissing) {
  for (const DirectionSet& set : quasi_uniform_sets())
    for (const double g : {0.5, 0.8, 0.9}) {
      const Eigen::MatrixXd raw = raw_values(PhaseHenyeyGreenstein{g}, set);
      // Sums with the diagonal are not the integral of the phase function, nor those without it its momentum.
      // At most a thousandth of what it shows here is allowed where it is scaled.
      const double least = g < 0.9 ? 1e-9 : 1e-3;
      const DenseAccuracy sums = dense_accuracy(without_diagonal(raw, everywhere(set, 1), set), set);
      EXPECT_GT(sums.energy_error, least) << label(set) << ", g = " << g;
      const DenseAccuracy momentum =
          dense_accuracy(with_forward_part(raw, everywhere(set, 1), everywhere(set, 1 - g), set), set);
      EXPECT_GT(momentum.momentum_error, least) << label(set) << ", g = " << g;
    }
}

TEST(DenseAccuracy, ShowsAnExtinctionThatIsNotWhatTheMatrixScatters) {
  const DirectionSet set = directions_ldfe_sq(1);
  DenseKernel kernel = dense_kernel(PhaseHenyeyGreenstein{0.5}, set);
  kernel.leaving[7] *= 1 + 1e-6;
  EXPECT_GT(dense_accuracy(kernel, set).energy_error, 5e-7);
  kernel = dense_kernel(PhaseHenyeyGreenstein{0.5}, set);
  kernel.rate(3, 7) *= 1.01;
  EXPECT_GT(dense_accuracy(kernel, set).energy_error, 1e-6);
  kernel = dense_kernel(PhaseHenyeyGreenstein{0.5}, set);
  kernel.total[7] += 1e-6;
  EXPECT_GT(dense_accuracy(kernel, set).energy_error, 5e-7);
}

TEST(DenseKernel, StaysNonNegativeWhereTheForwardPartDoesNot) {
  // Near the poles of a product set ordinates stand closely: what goes straight ahead must be less than
  // nothing.
  const DirectionSet set = directions_product(16);
  const DenseAccuracy accuracy = dense_accuracy(dense_kernel(PhaseHenyeyGreenstein{0.98}, set), set);
  EXPECT_LT(accuracy.smallest_forward, 0);
  EXPECT_GE(accuracy.smallest, 0);
  EXPECT_LT(accuracy.energy_error, 1e-12);
  EXPECT_NEAR(accuracy.asymmetry, 0.98, 1e-10);
}

TEST(DenseKernel, IsSymmetricAndWithoutDiagonal) {
  const DirectionSet set = directions_ldfe_sq(1);
  const DenseKernel kernel = dense_kernel(PhaseCornetteShanks{0.7}, set);
  EXPECT_LT((kernel.rate - kernel.rate.transpose()).cwiseAbs().maxCoeff(), 1e-14 * kernel.rate.maxCoeff());
  EXPECT_EQ(kernel.rate.diagonal().cwiseAbs().maxCoeff(), 0);
}

TEST(DenseKernel, OfIsotropicScatteringIsNearlyIsotropic) {
  const DirectionSet set = directions_ldfe_sq(2);
  const DenseKernel kernel = dense_kernel(PhaseIsotropic{}, set);
  for (int m = 0; m < set.count(); ++m) {
    EXPECT_NEAR(kernel.rate(m, m ^ 1) * 4 * std::numbers::pi, 1, 2e-3);
    EXPECT_NEAR(1 - kernel.leaving[static_cast<std::size_t>(m)],
                set.weight(OrdinateIndex(m)) / (4 * std::numbers::pi), 2e-3);
  }
}

TEST(DenseKernel, KeepsEnergyAndAsymmetryOfEveryModel) {
  const std::vector<PhaseFunction> models = {
      PhaseIsotropic{},
      PhaseRayleigh{},
      PhaseHenyeyGreenstein{-0.6},
      PhaseDoubleHenyeyGreenstein{0.8, -0.5, 0.7},
      PhaseTable({-1, -0.2, 0.5, 0.9, 1}, {0.1, 0.2, 0.4, 2, 7}),
      PhaseMixture{{0.25, 0.75}, {PhaseRayleigh{}, PhaseHenyeyGreenstein{0.7}}}};
  for (const DirectionSet& set : {directions_ldfe_sq(1), directions_double_gauss(4)})
    for (const PhaseFunction& phase : models) {
      const DenseAccuracy accuracy = dense_accuracy(dense_kernel(phase, set), set);
      EXPECT_LT(accuracy.energy_error, 1e-12) << phase_name(phase) << " on " << label(set);
      EXPECT_NEAR(accuracy.asymmetry, phase_asymmetry(phase), 1e-10) << phase_name(phase);
    }
}

TEST(DenseKernel, OfAnEverSharperPeakBecomesNoScattering) {
  const DirectionSet set = directions_ldfe_sq(1);
  for (const DenseKernel& kernel : {dense_kernel(PhaseHenyeyGreenstein{1 - 1e-12}, set),
                                    galerkin_kernel(PhaseHenyeyGreenstein{1 - 1e-14}, set)})
    for (const double leaving : kernel.leaving) EXPECT_LT(std::abs(leaving), 1e-11);
}

TEST(GalerkinKernel, KeepsEnergyAndAsymmetryAndEqualsTheMomentsOfAShortSeries) {
  for (const DirectionSet& set : {directions_ldfe_sq(1), directions_triangular(8), directions_thurgood(4)}) {
    const DenseAccuracy accuracy = dense_accuracy(galerkin_kernel(PhaseHenyeyGreenstein{0.9}, set), set);
    EXPECT_LT(accuracy.energy_error, 1e-12) << label(set);
    EXPECT_NEAR(accuracy.asymmetry, 0.9, 1e-10) << label(set);
    EXPECT_GT(accuracy.negative_share, 0) << label(set);

    const PhaseFunction phase = PhaseLegendre{{1, 0.3, 0.1}};
    const DenseKernel kernel = galerkin_kernel(phase, set);
    const DiscreteHarmonics harmonics(set, 2);
    for (int n = 1; n < set.count(); ++n) {
      double value = 0;
      for (int k = 0; k < harmonics.count(); ++k)
        value += phase_moment(phase, harmonics.degree_of(k)) * harmonics.value(k, OrdinateIndex(0)) *
                 harmonics.value(k, OrdinateIndex(n)) / (4 * std::numbers::pi);
      EXPECT_NEAR(kernel.rate(0, n), value, 1e-13) << label(set);
    }
  }
}

TEST(MomentumTransferScaling, OfAnUnsymmetricMatrixKeepsWhatLeavesEveryOrdinate) {
  const DirectionSet set = directions_ldfe_sq(1);
  const auto count = static_cast<Eigen::Index>(set.count());
  Eigen::MatrixXd rate(count, count);
  std::vector<double> transfer;
  for (Eigen::Index n = 0; n < count; ++n) {
    transfer.push_back(1 + 0.5 * set.directions()[static_cast<std::size_t>(n)].z());
    for (Eigen::Index m = 0; m < count; ++m)
      rate(m, n) = 2 + set.directions()[static_cast<std::size_t>(m)].x();
  }
  scale_to_momentum_transfer(rate, transfer, set);
  for (Eigen::Index n = 0; n < count; ++n) {
    double sum = 0;
    for (Eigen::Index m = 0; m < count; ++m)
      sum += set.weights()[static_cast<std::size_t>(m)] * rate(m, n) *
             (1 - set.directions()[static_cast<std::size_t>(m)].dot(
                      set.directions()[static_cast<std::size_t>(n)]));
    EXPECT_NEAR(sum, transfer[static_cast<std::size_t>(n)], 1e-13);
  }
}

/// k(w -> v) = 1 + 0.5 (w.z - v.z) + 0.3 w.x v.x: reciprocal, but not symmetric.
Eigen::MatrixXd reciprocal_values(const DirectionSet& set) {
  Eigen::MatrixXd rate(set.count(), set.count());
  for (int n = 0; n < set.count(); ++n)
    for (int m = 0; m < set.count(); ++m) {
      const Vec3 &from = set.direction(OrdinateIndex(n)), &into = set.direction(OrdinateIndex(m));
      rate(m, n) = 1 + 0.5 * (from.z() - into.z()) + 0.3 * from.x() * into.x();
    }
  return rate;
}

TEST(MomentumTransferScaling, OfAReciprocalMatrixKeepsReciprocity) {
  for (const DirectionSet& set : {directions_ldfe_sq(1), directions_product(8)}) {
    // The integrals over the sphere of k and of k (1 - w.v).
    std::vector<double> total, transfer;
    for (const Vec3& w : set.directions()) {
      total.push_back(4 * std::numbers::pi * (1 + 0.5 * w.z()));
      transfer.push_back(total.back() +
                         4 * std::numbers::pi / 3 * (0.5 * w.z() * w.z() - 0.3 * w.x() * w.x() * w.x()));
    }
    Eigen::MatrixXd rate = reciprocal_values(set);
    scale_to_momentum_transfer(rate, transfer, set);
    const DenseAccuracy accuracy = dense_accuracy(with_forward_part(rate, total, transfer, set), set);
    EXPECT_LT(accuracy.reciprocity_error, 1e-13) << label(set);
    EXPECT_LT(accuracy.momentum_error, 1e-11) << label(set);
    EXPECT_LT(accuracy.energy_error, 1e-12) << label(set);
  }
}

TEST(MomentumTransferScaling, NamesAnOrdinateThatIsCutOff) {
  const DirectionSet set = directions_product(2);
  const Eigen::MatrixXd none = Eigen::MatrixXd::Zero(set.count(), set.count());
  const auto message = [&](Eigen::MatrixXd rate, const std::vector<double>& transfer) {
    try {
      scale_to_momentum_transfer(rate, transfer, set);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(message(none, everywhere(set, 0)), "");
  std::vector<double> transfer = everywhere(set, 0);
  transfer[1] = 0.5;
  EXPECT_EQ(message(none, transfer).rfind("light in the direction (", 0), 0u);
  EXPECT_NE(message(none, transfer).find("where the direction set has no ordinate"), std::string::npos);
  Eigen::MatrixXd one = none;
  one(3, 1) = 1;
  EXPECT_EQ(message(one, transfer), "");
  EXPECT_NE(message(one, everywhere(set, 0)).find("by a peak that integrals"), std::string::npos);
}

TEST(MomentumTransferScaling, GoesByColumnsWhereNoFactorsExistAndMayDoSo) {
  // From -z to +z and back, as a mirror would: factors of the two sides cannot give them different sums.
  const DirectionSet set = directions_product(2);
  Eigen::MatrixXd rate = Eigen::MatrixXd::Zero(set.count(), set.count());
  std::vector<double> transfer;
  for (int n = 0; n < set.count(); ++n) {
    const double z = set.direction(OrdinateIndex(n)).z();
    transfer.push_back(z > 0 ? 1 : 2);
    for (int m = 0; m < set.count(); ++m)
      if (set.direction(OrdinateIndex(m)).z() * z < 0) rate(m, n) = 1;
  }
  Eigen::MatrixXd copy = rate;
  EXPECT_THROW(scale_to_momentum_transfer(copy, transfer, set), InputError);
  scale_to_momentum_transfer(rate, transfer, set, KeepSymmetry::if_possible);
  EXPECT_LT(dense_accuracy(with_forward_part(rate, transfer, transfer, set), set).momentum_error, 1e-13);
}

TEST(MomentumTransferScaling, IsRefusedWhereNothingCanReachTheSum) {
  const DirectionSet set = directions_product(2);
  Eigen::MatrixXd rate = Eigen::MatrixXd::Zero(set.count(), set.count());
  rate(0, 1) = rate(1, 0) = 1;  // the others see nobody
  EXPECT_THROW(
      scale_to_momentum_transfer(rate, std::vector<double>(static_cast<std::size_t>(set.count()), 0.5), set),
      InputError);
}

TEST(ReducedMoments, KeepTheAsymmetryOfADeltaPeak) {
  const DirectionSet set = directions_ldfe_sq(1);
  for (const double g : {0.8, 0.9, 0.98}) {
    const double forward = phase_moment(PhaseHenyeyGreenstein{g}, 8);
    const ScatteringAccuracy accuracy = scattering_accuracy(PhaseHenyeyGreenstein{g}, 7, set, forward);
    EXPECT_LT(accuracy.energy_error, 1e-13);
    EXPECT_NEAR(accuracy.asymmetry, g, 1e-12);
    // Less of the kernel is negative than without.
    EXPECT_LT(accuracy.negative_share, scattering_accuracy(PhaseHenyeyGreenstein{g}, 7, set).negative_share);
  }
}

}  // namespace
}  // namespace etendue::dense_kernel_test
