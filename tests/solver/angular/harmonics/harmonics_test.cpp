// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/angular/harmonics/harmonics.h"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <numbers>
#include <vector>

#include "solver/angular/harmonics/spherical_harmonics.h"
#include "tests/solver/angular/sets/sets_to_test.h"

namespace etendue::harmonics_test {
namespace {

using std::numbers::pi;

TEST(SphericalHarmonics, ObeyTheAdditionTheoremUpToTheHighestDegree) {
  constexpr int degree = highest_given_degree;
  const Vec3 a = Vec3(0.2, -0.7, 0.4).normalized();
  for (const Vec3& b : {Vec3(0, 0, 1), Vec3(-0.5, 0.1, -0.3), Vec3(1, 0, 0), Vec3(0.2, -0.7, 0.4)}) {
    const Vec3 to = b.normalized();
    std::vector<double> at_a(harmonic_count(degree)), at_b(at_a.size());
    spherical_harmonics(a, degree, at_a);
    spherical_harmonics(to, degree, at_b);
    for (int l = 0; l <= degree; ++l) {
      double sum = 0;
      for (int k = l * l; k < harmonic_count(l); ++k)
        sum += at_a[static_cast<std::size_t>(k)] * at_b[static_cast<std::size_t>(k)];
      EXPECT_NEAR(sum, (2 * l + 1) * std::legendre(static_cast<unsigned>(l), a.dot(to)), 1e-12)
          << "degree " << l;
    }
  }
}

TEST(SphericalHarmonics, OfHighDegreesAreOrthonormal) {
  // Lebedev's rule is exact for products of degree 131; every 43rd function up to 65.
  constexpr int degree = 65, step = 43;
  const DirectionSet set = directions_lebedev(131);
  std::vector<double> values(harmonic_count(degree));
  const int chosen = (harmonic_count(degree) + step - 1) / step;
  Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(chosen, chosen);
  Eigen::VectorXd row(chosen);
  for (int m = 0; m < set.count(); ++m) {
    spherical_harmonics(set.direction(OrdinateIndex(m)), degree, values);
    for (int k = 0; k < chosen; ++k) row(k) = values[static_cast<std::size_t>(k * step)];
    gram += set.weight(OrdinateIndex(m)) / (4 * pi) * row * row.transpose();
  }
  EXPECT_LT((gram - Eigen::MatrixXd::Identity(chosen, chosen)).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(DiscreteHarmonics, OfHighDegreesAreOrthonormalInThePlane) {
  const DirectionSet set = directions_flatland(272);
  const DiscreteHarmonics harmonics(set, highest_given_degree);
  EXPECT_EQ(harmonics.count(), 2 * highest_given_degree + 1);
  Eigen::MatrixXd values(set.count(), harmonics.count());
  for (int m = 0; m < set.count(); ++m)
    for (int k = 0; k < harmonics.count(); ++k) values(m, k) = harmonics.value(k, OrdinateIndex(m));
  const Eigen::MatrixXd gram = values.transpose() * values / set.count();
  EXPECT_LT((gram - Eigen::MatrixXd::Identity(gram.rows(), gram.cols())).cwiseAbs().maxCoeff(), 1e-13);
}

TEST(GivenDegree, IsWhatTheSetResolvesOfIt) {
  // 96 ordinates cannot tell more than 96 functions apart: of degree 9 there are 100.
  const DirectionSet set = directions_ldfe_sq(1);
  const ScatteringDegree found = given_degree(highest_given_degree, PhaseHenyeyGreenstein{0.9}, set);
  EXPECT_LT(found.degree, 9);
  EXPECT_EQ(found.degree, DiscreteHarmonics(set, 12).full_degree());
  EXPECT_EQ(found.reason.rfind("all that the direction set resolves", 0), 0u) << found.reason;
  const ScatteringDegree high = given_degree(100, PhaseHenyeyGreenstein{0.9}, directions_flatland(272));
  EXPECT_EQ(high.degree, 100);
}

TEST(SphericalHarmonics, OfDegreeOneAreTheDirection) {
  const Vec3 direction = Vec3(0.2, -0.7, 0.4).normalized();
  std::vector<double> values(4);
  spherical_harmonics(direction, 1, values);
  EXPECT_DOUBLE_EQ(values[0], 1);
  EXPECT_DOUBLE_EQ(values[1], std::sqrt(3.0) * direction.y());
  EXPECT_DOUBLE_EQ(values[2], std::sqrt(3.0) * direction.z());
  EXPECT_DOUBLE_EQ(values[3], std::sqrt(3.0) * direction.x());
}

TEST(DiscreteHarmonics, AreOrthonormalOnEverySet) {
  for (const DirectionSet& set : sets_to_test()) {
    const DiscreteHarmonics harmonics(set, 7);
    double largest = 0;
    for (int j = 0; j < harmonics.count(); ++j)
      for (int k = 0; k <= j; ++k) {
        double sum = 0;
        for (int m = 0; m < set.count(); ++m) {
          const OrdinateIndex ordinate(m);
          sum += set.weight(ordinate) * harmonics.value(j, ordinate) * harmonics.value(k, ordinate);
        }
        largest = std::max(largest, std::abs(sum - (j == k ? 4 * pi : 0)));
      }
    EXPECT_LT(largest, 1e-13) << label(set);
  }
}

TEST(DiscreteHarmonics, OfOddDegreesAndNoOthersChangeTheirSignInOppositeDirections) {
  std::vector<DirectionSet> sets = sets_to_test();
  sets.push_back(directions_flatland(32));
  for (const DirectionSet& set : sets) {
    const DiscreteHarmonics harmonics(set, 7);
    double largest = 0;
    for (std::int32_t m = 0; m < set.count(); m += 2) {
      EXPECT_DOUBLE_EQ(set.weight(OrdinateIndex(m)), set.weight(OrdinateIndex(m + 1)));
      for (int k = 0; k < harmonics.count(); ++k) {
        const double sign = harmonics.degree_of(k) % 2 == 0 ? 1 : -1;
        const double there = harmonics.value(k, OrdinateIndex(m));
        largest = std::max(largest, std::abs(harmonics.value(k, OrdinateIndex(m + 1)) - sign * there));
      }
    }
    EXPECT_LT(largest, 1e-13) << label(set);
  }
}

TEST(DiscreteHarmonics, BeginWithOneAndTheDirection) {
  const DirectionSet set = directions_ldfe_sq(1);
  const DiscreteHarmonics harmonics(set, 3);
  for (int m = 0; m < set.count(); ++m) {
    const OrdinateIndex ordinate(m);
    EXPECT_EQ(harmonics.value(0, ordinate), 1);
    for (int axis = 0; axis < 3; ++axis)
      EXPECT_EQ(harmonics.value(1 + axis, ordinate), std::sqrt(3.0) * set.direction(ordinate)[axis]);
  }
  EXPECT_EQ(harmonics.degree_of(0), 0);
  EXPECT_EQ(harmonics.degree_of(3), 1);
  EXPECT_EQ(harmonics.degree_of(4), 2);
}

TEST(DiscreteHarmonics, EqualTheRawOnesOnAnExactSet) {
  // The product of two functions of degree 7 has degree 14, and this set is exact to 31.
  const DirectionSet set = directions_product(16);
  const DiscreteHarmonics harmonics(set, 7);
  std::vector<double> raw(harmonic_count(7));
  for (int m = 0; m < set.count(); ++m) {
    spherical_harmonics(set.direction(OrdinateIndex(m)), 7, raw);
    for (int k = 4; k < harmonics.count(); ++k)
      EXPECT_NEAR(harmonics.value(k, OrdinateIndex(m)), raw[static_cast<std::size_t>(k)], 1e-12);
  }
}

TEST(DiscreteHarmonics, LeaveOutWhatASetCannotTellApart) {
  const DirectionSet eight = directions_product(2);
  const DiscreteHarmonics harmonics(eight, 7);
  EXPECT_EQ(harmonics.count(), eight.count());
  EXPECT_EQ(harmonics.full_degree(), 1);  // x^2 is constant on the corners of a cube
  EXPECT_EQ(DiscreteHarmonics(directions_triangular(4), 7).full_degree(), 3);
  EXPECT_EQ(DiscreteHarmonics(directions_ldfe_sq(1), 7).full_degree(), 7);
  EXPECT_EQ(DiscreteHarmonics(eight, 0).count(), 1);
}

TEST(DiscreteHarmonics, SpanASpaceThatMirrorsKeep) {
  // Scattering through degree l alone, from m to n, is the same between the mirror images of m and n.
  const DirectionSet set = directions_ldfe_sq(1);
  const DiscreteHarmonics harmonics(set, 6);
  const auto kernel = [&](int m, int n, int degree) {
    double sum = 0;
    for (int k = 0; k < harmonics.count(); ++k)
      if (harmonics.degree_of(k) == degree)
        sum += harmonics.value(k, OrdinateIndex(m)) * harmonics.value(k, OrdinateIndex(n));
    return sum;
  };
  const Vec3 mirror = Vec3(1, -1, 0).normalized();
  for (int n = 0; n < set.count(); ++n)
    for (int degree = 2; degree <= 6; ++degree)
      EXPECT_NEAR(
          kernel(5, n, degree),
          kernel(set.mirrored(OrdinateIndex(5), mirror), set.mirrored(OrdinateIndex(n), mirror), degree),
          1e-12);
}

}  // namespace
}  // namespace etendue::harmonics_test
