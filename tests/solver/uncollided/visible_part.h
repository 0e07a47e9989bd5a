// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "base/vec3.h"

namespace etendue {

/// What a light of radiance 1 brings to a point: its fluence, and the irradiance of a meter that looks up.
struct VisibleLight {
  double fluence = 0, irradiance = 0;
};

/// That of a polygon at one height above the eye, its corners counterclockwise as seen from above: in empty
/// space by Lambert's formula (1760) and the solid angle by Girard's (1629), through a homogeneous medium of
/// an extinction by an integral along the sides.
VisibleLight light_of_polygon(const std::vector<Vec3>& polygon, const Vec3& eye, double extinction);

/// A flat convex light that shines down, as it is seen past a black convex body from below that body. What
/// the body hides of it is again a convex polygon.
class HalfHiddenLight {
 public:
  /// Corners of the light in order, all at one height; and of the body, in any order.
  HalfHiddenLight(std::vector<Vec3> light, std::vector<Vec3> body);

  /// What is seen of it.
  VisibleLight seen_from(const Vec3& eye, double extinction) const;
  /// All of it, with nothing in the way.
  VisibleLight whole_from(const Vec3& eye, double extinction) const;
  /// 0 in the umbra.
  double visible_area(const Vec3& eye) const;
  double area() const;

 private:
  std::vector<Vec3> hidden_part(const Vec3& eye) const;

  std::vector<Vec3> light_, body_;
};

}  // namespace etendue
