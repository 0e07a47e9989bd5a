// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/build/mesh_names.h"

#include <gtest/gtest.h>

#include "tests/app/case/case_text.h"

namespace etendue::mesh_names_test {
namespace {

std::string name_faults(const std::string& text, const MeshNames& names) {
  Case input = case_of(text);
  input.file = "slab.toml";
  try {
    check_names(input, names);
    return "";
  } catch (const InputError& error) {
    std::string faults;
    for (const Fault& fault : error.faults()) faults += std::to_string(fault.line) + ": " + fault.text + "\n";
    return faults;
  }
}

TEST(MeshNames, OfASurfaceAreThoseThatSomethingCarries) {
  SurfaceComplex surface;
  surface.region_names = {"air", "overwritten"};
  surface.wall_names = {"inside", "floor"};
  surface.seeds = {{Vec3::Zero(), 0}};
  surface.facets = {{{{0, 1, 2}}, {}, 1}, {{{0, 1, 2}}, {}, -1}};
  EXPECT_EQ(names_of(surface).regions, std::set<std::string>{"air"});
  EXPECT_EQ(names_of(surface).walls, std::set<std::string>{"floor"});
}

TEST(MeshNames, MatchWithTheRestStandingForOthers) {
  EXPECT_EQ(name_faults(cube, {{"air"}, {"xmin", "xmax"}}), "");
}

TEST(MeshNames, ThatNothingCarriesAreReportedAtOnce) {
  const std::string text = cube + R"([media.smok]
[walls.flor]
diffuse = 0.5
[mesh]
max_volume = { "*" = 1, smok = 2 }
[[mesh.box]]
region = "smok"
min = [0, 0, 0]
max = [1, 1, 1]
walls = { xmin = "flor" }
[[mesh.patch]]
wall = "lamp"
min = [0, 0, 1]
max = [1, 1, 1]
)";
  EXPECT_EQ(name_faults(text, {{"air", "smoke"}, {"floor", "xmax"}}),
            "7: media.smok: no region of the mesh is called \"smok\" (did you mean \"smoke\"?); there are "
            "air, smoke\n"
            "8: walls.flor: no wall of the mesh is called \"flor\" (did you mean \"floor\"?); there are "
            "floor, xmax\n"
            "11: mesh.max_volume.smok: no region of the mesh is called \"smok\" (did you mean \"smoke\"?); "
            "there are "
            "air, smoke\n"
            "12: mesh.box[1].region: no region of the mesh is called \"smok\" (did you mean \"smoke\"?); "
            "there are air, smoke\n"
            "12: mesh.box[1].walls.xmin: no wall of the mesh is called \"flor\" (did you mean \"floor\"?); "
            "there are floor, xmax\n"
            "17: mesh.patch[0].wall: no wall of the mesh is called \"lamp\"; there are floor, xmax\n");
}

TEST(MeshNames, WithoutAnEntryAreReported) {
  const std::string text = R"([[mesh.box]]
region = "air"
min = [0, 0, 0]
max = [1, 1, 1]
[media.air]
[walls.xmin]
)";
  EXPECT_EQ(name_faults(text, {{"air", "smoke"}, {"xmin", "crate.xmin"}}),
            "0: media.smoke: missing (the mesh has this region); add an entry for it, or \"*\"\n"
            "0: walls.\"crate.xmin\": missing (the mesh has this wall); add an entry for it, or \"*\"\n");
}

}  // namespace
}  // namespace etendue::mesh_names_test
