// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/observe/camera/camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace etendue {
namespace {

using std::numbers::pi;

/// How high a pixel is: a length, its ratio to the distance, or to the radius of a fisheye's circle.
double pixel_height(const Camera& camera) {
  if (camera.orthographic) return *camera.orthographic / camera.pixels[1];
  if (camera.projection == Projection::perspective)
    return 2 * std::tan(camera.field_of_view * pi / 360) / camera.pixels[1];
  return 2.0 / std::min(camera.pixels[0], camera.pixels[1]);
}

}  // namespace

CameraRays::CameraRays(const Camera& camera)
    : parallel_(camera.orthographic.has_value()),
      projection_(camera.projection),
      half_angle_(camera.field_of_view * pi / 360),
      position_(camera.position),
      ahead_((camera.look_at - camera.position).normalized()),
      pixels_(camera.pixels) {
  right_ = ahead_.cross(camera.up).normalized() * pixel_height(camera);
  down_ = ahead_.cross(right_);
}

bool CameraRays::shows(double across, double down) const {
  if (parallel_ || projection_ == Projection::perspective) return true;
  const double diameter = std::min(pixels_[0], pixels_[1]);
  return std::hypot(across - 0.5 * pixels_[0], down - 0.5 * pixels_[1]) <= diameter / 2;
}

CameraRay CameraRays::through(double across, double down) const {
  const Vec3 aside = (across - 0.5 * pixels_[0]) * right_ + (down - 0.5 * pixels_[1]) * down_;
  if (parallel_) return {position_ + aside, ahead_};
  if (projection_ != Projection::perspective) return fisheye_ray(aside);
  return {position_, (ahead_ + aside).normalized()};
}

// With r from 0 in the middle to 1 at the rim, where the angle is a: theta = r a, or sin(theta/2) = r
// sin(a/2).
CameraRay CameraRays::fisheye_ray(const Vec3& aside) const {
  const double radius = aside.norm();
  if (radius == 0) return {position_, ahead_};
  const double angle = projection_ == Projection::fisheye
                           ? radius * half_angle_
                           : 2 * std::asin(std::min(1.0, radius * std::sin(half_angle_ / 2)));
  return {position_, (std::cos(angle) * ahead_ + std::sin(angle) / radius * aside).normalized()};
}

}  // namespace etendue
