// SPDX-License-Identifier: AGPL-3.0-or-later
#include <gtest/gtest.h>

#include "tests/app/case/case_text.h"

namespace etendue::mesh_faults_test {
namespace {

struct Check {
  const char* name;
  const char* text;  ///< from line 3
  const char* message;
};

class MeshFault : public testing::TestWithParam<Check> {};

TEST_P(MeshFault, IsReportedWithFileLineAndKey) {
  EXPECT_EQ(faults_of(no_geometry + GetParam().text), GetParam().message);
}

constexpr const char* unit_box = "[[mesh.box]]\nregion = \"air\"\nmin = [0, 0, 0]\nmax = [1, 1, 1]\n";

const Check checks[] = {
    {"NoMesh", "",
     "slab.toml: mesh: no geometry; use exactly one of file, surface, labels or primitives (box, sphere, "
     "cylinder)"},
    {"EmptyMesh", "[mesh]\n",
     "slab.toml:3: mesh: no geometry; use exactly one of file, surface, labels or primitives (box, sphere, "
     "cylinder)"},
    {"FileAndSurface", "[mesh]\nfile = \"a.msh\"\nsurface = \"a.stl\"\n",
     "slab.toml:5: mesh.surface = \"a.stl\": a second geometry (mesh.file is at line 4); use exactly one of "
     "file, "
     "surface, labels or primitives"},
    {"FileAndBox",
     "[mesh]\nfile = \"a.msh\"\n[[mesh.box]]\nregion = \"air\"\nmin = [0, 0, 0]\nmax = [1, 1, 1]\n",
     "slab.toml:5: mesh.box: a second geometry (mesh.file is at line 4); use exactly one of file, surface, "
     "labels or "
     "primitives"},
    {"BoxIsOneTable", "[mesh.box]\nregion = \"air\"\n",
     "slab.toml:3: mesh.box: must not be a table; write [[mesh.box]]"},
    {"BoxUpsideDown", "[[mesh.box]]\nregion = \"air\"\nmin = [0, 0, 2]\nmax = [1, 1, 2]\n",
     "slab.toml:6: mesh.box[0].max = [1, 1, 2]: not above min in z (2 <= 2); a box needs min < max"},
    {"BoxWithoutCorner", "[[mesh.box]]\nregion = \"air\"\nmin = [0, 0, 2]\n",
     "slab.toml:3: mesh.box[0].max: missing; a list of three numbers"},
    {"BoxWithoutRegion", "[[mesh.box]]\nmin = [0, 0, 0]\nmax = [1, 1, 2]\n",
     "slab.toml:3: mesh.box[0].region: missing; use the name of a region, or hole = true"},
    {"RegionIsStar", "[[mesh.box]]\nregion = \"*\"\nmin = [0, 0, 0]\nmax = [1, 1, 2]\n",
     "slab.toml:4: mesh.box[0].region = \"*\": is reserved for all names without an entry; use another name"},
    {"RegionIsEmpty", "[[mesh.box]]\nregion = \"\"\nmin = [0, 0, 0]\nmax = [1, 1, 2]\n",
     "slab.toml:4: mesh.box[0].region = \"\": must not be empty"},
    {"CornerOfTwoNumbers", "[[mesh.box]]\nregion = \"air\"\nmin = [0, 0]\nmax = [1, 1, 2]\n",
     "slab.toml:5: mesh.box[0].min = [0, 0]: has 2 entries; use a list of three numbers"},
    {"CornerIsInfinite", "[[mesh.box]]\nregion = \"air\"\nmin = [0, 0, 0]\nmax = [1, 1, inf]\n",
     "slab.toml:6: mesh.box[0].max[2] = inf: must be a finite number; use a list of three numbers"},
    {"CornerIsHuge", "[[mesh.box]]\nregion = \"air\"\nmin = [0, 0, 0]\nmax = [1, 1, 1e300]\n",
     "slab.toml:6: mesh.box[0].max[2] = 1e+300: too large (powers and volumes would overflow); use numbers "
     "up to "
     "1e+60"},
    {"CornerWithUnit", "[[mesh.box]]\nregion = \"air\"\nmin = [0, 0, 0]\nmax = [1, 1, \"2 m\"]\n",
     "slab.toml:6: mesh.box[0].max[2] = \"2 m\": must not be text; use a list of three numbers in length "
     "(units are "
     "set in [units])"},
    {"UnknownSide",
     "[[mesh.box]]\nregion = \"air\"\nmin = [0, 0, 0]\nmax = [1, 1, 1]\nwalls = { zmn = \"floor\" }\n",
     "slab.toml:7: mesh.box[0].walls.zmn = \"floor\": unknown side (did you mean \"zmin\"?); use xmin, xmax, "
     "ymin, "
     "ymax, zmin or zmax"},
    {"NameWithoutHole", "[[mesh.box]]\nregion = \"air\"\nname = \"a\"\nmin = [0, 0, 0]\nmax = [1, 1, 1]\n",
     "slab.toml:5: mesh.box[0].name = \"a\": unused (only a hole has one); remove it"},
    {"HoleWithRegion",
     "[[mesh.box]]\nhole = true\nregion = \"air\"\nname = \"a\"\nmin = [0, 0, 0]\nmax = [1, 1, 1]\n",
     "slab.toml:5: mesh.box[0].region = \"air\": unused (a hole has none); remove it"},
    {"HoleWithoutName", "[[mesh.box]]\nhole = true\nmin = [0, 0, 0]\nmax = [1, 1, 1]\n",
     "slab.toml:3: mesh.box[0].name: missing; a hole needs a name for its walls"},
    {"HoleWithWalls",
     "[[mesh.box]]\nhole = true\nname = \"a\"\nmin = [0, 0, 0]\nmax = [1, 1, 1]\nwalls = { xmin = \"b\" }\n",
     "slab.toml:8: mesh.box[0].walls: unused (a hole's walls are NAME.xmin to NAME.zmax); "
     "remove "
     "it"},
    {"HoleIsANumber", "[[mesh.box]]\nhole = 1\nregion = \"air\"\nmin = [0, 0, 0]\nmax = [1, 1, 1]\n",
     "slab.toml:4: mesh.box[0].hole = 1: must not be an integer; use true or false"},
    {"SphereWithoutRadius", "[[mesh.sphere]]\nregion = \"air\"\ncenter = [0, 0, 0]\nradius = 0\n",
     "slab.toml:6: mesh.sphere[0].radius = 0: out of range; use a number above 0"},
    {"SphereOfFewFacets", "[[mesh.sphere]]\nregion = \"air\"\ncenter = [0, 0, 0]\nradius = 1\nfacets = 3\n",
     "slab.toml:7: mesh.sphere[0].facets = 3: out of range; use an integer from 20 to 1000000"},
    {"CylinderWithoutLength",
     "[[mesh.cylinder]]\nregion = \"air\"\nfrom = [0, 0, 0]\nto = [0, 0, 0]\nradius = 1\n",
     "slab.toml:6: mesh.cylinder[0].to = [0, 0, 0]: the same point as from (a cylinder has a length); use "
     "two points"},
    {"PatchOnAFile",
     "[mesh]\nfile = \"a.msh\"\n[[mesh.patch]]\nwall = \"lamp\"\nmin = [0, 0, 1]\nmax = [1, 1, 1]\n",
     "slab.toml:5: mesh.patch: unused (patches lie on boxes); remove it"},
    {"VolumeOfAFile", "[mesh]\nfile = \"a.msh\"\nmax_volume = 1\n",
     "slab.toml:5: mesh.max_volume = 1: unused (the cells of a mesh file stay as they are); remove it"},
    {"NegativeVolume", "[mesh]\nsurface = \"a.stl\"\nmax_volume = { \"*\" = 1, smoke = -1.5 }\n",
     "slab.toml:5: mesh.max_volume.smoke = -1.5: out of range; use a number, or a table of one for each "
     "region, each "
     "above 0"},
    {"VolumeAndEdge", "[mesh]\nsurface = \"a.stl\"\nmax_volume = 1\nedge_length = 1\n",
     "slab.toml:6: mesh.edge_length = 1: given beside max_volume (both bound the cells' size); use one of "
     "the two"},
    {"QualityThatNoMesherReaches", "[mesh]\nsurface = \"a.stl\"\nquality = 1.05\n",
     "slab.toml:5: mesh.quality = 1.05: out of range; use a number at least 1.1"},
    {"ScaleIsZero", "[mesh]\nfile = \"a.msh\"\nscale = 0.0\n",
     "slab.toml:5: mesh.scale = 0.0: out of range; use a number above 0"},
    {"RegionsOfAFile", "[mesh]\nfile = \"a.msh\"\nregions = { air = [0, 0, 0] }\n",
     "slab.toml:5: mesh.regions: unused (only a surface takes it); remove it"},
    {"RegionPointIsANumber", "[mesh]\nsurface = \"a.stl\"\nregions = { air = 3 }\n",
     "slab.toml:5: mesh.regions.air = 3: must not be an integer; use a table of points [x, y, z]"},
    {"SheetWithAFile",
     "[mesh]\nfile = \"a.msh\"\n[[mesh.sheet]]\nfront = \"a\"\nmin = [0, 0, 0]\nmax = [1, 1, 0]\n",
     "slab.toml:5: mesh.sheet: unused (sheets stand among boxes, spheres and cylinders); remove it"},
    {"SheetWithoutPlace",
     "[[mesh.box]]\nregion = \"air\"\nmin = [0, 0, 0]\nmax = [1, 1, 1]\n[[mesh.sheet]]\nfront = \"a\"\n",
     "slab.toml:7: mesh.sheet[0].corners: missing; use a list of corners, or min and max of a rectangle"},
    {"SheetThatIsNotFlat",
     "[[mesh.box]]\nregion = \"air\"\nmin = [0, 0, 0]\nmax = [1, 1, 1]\n[[mesh.sheet]]\nfront = "
     "\"a\"\ncorners = [[0, 0, 0], [1, 0, 0], [1, 1, 0.5], [0, 1, 0]]\n",
     "slab.toml:9: mesh.sheet[0].corners = [[0, 0, 0], [1, 0, 0], [1, 1, 0.5], [0, 1, 0]]: is not flat ([1, "
     "0, 0] lies beside the plane); use several sheets"},
    {"FileIsANumber", "[mesh]\nfile = 3\n", "slab.toml:4: mesh.file = 3: must not be an integer; use text"},
};

INSTANTIATE_TEST_SUITE_P(Each, MeshFault, testing::ValuesIn(checks),
                         [](const auto& check) { return std::string(check.param.name); });

TEST(MeshFault, PatchMustBeFlat) {
  EXPECT_EQ(
      faults_of(no_geometry + unit_box +
                "[[mesh.patch]]\nwall = \"lamp\"\nmin = [0, 0, 0]\nmax = [1, 1, 1]\n"),
      "slab.toml:10: mesh.patch[0].max = [1, 1, 1]: not a rectangle with min; use min and max that agree in "
      "exactly one coordinate and rise in the others");
}

TEST(MeshFault, ScaleIsUnusedByPrimitives) {
  EXPECT_EQ(faults_of(no_geometry + unit_box + "[mesh]\nscale = 2\n"),
            "slab.toml:8: mesh.scale = 2: unused (it multiplies coordinates read from a file); remove it");
}

}  // namespace
}  // namespace etendue::mesh_faults_test
