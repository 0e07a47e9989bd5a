// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/read_light.h"

#include <gtest/gtest.h>

#include "app/case/light_table.h"
#include "tests/app/case/case_text.h"

namespace etendue {
namespace {

TEST(ReadLight, KnowsPointsAndSpots) {
  const Case input = case_of(cube + R"([[light]]
name = "bulb"
kind = "point"
position = [0.5, 0.5, 0.9]
power = 3
[[light]]
name = "beamer"
kind = "spot"
position = [0.5, 0.5, 0.9]
direction = [0, 0, -2]
angle = 20
falloff = 5
power = 7
)");
  ASSERT_EQ(input.lights.size(), 2U);
  EXPECT_EQ(input.lights[0].position, Vec3(0.5, 0.5, 0.9));
  EXPECT_TRUE(input.lights[0].angle.empty());
  EXPECT_EQ(input.lights[1].direction, Vec3(0, 0, -1));
  EXPECT_EQ(input.lights[1].angle, (std::vector<double>{0, 15, 20}));
  EXPECT_EQ(input.lights[1].intensity, (std::vector<double>{1, 1, 0}));
  EXPECT_EQ(input.lights[1].strength, std::vector<double>{7});
}

TEST(ReadLight, TakesTheBeamOfAWallForASun) {
  const Case input = case_of(cube + "[walls.zmax]\nbeam = { direction = [0, 0, -3], irradiance = 2 }\n");
  ASSERT_EQ(input.lights.size(), 1U);
  EXPECT_EQ(input.lights[0].kind, "sun");
  EXPECT_EQ(input.lights[0].walls, std::vector<std::string>{"zmax"});
}

TEST(ReadLight, AsksForWhatAKindNeeds) {
  EXPECT_EQ(faults_of(cube + "[[light]]\nname = \"bulb\"\nkind = \"point\"\nposition = [0, 0, 0]\n"),
            "slab.toml:7: light[0]: a light of kind point needs power; add it");
  EXPECT_EQ(faults_of(cube + "[[light]]\nname = \"a\"\nkind = \"sky\"\nradiance = 1\nangle = 3\n"),
            "slab.toml:11: light[0].angle = 3: unused (it is no key of the kind sky); remove it");
  EXPECT_EQ(
      faults_of(cube + "[[light]]\nname = \"a\"\nkind = \"wall\"\nradiance = 1\nwalls = [\"zmx\"]\n"),
      "slab.toml:7: light[0].walls: no wall can be called \"zmx\" (did you mean \"zmax\"?); there can be "
      "xmax, xmin, ymax, ymin, zmax, zmin");
}

TEST(LightTable, ReadsIesFiles) {
  const TestFolder folder;
  const auto file = folder.write("lamp.ies",
                                 "IESNA:LM-63-2002\n[TEST] 1\nTILT=NONE\n1 1000 1 3 1 1 2 0 0 0\n1 1 50\n"
                                 "0 45 90\n0\n100 80\n0\n");
  const LightTable table = read_light_table(file, {});
  EXPECT_EQ(table.angle, (std::vector<double>{0, 45, 90}));
  EXPECT_EQ(table.intensity, (std::vector<double>{100, 80, 0}));
}

TEST(LightTable, RefusesWhatItCannotUse) {
  const TestFolder folder;
  for (const char* text : {"TILT=INCLUDE\n", "TILT=NONE\n1 1000 1 3 1 2 2 0 0 0\n1 1 50\n0 45 90\n0\n1 1 1\n",
                           "TILT=NONE\n1 1000 1 3 1 1 2 0 0 0\n1 1 50\n0 45\n",
                           "TILT=NONE\n1 1000 1 2 2 1 2 0 0 0\n1 1 50\n0 90\n0 90\n9 1\n1 1\n"})
    EXPECT_THROW(read_light_table(folder.write("lamp.ies", text), {}), InputError);
  EXPECT_THROW(read_light_table(folder.write("lamp.csv", "0, 1\n0, 2\n"), {}), InputError);
}

}  // namespace
}  // namespace etendue
