// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/angular/sets/refinement.h"
#include "solver/angular/harmonics/direction_report.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace etendue::refinement_test {
namespace {

using std::numbers::pi;

const Vec3 oblique(0.3, -0.5, 0.8);

TEST(Refinement, KeepsTheHalfRangesOnTheAxesAndTheSecondMoments) {
  for (const int levels : {1, 2, 4}) {
    const DirectionSetReport report = report_directions(directions_ldfe_sq(2, {oblique, 12, levels}));
    for (const double error : report.axis_half_range_error) EXPECT_LT(error, 1e-12) << levels;
    EXPECT_LT(report.second_moment_error, 1e-12);
    EXPECT_EQ(report.degree, 3);
    EXPECT_GT(report.smallest_weight, 0);
  }
}

TEST(Refinement, MakesDirectionsFinerInTheConesAndLeavesThoseOutside) {
  const DirectionSet plain = directions_ldfe_sq(2), fine = directions_ldfe_sq(2, {oblique, 10, 3});
  const Vec3 axis = oblique.normalized();
  const auto inside = [&](const DirectionSet& set) {
    int count = 0;
    for (const Vec3& d : set.directions())
      if (std::abs(d.dot(axis)) > std::cos(10 * pi / 180)) ++count;
    return count;
  };
  EXPECT_NEAR(inside(fine), 64 * inside(plain), 0.35 * 64 * inside(plain));
  int kept = 0;
  for (const Vec3& d : plain.directions()) {
    if (std::abs(d.dot(axis)) > std::cos(50 * pi / 180)) continue;
    ++kept;
    double nearest = 2;
    for (const Vec3& other : fine.directions()) nearest = std::min(nearest, (d - other).norm());
    EXPECT_LT(nearest, 1e-11);
  }
  EXPECT_GT(kept, 100);
}

TEST(Refinement, OfNoAngleStillSplitsTheQuadrilateralsAroundTheAxis) {
  EXPECT_GT(directions_ldfe_sq(1, {oblique, 0, 1}).count(), 96);
}

TEST(Refinement, OfNoAngleSplitsWhatTouchesTheAxis) {
  for (const int order : {1, 2, 3, 4})
    for (const Vec3& axis :
         {Vec3(0, 0, -1), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(1, 1, 1), Vec3(0, 0.6, -0.8)}) {
      const int count = directions_ldfe_sq(order, {axis, 0, 1}).count();
      EXPECT_EQ(count, directions_ldfe_sq(order, {axis, 1e-6, 1}).count())
          << order << ": " << axis.transpose();
      EXPECT_GT(count, directions_ldfe_sq(order).count());
    }
}

TEST(Refinement, LeavesMirrorsOnlyWhereTheyKeepTheCones) {
  const DirectionSet set = directions_ldfe_sq(1, {Vec3::UnitZ(), 20, 1});
  const DirectionSet tilted = directions_ldfe_sq(1, {oblique, 5, 1});
  int missing = 0;
  for (int m = 0; m < set.count(); ++m)
    for (int axis = 0; axis < 3; ++axis) EXPECT_GE(set.mirrored(OrdinateIndex(m), Vec3::Unit(axis)), 0);
  for (int m = 0; m < tilted.count(); ++m) missing += tilted.mirrored(OrdinateIndex(m), Vec3::UnitX()) < 0;
  EXPECT_GT(missing, 0);
}

TEST(Refinement, ThatIsTooFineIsRefused) {
  EXPECT_THROW(directions_ldfe_sq(8, {oblique, 90, 6}), std::length_error);
}

}  // namespace
}  // namespace etendue::refinement_test
