// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/point_light.h"

#include <numbers>

namespace etendue {

using std::numbers::pi;

// Photometric zero is `direction`, photometric horizontal `along`. LM-63-02, section 3: type C turns
// counterclockwise from there about the vertical, A clockwise, with vertical angles that are counted from the
// horizontal; in type B planes stand about the horizontal, with vertical angles from zero towards it.
PointLight point_light(const LightCase& light) {
  PointLight point{light.position, values_of(light.strength), light.direction, {}, light.intensity};
  for (const double degrees : light.angle) point.angle.push_back(degrees * pi / 180);
  for (const double degrees : light.plane) point.plane.push_back(degrees * pi / 180);
  const Vec3 up = -light.direction, ahead = (light.along - light.along.dot(up) * up).normalized();
  const Vec3 right = ahead.cross(up);
  point.zero_plane = light.type == PhotometricType::b ? light.direction : ahead;
  point.quarter_plane = light.type == PhotometricType::c ? Vec3(-right) : right;
  if (light.type == PhotometricType::b) point.axis = -ahead;
  return point;
}

}  // namespace etendue
