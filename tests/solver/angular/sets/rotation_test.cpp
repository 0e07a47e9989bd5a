// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/angular/sets/rotation.h"

#include <gtest/gtest.h>

#include <algorithm>

#include <Eigen/LU>

#include "solver/angular/harmonics/direction_report.h"
#include "solver/angular/harmonics/harmonics.h"
#include "tests/solver/angular/sets/sets_to_test.h"

namespace etendue::rotation_test {
namespace {

TEST(Rotation, TurnsCounterclockwiseAboutItsAxis) {
  const Rotation quarter = rotation_about({0, 0, 2}, 90);
  EXPECT_LT((quarter * Vec3::UnitX() - Vec3::UnitY()).norm(), 1e-15);
  EXPECT_LT((quarter * Vec3::UnitZ() - Vec3::UnitZ()).norm(), 1e-15);
}

TEST(Rotation, AtRandomIsARotationThatItsSeedDecides) {
  for (const std::uint64_t seed : {0, 1, 2, 77}) {
    const Rotation rotation = random_rotation(seed);
    EXPECT_LT((rotation * rotation.transpose() - Rotation::Identity()).norm(), 1e-14);
    EXPECT_NEAR(rotation.determinant(), 1, 1e-14);
    EXPECT_EQ(rotation, random_rotation(seed));
    EXPECT_NE(rotation, random_rotation(seed + 1));
  }
}

TEST(Rotation, AtRandomInThePlaneIsAboutZ) {
  const Rotation rotation = random_rotation(3, AngularSpace::plane);
  EXPECT_EQ(rotation.col(2), Vec3(Vec3::UnitZ()));
  EXPECT_EQ(rotation, random_rotation(3, AngularSpace::plane));
  const DirectionSet set = directions_flatland(12);
  EXPECT_EQ(rotated(set, rotation).space(), AngularSpace::plane);
  EXPECT_THROW(rotated(set, random_rotation(3)), std::invalid_argument);
}

TEST(Rotation, AtRandomFavoursNoDirection) {
  constexpr int count = 4000;
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  Vec3 first = Vec3::Zero();
  double trace = 0;
  for (std::uint64_t seed = 0; seed < count; ++seed) {
    const Rotation rotation = random_rotation(seed);
    const Vec3 image = rotation * Vec3::UnitX();
    first += image / count;
    second += image * image.transpose() / count;
    trace += rotation.trace() / count;
  }
  // Uniform rotations: means 0, 1/3 of the identity, and 0, each with a standard error of about 0.01.
  EXPECT_LT(first.norm(), 0.05);
  EXPECT_LT((second - Eigen::Matrix3d::Identity() / 3).norm(), 0.05);
  EXPECT_LT(std::abs(trace), 0.06);
}

TEST(RotatedSet, KeepsWhatTheSetIntegrates) {
  const Rotation rotation = random_rotation(3);
  for (const DirectionSet& set : {directions_ldfe_sq(1), directions_product(8), directions_double_gauss(4),
                                  directions_level_symmetric(8), directions_thurgood(4)}) {
    const DirectionSet turned = rotated(set, rotation);
    const DirectionSetReport before = report_directions(set), after = report_directions(turned);
    EXPECT_EQ(turned.name(), "rotated " + set.name());
    EXPECT_EQ(after.count, before.count);
    EXPECT_EQ(after.degree, before.degree) << label(set);
    EXPECT_LT(after.first_moment_error, 1e-13);
    EXPECT_LT(after.second_moment_error, 1e-13);
    EXPECT_NEAR(after.kernel_row_error, before.kernel_row_error, 1e-10);
    EXPECT_NEAR(turned.half_range(rotation * Vec3::UnitZ()), set.half_range(Vec3::UnitZ()), 1e-13);
  }
}

TEST(RotatedSet, KeepsOppositesToTheLastBitAndScattersExactly) {
  const DirectionSet set = rotated(directions_ldfe_sq(2), random_rotation(11));
  for (std::size_t k = 0; k < set.directions().size(); k += 2) {
    EXPECT_EQ(set.directions()[k], -set.directions()[k + 1]);
    EXPECT_EQ(set.weights()[k], set.weights()[k + 1]);
  }
  const ScatteringAccuracy accuracy = scattering_accuracy(PhaseHenyeyGreenstein{0.8}, 7, set);
  EXPECT_LT(accuracy.energy_error, 1e-12);
  EXPECT_NEAR(accuracy.asymmetry, 0.8, 1e-10);
}

TEST(RotatedSet, HasNoMirrorImagesAtAxisPlanesButAtTurnedOnes) {
  const Rotation rotation = rotation_about({1, 2, 3}, 40);
  const DirectionSet set = rotated(directions_ldfe_sq(1), rotation);
  EXPECT_EQ(set.mirrored(OrdinateIndex(0), Vec3::UnitX()), -1);
  EXPECT_GE(set.mirrored(OrdinateIndex(0), rotation * Vec3::UnitX()), 0);
}

TEST(RotatedSet, CopiesBeginWithTheSetAndAreDrawnAgain) {
  const DirectionSet set = directions_ldfe_sq(1);
  const std::vector<DirectionSet> copies = rotated_copies(set, 3, 5), again = rotated_copies(set, 3, 5);
  ASSERT_EQ(copies.size(), 3U);
  EXPECT_TRUE(std::ranges::equal(copies[0].directions(), set.directions()));
  EXPECT_TRUE(std::ranges::equal(copies[2].directions(), again[2].directions()));
  EXPECT_GT((copies[1].directions()[0] - copies[2].directions()[0]).norm(), 1e-3);
  EXPECT_GT((copies[1].directions()[0] - set.directions()[0]).norm(), 1e-3);
}

TEST(RotatedSet, CopiesOfAPlaneSetStayInThePlane) {
  for (const DirectionSet& copy : rotated_copies(directions_flatland(8), 3, 2))
    for (const Vec3& direction : copy.directions()) EXPECT_EQ(direction.z(), 0);
}

}  // namespace
}  // namespace etendue::rotation_test
