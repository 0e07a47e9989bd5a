// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/keys/override.h"

#include <gtest/gtest.h>

#include "tests/app/case/case_text.h"

namespace etendue::override_test {
namespace {

TEST(Override, ReplacesAValue) {
  EXPECT_EQ(case_of(cube + "[solve]\ntolerance = 1e-3\n", {"solve.tolerance=1e-8"}).solve.tolerance, 1e-8);
}

TEST(Override, AddsAValueAndItsTable) {
  EXPECT_EQ(case_of(cube, {"solve.max_sweeps = 7"}).solve.max_sweeps, 7);
  const Case result = case_of(cube, {"mesh.max_volume={'*'=1, air=0.5}"});
  EXPECT_EQ(result.mesh.max_volume->by_region.at("air"), 0.5);
  EXPECT_EQ(result.mesh.max_volume->origin.file, "--set");
}

TEST(Override, TakesTextThatIsNotToml) {
  EXPECT_EQ(case_of(cube, {"title=Smoke in a room"}).title, "Smoke in a room");
  EXPECT_EQ(case_of(cube, {"directions.set=product", "directions.order=4"}).direction_set, "product");
}

TEST(Override, CountsEntriesOfListsFromZero) {
  for (const char* key : {"mesh.box[0].max", "mesh.box.0.max"}) {
    const Case result = case_of(cube, {std::string(key) + "=[2, 2, 2]"});
    EXPECT_EQ(std::get<BoxPrimitive>(result.mesh.geometry.primitives[0]).max, Vec3(2, 2, 2));
  }
}

TEST(Override, TakesQuotedKeys) {
  const Case result = case_of(
      cube, {"media.\"*\".absorption=2", "mesh.box[0].walls={ xmin = 'a.b' }", "walls.'a.b'.diffuse=0.5"});
  EXPECT_EQ(std::get<double>(result.media.at("*").absorption->values[0]), 2);
  EXPECT_EQ(std::get<double>(result.walls.at("a.b").diffuse.values[0]), 0.5);
}

TEST(Override, KeepsThePlaceOfAPrimitive) {
  const std::string ball = "[[mesh.sphere]]\nregion = \"air\"\ncenter = [0, 0, 0]\nradius = 1\n";
  const Case result = case_of(cube + ball, {"mesh.box[0]={region=\"b\", min=[0,0,0], max=[1,1,1]}"});
  EXPECT_TRUE(std::holds_alternative<BoxPrimitive>(result.mesh.geometry.primitives[0]));
  const Case other = case_of(cube + ball, {"mesh.sphere[0]={region=\"b\", center=[0,0,0], radius=2}"});
  EXPECT_TRUE(std::holds_alternative<SpherePrimitive>(other.mesh.geometry.primitives[1]));
}

TEST(Override, TheLastOneCounts) {
  EXPECT_EQ(case_of(cube, {"solve.threads=1", "solve.threads=2"}).solve.threads, 2);
}

struct Check {
  const char* name;
  const char* assignment;
  const char* message;
};

class OverrideFault : public testing::TestWithParam<Check> {};

TEST_P(OverrideFault, NamesTheKey) {
  EXPECT_EQ(faults_of(cube, {GetParam().assignment}), GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    Each, OverrideFault,
    testing::Values(
        Check{"NoEqualsSign", "solve.tolerance",
              "--set: solve.tolerance: not an assignment; use key=value, as solve.tolerance=1e-8"},
        Check{"NoKey", "=3", "--set: =3: not an assignment; use key=value, as solve.tolerance=1e-8"},
        Check{"OpenQuote", "media.\"a=3",
              "--set: media.\"a=3: not an assignment; use key=value, as solve.tolerance=1e-8"},
        Check{"Misspelt", "solve.tolerence=1e-8",
              "--set: solve.tolerence = 1e-08: unknown key; did you mean \"tolerance\"?"},
        Check{"OutOfRange", "solve.tolerance=2",
              "--set: solve.tolerance = 2: out of range; use a number above 0 and below 1"},
        Check{"WrongType", "solve.tolerance=small",
              "--set: solve.tolerance = \"small\": must not be text; use a number above 0 and below 1"},
        Check{"NoSuchEntry", "mesh.box[1].max=[1,1,1]",
              "--set: mesh.box[1].max=[1,1,1]: no such entry; mesh.box has 1 entry; use mesh.box[0]"},
        Check{"ListWithoutEntry", "mesh.box.max=[1,1,1]",
              "--set: mesh.box.max=[1,1,1]: no such entry; mesh.box has 1 entry; use mesh.box[0]"},
        Check{"QualityOutOfRange", "mesh.quality=1.05",
              "--set: mesh.quality = 1.05: out of range; use a number at least 1.1"},
        Check{"BelowANumber", "mesh.box[0].region.a=1",
              "--set: mesh.box[0].region.a=1: no such key; mesh.box[0].region is text, not a table"},
        Check{"Empty", "directions.set=", "--set: directions.set = \"\": must not be empty"}),
    [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace etendue::override_test
