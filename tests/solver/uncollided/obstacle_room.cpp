// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/solver/uncollided/obstacle_room.h"

#include <cmath>
#include <numbers>

#include "mesh/geometry/arrangement/arrangement.h"
#include "mesh/geometry/primitives/sheet_shape.h"
#include "mesh/tetrahedra/generation/tetrahedralize.h"

namespace etendue {
namespace {

using std::numbers::pi;

const Vec3 &low = obstacle_low, &high = obstacle_high;

}  // namespace

std::vector<Vec3> corners_of(Obstacle obstacle) {
  std::vector<Vec3> corners;
  for (const double x : {low.x(), high.x()})
    for (const double y : {low.y(), high.y()})
      for (const double z : {low.z(), high.z()})
        if (obstacle == Obstacle::box || z == low.z()) corners.emplace_back(x, y, z);
  return corners;
}

TetrahedralMesh room_with(Obstacle obstacle, double max_volume) {
  Geometry geometry;
  BoxPrimitive room;
  room.region = "room";
  geometry.primitives.emplace_back(room);
  if (obstacle == Obstacle::box) {
    BoxPrimitive box;
    box.min = low;
    box.max = high;
    box.hole = true;
    box.name = "box";
    geometry.primitives.emplace_back(box);
  } else {
    geometry.sheets.push_back({rectangle_corners(low, {high.x(), high.y(), low.z()}), "top", "under", {}});
  }
  return TetrahedralMesh(tetrahedralize(arrange(geometry), {{max_volume}, 1.4, {}}));
}

std::vector<Vec3> rectangle(double x, double y) {
  return {{0.5 - x, 0.5 - y, lamp_height},
          {0.5 - x, 0.5 + y, lamp_height},
          {0.5 + x, 0.5 + y, lamp_height},
          {0.5 + x, 0.5 - y, lamp_height}};
}
std::vector<Vec3> disc(double radius, int sides) {
  std::vector<Vec3> rim;
  for (int i = sides; i-- > 0;) {
    const double angle = 2 * pi * i / sides;
    rim.emplace_back(0.5 + radius * std::cos(angle), 0.5 + radius * std::sin(angle), lamp_height);
  }
  return rim;
}

Light flat_light(const std::vector<Vec3>& rim) {
  SurfaceLight light{{}, {1}};
  for (std::size_t i = 2; i < rim.size(); ++i)
    for (const Vec3& corner : {rim[0], rim[i - 1], rim[i]}) light.triangles.push_back(corner);
  return {"lamp", light, {}};
}

}  // namespace etendue
