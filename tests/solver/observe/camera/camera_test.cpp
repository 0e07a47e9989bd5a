// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/observe/camera/camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace etendue::camera_test {
namespace {

Camera looking_along_y() {
  Camera camera;
  camera.position = {1, 2, 3};
  camera.look_at = {1, 7, 3};
  camera.field_of_view = 60;
  camera.pixels = {200, 100};
  return camera;
}

TEST(Camera, HasItsAimInTheMiddle) {
  const CameraRay ray = CameraRays(looking_along_y()).through(100, 50);
  EXPECT_LT((ray.origin - Vec3(1, 2, 3)).norm(), 1e-15);
  EXPECT_LT((ray.direction - Vec3::UnitY()).norm(), 1e-15);
}

TEST(Camera, ShowsItsFieldOfViewFromTopToBottom) {
  const CameraRays rays(looking_along_y());
  const Vec3 top = rays.through(100, 0).direction, bottom = rays.through(100, 100).direction;
  EXPECT_GT(top.z(), 0);
  EXPECT_NEAR(std::acos(top.dot(bottom)), std::numbers::pi / 3, 1e-14);
  const Vec3 right = rays.through(200, 50).direction;
  EXPECT_NEAR(right.x() / right.y(), 2 * std::tan(std::numbers::pi / 6), 1e-14);
}

TEST(Camera, HasParallelRaysWhereItIsOrthographic) {
  Camera camera = looking_along_y();
  camera.orthographic = 4;
  const CameraRays rays(camera);
  const CameraRay corner = rays.through(0, 0);
  EXPECT_EQ(corner.direction, Vec3(Vec3::UnitY()));
  EXPECT_LT((corner.origin - Vec3(-3, 2, 5)).norm(), 1e-14);
}

TEST(Camera, HasAnglesAsDistancesInAFisheye) {
  Camera camera = looking_along_y();
  camera.projection = Projection::fisheye;
  camera.field_of_view = 180;
  const CameraRays rays(camera);
  EXPECT_LT((rays.through(100, 50).direction - Vec3::UnitY()).norm(), 1e-15);
  EXPECT_LT((rays.through(150, 50).direction - Vec3::UnitX()).norm(), 1e-14);
  EXPECT_LT((rays.through(100, 0).direction - Vec3::UnitZ()).norm(), 1e-14);
  EXPECT_NEAR(rays.through(100, 75).direction.z(), -std::sqrt(0.5), 1e-14);
  EXPECT_EQ(rays.through(130, 20).origin, camera.position);
  EXPECT_TRUE(rays.shows(149.9, 50));
  EXPECT_FALSE(rays.shows(150.1, 50));
}

// Within the radius r of an equisolid picture there is the share r^2 of the half sphere's solid angle, so a
// cosine of 1 - r^2 at its rim.
TEST(Camera, HasSolidAnglesAsAreasInAnEquisolidFisheye) {
  Camera camera = looking_along_y();
  camera.projection = Projection::fisheye_equisolid;
  camera.field_of_view = 180;
  const CameraRays rays(camera);
  for (const double radius : {0.2, 0.5, 0.9, 1.0})
    EXPECT_NEAR(rays.through(100 + 50 * radius, 50).direction.y(), 1 - radius * radius, 1e-14);
}

TEST(Camera, TurnsAboutItsView) {
  Camera camera = looking_along_y();
  camera.up = {1, 4, 0};  // only the part across the view counts
  EXPECT_GT(CameraRays(camera).through(100, 0).direction.x(), 0.4);
}

}  // namespace
}  // namespace etendue::camera_test
