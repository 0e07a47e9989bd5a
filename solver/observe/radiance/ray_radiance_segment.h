// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "solver/observe/radiance/ray_radiance.h"

namespace etendue {

/// Straight segment of a ray between mirrors.
struct RayRadiance::RaySegment {
  Vec3 from;
  Vec3 direction;
  const RayView& view;
  RayMatter::View light;        ///< what light that comes along it meets
  bool wall_is_diffuse = true;  ///< the one at its end

  Vec3 travel() const { return -direction; }
  Vec3 at(double distance) const { return from + distance * direction; }
};

}  // namespace etendue
