// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/angular/sets/direction_set.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "base/errors.h"
#include "solver/angular/harmonics/direction_report.h"
#include "tests/solver/angular/sets/sets_to_test.h"

namespace etendue::direction_set_test {
namespace {

using std::numbers::pi;

TEST(DirectionSet, HasTheDocumentedNumberOfDirections) {
  for (const int n : {2, 4, 10}) {
    EXPECT_EQ(directions_product(n).count(), 2 * n * n);
    EXPECT_EQ(directions_triangular(n).count(), n * (n + 2));
  }
  for (const int n : {1, 2, 3}) EXPECT_EQ(directions_ldfe_sq(n).count(), 96 * n * n);
  for (const int n : {2, 3, 6}) EXPECT_EQ(directions_double_gauss(n).count(), 8 * n * n);
  for (const int n : {1, 2, 5}) EXPECT_EQ(directions_thurgood(n).count(), 8 * n * n);
  for (int n = 2; n <= 16; n += 2) EXPECT_EQ(directions_level_symmetric(n).count(), n * (n + 2));
}

TEST(DirectionSet, HasPositiveWeightsThatSumToFourPi) {
  for (const DirectionSet& set : sets_to_test()) {
    double sum = 0;
    for (const double weight : set.weights()) {
      EXPECT_GT(weight, 0);
      sum += weight;
    }
    EXPECT_NEAR(sum, 4 * pi, 1e-13) << label(set);
  }
}

TEST(DirectionSet, HasUnitDirectionsOffTheCoordinatePlanes) {
  for (const DirectionSet& set : sets_to_test())
    for (const Vec3& direction : set.directions()) {
      EXPECT_NEAR(direction.norm(), 1, 1e-15);
      EXPECT_GT(direction.cwiseAbs().minCoeff(), 1e-3) << label(set);
    }
}

TEST(DirectionSet, IntegratesDirectionsAndTheirProducts) {
  for (const DirectionSet& set : sets_to_test()) {
    const DirectionSetReport report = report_directions(set);
    EXPECT_LT(report.first_moment_error, 1e-13) << label(set);
    EXPECT_LT(report.second_moment_error, 1e-13) << label(set);
  }
}

TEST(DirectionSet, KeepsOppositesInPairs) {
  for (const DirectionSet& set : sets_to_test())
    for (std::size_t k = 0; k < set.directions().size(); k += 2) {
      EXPECT_EQ(set.directions()[k], -set.directions()[k + 1]);
      EXPECT_EQ(set.weights()[k], set.weights()[k + 1]);
    }
}

TEST(DirectionSet, KeepsConsecutivePairsCloseInAngle) {
  for (const DirectionSet& set : sets_to_test()) {
    double sum = 0;
    for (std::size_t k = 0; k + 2 < set.directions().size(); k += 2)
      sum += std::acos(set.directions()[k].dot(set.directions()[k + 2]));
    const double spacing = std::sqrt(4 * pi / set.count());
    EXPECT_LT(sum / (set.count() / 2 - 1), 1.3 * spacing) << label(set);
  }
}

TEST(DirectionSet, IsClosedToTheLastBitUnderMirrorsAtAxisPlanes) {
  for (const DirectionSet& set : sets_to_test())
    for (int m = 0; m < set.count(); ++m)
      for (int axis = 0; axis < 3; ++axis) {
        const int partner = set.mirrored(OrdinateIndex(m), Vec3::Unit(axis));
        ASSERT_GE(partner, 0) << label(set);
        Vec3 image = set.direction(OrdinateIndex(m));
        image[axis] = -image[axis];
        EXPECT_EQ(set.direction(OrdinateIndex(partner)), image);
        EXPECT_EQ(set.weight(OrdinateIndex(partner)), set.weight(OrdinateIndex(m)));
        EXPECT_EQ(set.mirrored(OrdinateIndex(partner), -Vec3::Unit(axis)), m);
      }
}

TEST(DirectionSet, SomeAreClosedUnderTheOctahedralGroup) {
  std::array<Vec3, 2> diagonals = {Vec3(1, -1, 0).normalized(), Vec3(0, 1, -1).normalized()};
  for (const DirectionSet& set : {directions_level_symmetric(2), directions_level_symmetric(12),
                                  directions_level_symmetric(16), directions_thurgood(7)})
    for (int m = 0; m < set.count(); ++m)
      for (const Vec3& normal : diagonals) EXPECT_GE(set.mirrored(OrdinateIndex(m), normal), 0) << label(set);
}

TEST(DirectionSet, LdfeSqIsClosedToTheLastBitUnderTheOctahedralGroup) {
  const DirectionSet set = directions_ldfe_sq(3);
  const auto less = [](const Vec3& a, const Vec3& b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
  };
  std::vector<Vec3> sorted(set.directions().begin(), set.directions().end());
  std::sort(sorted.begin(), sorted.end(), less);
  std::array<int, 3> order = {0, 1, 2};
  do {
    for (const Vec3& d : set.directions())
      EXPECT_TRUE(std::binary_search(sorted.begin(), sorted.end(),
                                     Vec3(d[order[0]], d[order[1]], d[order[2]]), less));
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST(DirectionSet, LdfeSqIntegratesSmoothFunctionsWithOrderFour) {
  // Without a plane of symmetry. Sizes are those of a direction's part of the sphere.
  const auto integral = [](const DirectionSet& set) {
    double sum = 0;
    for (int m = 0; m < set.count(); ++m) {
      const Vec3& w = set.direction(OrdinateIndex(m));
      sum += set.weight(OrdinateIndex(m)) * std::exp(2 * w.x() + w.y() * w.z() + 0.3 * w.z());
    }
    return sum;
  };
  const double exact = integral(directions_product(24));
  std::vector<double> errors;
  for (const int order : {1, 2, 4, 8})
    errors.push_back(std::abs(integral(directions_ldfe_sq(order)) - exact) / exact);
  for (std::size_t level = 1; level < errors.size(); ++level)
    EXPECT_GE(std::log2(errors[level - 1] / errors[level]), 3.8) << level;
  EXPECT_LT(errors.back(), 1e-6);
}

TEST(DirectionSet, MirrorsAtDiagonalPlanesWhereTheSetAllowsIt) {
  const Vec3 diagonal = Vec3(1, 1, 0).normalized(), oblique = Vec3(1, 0, 1).normalized();
  EXPECT_GE(directions_product(8).mirrored(OrdinateIndex(0), diagonal), 0);
  EXPECT_EQ(directions_product(8).mirrored(OrdinateIndex(0), oblique), -1);
  EXPECT_GE(directions_ldfe_sq(2).mirrored(OrdinateIndex(0), oblique), 0);
  EXPECT_EQ(directions_ldfe_sq(2).mirrored(OrdinateIndex(0), Vec3(3, 4, 0) / 5), -1);
}

TEST(DirectionSet, HasTheSameHalfRangeOnBothSides) {
  const Vec3 normal = Vec3(0.3, -0.5, 0.7).normalized();
  for (const DirectionSet& set : sets_to_test())
    EXPECT_NEAR(set.half_range(normal), set.half_range(-normal), 1e-14) << label(set);
}

TEST(DirectionSet, RefusesWhatIsNoSet) {
  const std::vector<Vec3> axes = {Vec3::UnitX(), -Vec3::UnitX(), Vec3::UnitY(), -Vec3::UnitY()};
  EXPECT_NO_THROW(DirectionSet("four", 1, axes, {pi, pi, pi, pi}));
  EXPECT_THROW(DirectionSet("sum", 1, axes, {1, 1, 1, 1}), std::invalid_argument);
  EXPECT_THROW(DirectionSet("weights", 1, axes, {pi, pi, pi}), std::invalid_argument);
  EXPECT_THROW(DirectionSet("negative", 1, axes, {-pi, -pi, 3 * pi, 3 * pi}), std::invalid_argument);
  EXPECT_THROW(DirectionSet("uneven", 1, axes, {pi / 2, 3 * pi / 2, pi, pi}), std::invalid_argument);
  EXPECT_THROW(DirectionSet("lonely", 1, {Vec3::UnitX(), Vec3::UnitY()}, {2 * pi, 2 * pi}),
               std::invalid_argument);
  EXPECT_THROW(DirectionSet("long", 1, {2 * Vec3::UnitX(), -2 * Vec3::UnitX()}, {2 * pi, 2 * pi}),
               std::invalid_argument);
}

std::string message_of(const std::string& name, int order) {
  try {
    make_directions(name, order);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

TEST(DirectionSet, IsMadeByName) {
  for (const std::string& name : direction_set_names()) {
    int order = 1;
    while (!check_direction_order(name, order).empty()) ASSERT_LT(++order, 8) << name;
    EXPECT_EQ(make_directions(name, order).name(), name);
  }
}

TEST(DirectionSet, SaysWhichOrdersAreAccepted) {
  EXPECT_EQ(
      message_of("product", 3),
      "directions.order = 3: must be even (the levels of a product set lie in pairs above and below the "
      "equator); use 2, 4, 6 … 222");
  EXPECT_EQ(message_of("ldfe-sq", 0), "directions.order = 0: must be positive; use 1, 2, 3 … 32");
  EXPECT_EQ(message_of("triangular", 1000),
            "directions.order = 1000: too large (1002000 directions, more than 100000: each costs a sweep in "
            "every iteration); use 2, 4, 6 … 314");
  EXPECT_EQ(
      message_of("double-gauss", 1),
      "directions.order = 1: too small (one level in each hemisphere does not integrate z^2); use 2, 3, 4 "
      "… 111");
  EXPECT_EQ(
      message_of("level-symmetric", 18),
      "directions.order = 18: too large (level-symmetric sets of higher order lose their positive weights); "
      "use 2, 4, 6 … 16");
  EXPECT_NE(message_of("ldfe-sq", 2147483647).find("too large (442721857"), std::string::npos);
  EXPECT_EQ(message_of("ldfe", 1),
            "directions.set = \"ldfe\": unknown in this version; use product, triangular, double-gauss, "
            "ldfe-sq, level-symmetric, thurgood, lebedev, flatland");
  EXPECT_EQ(check_direction_order("ldfe", 1),
            "no order suits the unknown set \"ldfe\"; use product, triangular, double-gauss, ldfe-sq, "
            "level-symmetric, thurgood, lebedev, flatland");
}

TEST(DirectionSet, FlatlandStaysInThePlaneAndOffTheAxes) {
  for (const int order : {4, 8, 52}) {
    const DirectionSet set = directions_flatland(order);
    EXPECT_EQ(set.space(), AngularSpace::plane);
    EXPECT_EQ(set.count(), order);
    double sum = 0;
    for (int m = 0; m < order; ++m) {
      const OrdinateIndex ordinate(m);
      const Vec3& d = set.direction(ordinate);
      EXPECT_EQ(d.z(), 0);
      EXPECT_GT(std::min(std::abs(d.x()), std::abs(d.y())), 1.0 / order);
      for (int axis = 0; axis < 3; ++axis) EXPECT_GE(set.mirrored(ordinate, Vec3::Unit(axis)), 0);
      sum += set.weight(ordinate);
    }
    EXPECT_NEAR(sum, 2 * pi, 1e-14);
  }
  EXPECT_NE(message_of("flatland", 6).find("must be a multiple of 4"), std::string::npos);
}

TEST(DirectionSet, OfThePlaneIsRefusedOutsideIt) {
  EXPECT_THROW(DirectionSet("x", 2, {Vec3::UnitX(), -Vec3::UnitX(), Vec3::UnitZ(), -Vec3::UnitZ()},
                            {pi / 2, pi / 2, pi / 2, pi / 2}, AngularSpace::plane),
               std::invalid_argument);
}

TEST(DirectionSet, LargestLdfeSqSetConverges) {
  const DirectionSet set = directions_ldfe_sq(32);
  EXPECT_EQ(set.count(), 98304);
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(set.half_range(Vec3::Unit(axis)), pi, 1e-12);
}

}  // namespace
}  // namespace etendue::direction_set_test
