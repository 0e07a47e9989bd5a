// SPDX-License-Identifier: AGPL-3.0-or-later
#include <gtest/gtest.h>

#include "solver/angular/harmonics/spherical_harmonics.h"
#include "solver/angular/sets/direction_set.h"

namespace etendue::lebedev_test {
namespace {

/// Largest integral over the set of a harmonic of degree `first` … `last`, which is 0 on the sphere.
double largest_integral(const DirectionSet& set, int first, int last) {
  std::vector<double> integrals(static_cast<std::size_t>(harmonic_count(last)), 0.0),
      values(integrals.size());
  for (std::size_t m = 0; m < set.directions().size(); ++m) {
    spherical_harmonics(set.directions()[m], last, values);
    for (std::size_t k = 0; k < values.size(); ++k) integrals[k] += set.weights()[m] * values[k];
  }
  double largest = 0;
  for (std::size_t k = static_cast<std::size_t>(first) * static_cast<std::size_t>(first); k < values.size();
       ++k)
    largest = std::max(largest, std::abs(integrals[k]));
  return largest;
}

class Lebedev : public testing::TestWithParam<int> {};

TEST_P(Lebedev, IsExactToItsDegreeAndNotBeyond) {
  const int degree = GetParam();
  const DirectionSet set = directions_lebedev(degree);
  EXPECT_LT(largest_integral(set, 1, degree), 1e-12);
  EXPECT_GT(largest_integral(set, degree + 1, degree + 1), 1e-6);
  // About (L + 1)^2 / 3 directions: one for every three numbers that a polynomial of degree L has.
  EXPECT_NEAR(set.count(), (degree + 1) * (degree + 1) / 3.0, 0.16 * set.count() + 2);
}

TEST_P(Lebedev, KeepsItsDirectionsUnderMirrorsAndSwaps) {
  const DirectionSet set = directions_lebedev(GetParam());
  const Vec3 swap = Vec3(1, -1, 0).normalized();
  for (int m = 0; m < set.count(); ++m) {
    for (int axis = 0; axis < 3; ++axis) ASSERT_GE(set.mirrored(OrdinateIndex(m), Vec3::Unit(axis)), 0);
    ASSERT_GE(set.mirrored(OrdinateIndex(m), swap), 0);
  }
}

INSTANTIATE_TEST_SUITE_P(Degrees, Lebedev, testing::ValuesIn(lebedev_degrees()),
                         [](const auto& degree) { return std::to_string(degree.param); });

TEST(LebedevDegrees, AreThoseWithPositiveWeights) {
  EXPECT_EQ(lebedev_degrees().front(), 3);
  EXPECT_EQ(lebedev_degrees().back(), 131);
  EXPECT_EQ(lebedev_degrees().size(), 29u);
  EXPECT_EQ(check_direction_order("lebedev", 131), "");
  EXPECT_EQ(
      check_direction_order("lebedev", 27),
      "no rule of this degree has positive weights; use 3, 5, 7, 9, 11, 15, 17, 19, 21, 23, 29, 31, 35, "
      "41, 47, 53, 59, 65, 71, 77, 83, 89, 95, 101, 107, 113, 119, 125, 131");
}

}  // namespace
}  // namespace etendue::lebedev_test
