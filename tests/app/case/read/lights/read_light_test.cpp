// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/read/lights/read_light.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "app/case/lamps/light_table.h"
#include "solver/observe/color/photometry.h"
#include "tests/app/case/case_text.h"

namespace etendue::read_light_test {
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
  EXPECT_EQ(values_of(input.lights[1].strength), std::vector<double>{7});
}

TEST(ReadLight, TakesTheBeamOfAWallForASun) {
  const Case input = case_of(cube + "[walls.zmax]\nbeam = { direction = [0, 0, -3], irradiance = 2 }\n");
  ASSERT_EQ(input.lights.size(), 1U);
  EXPECT_EQ(input.lights[0].kind, LightKind::sun);
  EXPECT_EQ(input.lights[0].walls, std::vector<std::string>{"zmax"});
}

TEST(ReadLight, MayBeLeftToTheDirections) {
  const Case input = case_of(cube + "[walls.zmax]\nbeam = { direction = [0, 0, -3], irradiance = 2 }\n" +
                             "uncollided = false\n[[light]]\nname = \"bulb\"\nkind = \"point\"\n" +
                             "position = [0, 0, 0]\npower = 1\nuncollided = false\n");
  ASSERT_EQ(input.lights.size(), 2U);
  for (const LightCase& light : input.lights) EXPECT_EQ(light.uncollided, Uncollided::no) << light.name;
}

TEST(ReadLight, AsksForWhatAKindNeeds) {
  EXPECT_EQ(faults_of(cube + "[[light]]\nname = \"bulb\"\nkind = \"point\"\nposition = [0, 0, 0]\n"),
            "slab.toml:7: light[0]: a light of kind point needs power or luminous_flux; add one of them");
  EXPECT_EQ(faults_of(cube + "[[light]]\nname = \"a\"\nkind = \"sky\"\nradiance = 1\nangle = 3\n"),
            "slab.toml:11: light[0].angle = 3: unused (it is no key of the kind sky); remove it");
  EXPECT_EQ(
      faults_of(cube + "[[light]]\nname = \"a\"\nkind = \"wall\"\nradiance = 1\nwalls = [\"zmx\"]\n"),
      "slab.toml:7: light[0].walls: no wall can be called \"zmx\" (did you mean \"zmax\"?); there can be "
      "xmax, xmin, ymax, ymin, zmax, zmin");
}

const std::string bulb = "[[light]]\nname = \"bulb\"\nkind = \"point\"\nposition = [0.5, 0.5, 0.9]\n";

/// Bands of 1 nm with their middles from 380 to 780 nm.
std::string fine_bands() {
  std::string names = "names = [", edges = "edges = [379.5";
  for (int nm = 380; nm <= 780; ++nm) {
    names += "\"" + std::to_string(nm) + "\", ";
    edges += ", " + std::to_string(nm) + ".5";
  }
  return "[bands]\n" + names + "]\n" + edges + "]\n";
}

// Luminous efficacies of black bodies from 380 to 780 nm: validation/reference/luminous_efficacy.csv.
TEST(ReadLight, DividesLumensAmongTheBandsOfABlackBody) {
  const struct {
    int kelvin;
    double lumens_per_watt;
  } bodies[] = {{2000, 95.549}, {2856, 155.807}, {6500, 195.191}};
  for (const auto& body : bodies) {
    const Case input = case_of(cube + fine_bands() + bulb + "luminous_flux = 800\ncolor_temperature = " +
                               std::to_string(body.kelvin) + "\n");
    const std::vector<double>& power = values_of(input.lights.at(0).strength);
    EXPECT_NEAR(800 / std::accumulate(power.begin(), power.end(), 0.0), body.lumens_per_watt,
                2e-4 * body.lumens_per_watt);
    EXPECT_NEAR(Photometry(input.bands).luminous(power), 800, 1e-9);
  }
}

TEST(ReadLight, DividesLumensEvenlyWithoutAColorTemperature) {
  const std::string flux = bulb + "luminous_flux = 683\n";
  const Case primaries = case_of(cube + "[bands]\nnames = [\"red\", \"green\", \"blue\"]\n" + flux);
  for (const double power : values_of(primaries.lights.at(0).strength)) EXPECT_NEAR(power, 1, 1e-12);
  const Case two = case_of(
      cube + "[units]\npower = \"mW\"\n[bands]\nnames = [\"a\", \"b\"]\nedges = [500, 600, 620]\n" + flux);
  const std::vector<double>& power = values_of(two.lights.at(0).strength);
  EXPECT_NEAR(power.at(0), 5 * power.at(1), 1e-9);
  EXPECT_NEAR(Photometry(two.bands).luminous(power), 683e3, 1e-6);
}

TEST(ReadLight, RefusesLumensThatItCannotConvert) {
  const std::string flux = bulb + "luminous_flux = 800\n",
                    seen = "[bands]\nnames = [\"a\"]\nedges = [380, 780]\n";
  EXPECT_EQ(faults_of(cube + flux),
            "slab.toml:11: light[0].luminous_flux = 800: lumens need bands whose wavelengths are known; give "
            "bands.edges, e.g. [380, 780] for one band, or give the power");
  EXPECT_EQ(
      faults_of(cube + "[units]\npower = \"1/s\"\n" + seen + flux),
      "slab.toml:16: light[0].luminous_flux = 800: lumens cannot be converted to units.power = \"1/s\"; use "
      "W or mW, or give the power");
  EXPECT_EQ(
      faults_of(cube + "[bands]\nnames = [\"a\"]\nedges = [900, 1000]\n" + flux),
      "slab.toml:14: light[0].luminous_flux = 800: the eye sees none of the bands; use bands.edges between "
      "360 and 830 nm, or give the power");
  EXPECT_EQ(faults_of(cube + seen + flux + "power = 3\n"),
            "slab.toml:14: light[0].luminous_flux = 800: unused (`power` is given for each band); remove it");
  EXPECT_EQ(faults_of(cube + "[bands]\nnames = [\"red\", \"green\", \"blue\"]\n" + flux +
                      "color_temperature = 2700\n"),
            "slab.toml:14: light[0].color_temperature = 2700: divides the light among the bands by their "
            "wavelengths, "
            "which are not known; give bands.edges");
}

// A lamp of 100 cd in all directions, with a multiplier of 2 and ballast factors 0.9 and 0.5: 4 pi 90 lm.
TEST(ReadLight, TakesTheLumensOfAnIesFile) {
  const TestFolder folder;
  const auto file = folder.write(
      "lamp.ies", "IESNA:LM-63-2002\nTILT=NONE\n1 -1 2 2 1 1 2 0 0 0\n0.9 0.5 50\n0 180\n0\n100 100\n");
  const std::string lamp = bulb + "distribution = \"" + file.string() + "\"\n";
  const std::string seen = "[bands]\nnames = [\"a\", \"b\"]\nedges = [450, 550, 650]\n";
  const Case input = case_of(cube + seen + lamp);
  EXPECT_TRUE(input.lights.at(0).keeps_intensity);
  EXPECT_NEAR(Photometry(input.bands).luminous(values_of(input.lights[0].strength)), 4 * M_PI * 90, 1e-9);
  const Case given = case_of(cube + seen + lamp + "luminous_flux = 500\n");
  EXPECT_FALSE(given.lights.at(0).keeps_intensity);
  EXPECT_NEAR(Photometry(given.bands).luminous(values_of(given.lights[0].strength)), 500, 1e-9);
  EXPECT_EQ(values_of(case_of(cube + lamp + "power = 3\n").lights.at(0).strength), std::vector<double>{3});
  EXPECT_TRUE(faults_of(cube + lamp)
                  .ends_with("is a lamp file with candelas, and lumens need bands whose wavelengths are "
                             "known; give bands.edges, e.g. [380, 780] for one band, or give the power"));
}

TEST(LightTable, ReadsIesFiles) {
  const TestFolder folder;
  const auto file = folder.write("lamp.ies",
                                 "IESNA:LM-63-2002\n[TEST] 1\nTILT=NONE\n1 1000 1 3 1 1 2 0 0 0\n1 1 50\n"
                                 "0 45 90\n0\n100 80\n0\n");
  const LightTable table = read_light_table(file);
  EXPECT_EQ(table.angle, (std::vector<double>{0, 45, 90}));
  EXPECT_EQ(table.intensity, (std::vector<double>{100, 80, 0}));
}

/// A lamp of this photometric type with three vertical and these horizontal angles, candelas 1, 2, 3 …
std::string ies(int type, const std::string& vertical, const std::vector<int>& horizontal) {
  std::string text = "IESNA:LM-63-1995\r\nTILT=NONE\r\n1, 1000, 1, 3, " + std::to_string(horizontal.size()) +
                     ", " + std::to_string(type) + ", 2, 0, 0, 0\r\n1 1 50\r\n" + vertical + "\r\n";
  for (const int angle : horizontal) text += std::to_string(angle) + " ";
  for (std::size_t i = 0; i < 3 * horizontal.size(); ++i) text += "\n" + std::to_string(i + 1);
  return text;
}

TEST(LightTable, AddsThePlanesOfSymmetricLamps) {
  const TestFolder folder;
  const auto read = [&](int type, const std::string& vertical, const std::vector<int>& horizontal) {
    return read_light_table(folder.write("lamp.ies", ies(type, vertical, horizontal)));
  };
  using Numbers = std::vector<double>;
  const LightTable quadrant = read(1, "0 45 90", {0, 30, 90});
  EXPECT_EQ(quadrant.plane, (Numbers{0, 30, 90, 150, 180, 210, 270, 330, 360}));
  EXPECT_EQ(quadrant.intensity,
            (Numbers{1, 2, 3, 4, 5, 6, 7, 8, 9, 4, 5, 6, 1, 2, 3, 4, 5, 6, 7, 8, 9, 4, 5, 6, 1, 2, 3}));
  EXPECT_EQ(read(1, "0 45 90", {0, 90, 180}).plane, (Numbers{0, 90, 180, 270, 360}));
  EXPECT_EQ(read(1, "0 45 90", {90, 180, 270}).plane, (Numbers{90, 180, 270, 360, 450}));
  EXPECT_EQ(read(1, "0 45 90", {0, 120, 240}).plane, (Numbers{0, 120, 240, 360}));
  EXPECT_EQ(read(1, "0 45 90", {0, 180, 360}).plane, (Numbers{0, 180, 360}));
  const LightTable floodlight = read(2, "-90 0 90", {0, 40, 90});
  EXPECT_EQ(floodlight.type, PhotometricType::b);
  EXPECT_EQ(floodlight.plane, (Numbers{-90, -40, 0, 40, 90}));
  EXPECT_EQ(floodlight.angle, (Numbers{0, 90, 180}));
  EXPECT_EQ(floodlight.intensity, (Numbers{7, 8, 9, 4, 5, 6, 1, 2, 3, 4, 5, 6, 7, 8, 9}));
  EXPECT_EQ(read(3, "-90 0 90", {-90, 0, 90}).type, PhotometricType::a);
}

TEST(LightTable, ReadsAnglesAndAzimuthsInAnyOrder) {
  const TestFolder folder;
  const auto read = [&](const std::string& text) { return read_light_table(folder.write("a.csv", text)); };
  const LightTable table = read("0, 180, 3\n0, 0, 1\n90, 0, 2\n90, 180, 4\n");
  EXPECT_EQ(table.angle, (std::vector<double>{0, 90}));
  EXPECT_EQ(table.plane, (std::vector<double>{0, 180, 360}));
  EXPECT_EQ(table.intensity, (std::vector<double>{1, 2, 3, 4, 1, 2}));
  EXPECT_THROW(read("0, 0, 1\n90, 0, 2\n90, 180, 4\n"), InputError);
  EXPECT_THROW(read("0, 0, 1\n0, 0, 2\n"), InputError);
  EXPECT_THROW(read("0, 90, 1\n90, 90, 2\n"), InputError);
}

TEST(LightTable, RefusesWhatItCannotUse) {
  const TestFolder folder;
  const auto refusal = [&](const std::string& text) {
    const auto file = folder.write("lamp.ies", text);
    try {
      read_light_table(file);
    } catch (const InputError& error) {
      const std::string message = error.what();
      return message.substr(message.find("lamp.ies"));
    }
    return std::string();
  };
  EXPECT_TRUE(
      refusal("IESNA91\nTILT=INCLUDE\n").starts_with("lamp.ies:2: ends before the lamp-to-luminaire"));
  EXPECT_TRUE(refusal("IESNA91\n").starts_with("lamp.ies:1: has no line TILT="));
  EXPECT_TRUE(refusal("TILT=NONE\n1 1000 1 3 1 4 2 0 0 0\n1 1 50\n0 45 90\n0\n1 1 1\n")
                  .starts_with("lamp.ies:2: 4 is no photometric type"));
  EXPECT_TRUE(refusal("TILT=NONE\n1 1000 1 3 1 1 2 0 0 0\n1 1 50\n0 45\n")
                  .starts_with("lamp.ies:4: ends before the vertical angles"));
  EXPECT_TRUE(refusal("TILT=NONE\n1 1000 1 2 1 1 2 0 0 0\n1 1 50\n0 9O\n0\n1 1\n")
                  .starts_with("lamp.ies:4: \"9O\" is not a number, where the vertical angles should stand"));
  EXPECT_TRUE(refusal("TILT=NONE\n1 1000 1 2 2 1 2 0 0 0\n1 1 50\n0 90\n0 70\n9 1\n1 1\n")
                  .starts_with("lamp.ies:7: horizontal angles of type C from 0 to 70"));
  EXPECT_TRUE(refusal("TILT=NONE\n1 1000 1 2 2 1 2 0 0 0\n1 1 50\n0 90\n0 90\n9 1\n1 -1\n")
                  .starts_with("lamp.ies:7: the intensity -1 is negative"));
  EXPECT_TRUE(refusal("TILT=NONE\n1 1000 1 2 2 2 2 0 0 0\n1 1 50\n0 90\n0 90\n9 1\n1 1\n")
                  .starts_with("lamp.ies:4: vertical angles of type A or B from 0 to 90"));
  EXPECT_THROW(read_light_table(folder.write("lamp.csv", "0, 1\n0, 2\n")), InputError);
}

}  // namespace
}  // namespace etendue::read_light_test
