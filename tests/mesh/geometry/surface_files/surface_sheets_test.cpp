// SPDX-License-Identifier: AGPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mesh/geometry/surface_files/surface_file.h"
#include "mesh/tetrahedra/generation/tetrahedralize.h"
#include "tests/mesh/files/scratch_folder.h"
#include "tests/mesh/geometry/mesh_measures.h"

namespace etendue::surface_sheets_test {
namespace {

/// The cube from 0 to 4, with y up: its floor is y = 0.
const std::string cube = R"(
v 0 0 0
v 4 0 0
v 0 4 0
v 4 4 0
v 0 0 4
v 4 0 4
v 0 4 4
v 4 4 4
usemtl wood
f 1 2 6 5
usemtl paint
f 1 3 4 2
f 5 6 8 7
f 3 7 8 4
f 1 5 7 3
f 2 4 8 6
)";

/// A shade of two rectangles that meet at an angle, and a blind above it; seen from above counterclockwise.
const std::string sheets = R"(
usemtl shade
v 1 1 3
v 2 2 3
v 2 2 1
v 1 1 1
v 3 1 3
v 3 1 1
f 9 10 11 12
f 10 13 14 11
usemtl blind
v 1 3 3
v 3 3 3
v 3 3 1
f 15 16 17
)";

SurfaceComplex read(const std::string& text, UpAxis up = UpAxis::z) {
  const ScratchFolder folder;
  SurfaceFileOptions options;
  options.origin = {"case.toml", 3, "mesh.surface"};
  options.up = up;
  return read_surface(folder.write("room.obj", text), options);
}

std::string fault_of(const std::string& text) {
  try {
    read(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no fault";
}

TEST(SurfaceSheets, ObjMaterialsNameWallsAndGroupsGoFirst) {
  EXPECT_THAT(read(cube).wall_names, testing::ElementsAre("wood", "paint"));
  EXPECT_THAT(read("g room\n" + cube).wall_names, testing::ElementsAre("room"));
  EXPECT_THAT(read("o room\n" + cube).wall_names, testing::ElementsAre("wood", "paint"));
}

TEST(SurfaceSheets, FilesWithYUpAreTurned) {
  const TetrahedralMesh mesh(tetrahedralize(read(cube, UpAxis::y), {}));
  const auto areas = wall_area_normals(mesh);
  EXPECT_NEAR((areas.at("wood") - Vec3(0, 0, -16)).norm(), 0, 1e-12);
  EXPECT_NEAR(region_volumes(mesh).at("domain"), 64, 1e-11);
}

TEST(SurfaceSheets, OpenSurfacesInsideHaveAWallOnEachSide) {
  const TetrahedralMesh mesh(tetrahedralize(read(cube + sheets, UpAxis::y), {}));
  const auto areas = wall_area_normals(mesh);
  EXPECT_NEAR(region_volumes(mesh).at("domain"), 64, 1e-11);
  // Out of the domain: into the sheet, against the normal of the front.
  EXPECT_NEAR((areas.at("shade") - Vec3(0, 0, -4)).norm(), 0, 1e-12);
  EXPECT_NEAR((areas.at("shade.back") - Vec3(0, 0, 4)).norm(), 0, 1e-12);
  EXPECT_NEAR((areas.at("blind") - Vec3(0, 0, -2)).norm(), 0, 1e-12);
  EXPECT_NEAR((areas.at("blind.back") - Vec3(0, 0, 2)).norm(), 0, 1e-12);
}

TEST(SurfaceSheets, OpenSurfacesOutsideAndHolesAreRefusedWithAPlace) {
  EXPECT_THAT(
      fault_of(cube + "v 5 1 1\nv 6 1 1\nv 6 1 2\nf 9 10 11\n"),
      testing::HasSubstr(
          "it has a border, and lies in no closed part (at [5.666666666666667, 1, 1.3333333333333333])"));
  const std::string holed = cube.substr(0, cube.rfind("f "));
  EXPECT_THAT(fault_of(holed), testing::HasSubstr("the surface is not closed: it has 1 hole"));
}

}  // namespace
}  // namespace etendue::surface_sheets_test
