// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/picture/camera.h"

#include <cmath>
#include <numbers>

namespace etendue {

CameraRays::CameraRays(const Camera& camera)
    : parallel_(camera.orthographic.has_value()),
      position_(camera.position),
      ahead_((camera.look_at - camera.position).normalized()),
      pixels_(camera.pixels) {
  const double height =
      parallel_ ? *camera.orthographic : 2 * std::tan(camera.field_of_view * std::numbers::pi / 360);
  right_ = ahead_.cross(camera.up).normalized() * (height / pixels_[1]);
  down_ = ahead_.cross(right_);
}

CameraRay CameraRays::through(double across, double down) const {
  const Vec3 aside = (across - 0.5 * pixels_[0]) * right_ + (down - 0.5 * pixels_[1]) * down_;
  if (parallel_) return {position_ + aside, ahead_};
  return {position_, (ahead_ + aside).normalized()};
}

}  // namespace etendue
