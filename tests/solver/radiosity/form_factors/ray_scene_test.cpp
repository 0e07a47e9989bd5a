// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/radiosity/form_factors/ray_scene.h"

#include <gtest/gtest.h>

#include "tests/solver/radiosity/form_factors/ray_factors.h"
#include "tests/solver/radiosity/reference_shapes.h"

namespace etendue::ray_scene_test {
namespace {

const std::vector<TriangleCorners> lid = {{Vec3(-1, -1, 1), Vec3(0, 1, 1), Vec3(1, -1, 1)}};

TEST(RayScene, RaysMeetFrontsOnly) {
  const RayScene seen(lid), from_behind(turned(lid));
  const auto hit = seen.first_hit(Vec3::Zero(), Vec3::UnitZ());
  ASSERT_TRUE(hit.has_value());
  EXPECT_EQ(hit->triangle, 0u);
  EXPECT_NEAR(hit->distance, 1, 1e-6);
  EXPECT_FALSE(from_behind.first_hit(Vec3::Zero(), Vec3::UnitZ()).has_value());
  EXPECT_FALSE(seen.first_hit(Vec3::Zero(), -Vec3::UnitZ()).has_value());
}

TEST(RayScene, WhatStandsBetweenTwoPointsBlocks) {
  const RayScene scene(lid);
  EXPECT_TRUE(scene.is_blocked(Vec3::Zero(), Vec3(0, 0, 2)));
  EXPECT_FALSE(scene.is_blocked(Vec3::Zero(), Vec3(0, 0, 1)));
  EXPECT_FALSE(scene.is_blocked(Vec3::Zero(), Vec3(5, 0, 2)));
}

TEST(RayScene, TheOtherSideOfASheetIsNotMetAtOnce) {
  std::vector<TriangleCorners> both = lid;
  const std::vector<TriangleCorners> other = turned(lid);
  both.insert(both.end(), other.begin(), other.end());
  const RayScene scene(both);
  const Vec3 on(0.1, -0.1, 1);
  EXPECT_FALSE(scene.first_hit(on, Vec3::UnitZ()).has_value());
  EXPECT_FALSE(scene.first_hit(on, -Vec3::UnitZ()).has_value());
  EXPECT_FALSE(scene.is_blocked(on, Vec3(0, 0, 3)));
  EXPECT_FALSE(scene.is_blocked(Vec3(0, 0, -3), on));
  EXPECT_TRUE(scene.is_blocked(Vec3(0, 0, -3), Vec3(0, 0, 3)));
}

// From inside of a closed surface every ray meets it.
TEST(RayFactors, ClosedSurfacesLoseNoRays) {
  const std::vector<TriangleCorners> sphere = turned(sphere_triangles(1, 6));
  const RayScene scene(sphere);
  const std::vector<std::size_t> group(sphere.size(), 0);
  EXPECT_EQ(factors_by_rays(sphere, scene, group, 1, {.count = 100000, .seed = 3})[1].value, 0);
}

TEST(RayFactors, AreTheSameForAnyNumberOfThreads) {
  const RayScene scene(lid);
  const std::vector<Vec3> floor = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
  const auto by = [&](int threads) {
    return factors_by_rays(polygon_triangles(floor), scene, {0}, 1, {.count = 5000, .seed = 7}, threads)[0]
        .value;
  };
  EXPECT_EQ(by(1), by(3));
}

}  // namespace
}  // namespace etendue::ray_scene_test
