// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/tetrahedra/search/outer_walls.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "mesh/geometry/arrangement/arrangement.h"
#include "mesh/tetrahedra/generation/tetrahedralize.h"

namespace etendue::outer_walls_test {
namespace {

constexpr std::array sides = {"xmin", "xmax", "ymin", "ymax", "zmin", "zmax"};

/// A room with a crate, in the air or on the floor, and a sheet.
TetrahedralMesh room(double bottom_of_crate) {
  Geometry geometry;
  BoxPrimitive room;
  room.region = "air";
  geometry.primitives.emplace_back(room);
  BoxPrimitive crate;
  crate.min = {0.4, 0.4, bottom_of_crate};
  crate.max = {0.7, 0.7, 0.6};
  crate.hole = true;
  crate.name = "crate";
  geometry.primitives.emplace_back(crate);
  geometry.sheets.push_back(
      {{Vec3(0.1, 0.1, 0.8), Vec3(0.3, 0.1, 0.8), Vec3(0.3, 0.3, 0.8), Vec3(0.1, 0.3, 0.8)},
       "front",
       "back",
       {}});
  return TetrahedralMesh(tetrahedralize(arrange(geometry), {{0.05}, 1.4, {}}));
}

TEST(OuterWalls, AreThoseOfTheRoom) {
  const TetrahedralMesh mesh = room(0.3);
  const std::vector<bool> outer = outer_walls(mesh);
  EXPECT_EQ(std::ranges::count(outer, true), 6);
  for (std::size_t w = 0; w < outer.size(); ++w)
    EXPECT_EQ(outer[w], std::ranges::count(sides, mesh.wall_names()[w]) > 0) << mesh.wall_names()[w];
}

// Below a crate on the floor there is nothing: its top looks out that way.
TEST(OuterWalls, ArePitsInTheFloorToo) {
  const TetrahedralMesh mesh = room(0);
  const std::vector<bool> outer = outer_walls(mesh);
  for (std::size_t w = 0; w < outer.size(); ++w) {
    const std::string& name = mesh.wall_names()[w];
    EXPECT_EQ(outer[w], std::ranges::count(sides, name) > 0 || name == "crate.zmax") << name;
  }
}

}  // namespace
}  // namespace etendue::outer_walls_test
