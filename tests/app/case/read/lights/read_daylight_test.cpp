// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/read/lights/read_daylight.h"

#include <gtest/gtest.h>

#include <cmath>

#include "solver/observe/color/photometry.h"
#include "tests/app/case/case_text.h"

namespace etendue::read_daylight_test {
namespace {

const std::string seen = "[bands]\nnames = [\"a\", \"b\"]\nedges = [400, 550, 700]\n";
const std::string sky = "[[light]]\nname = \"sky\"\nkind = \"sky\"\n";
const std::string sun = "[[light]]\nname = \"sun\"\nkind = \"sun\"\n";
const std::string south = "sun_position = { altitude = 30, azimuth = 180 }\n";

TEST(ReadDaylight, SetsTheSunByItsAngles) {
  const Case input = case_of(cube + sun + south + "irradiance = 1\n");
  const Vec3 from_south(0, std::sqrt(0.75), -0.5);
  EXPECT_LT((input.lights.at(0).direction - from_south).norm(), 1e-12);
  const Case turned = case_of(
      cube + sun + "sun_position = { altitude = 30, azimuth = 90, north = [2, 0, 0] }\nirradiance = 1\n");
  EXPECT_LT((turned.lights.at(0).direction - from_south).norm(), 1e-12) << "east is -y where north is x";
}

// Reda and Andreas 2004, table A5.1: zenith angle 50.1116, azimuth 194.3402 degrees.
TEST(ReadDaylight, SetsTheSunByDateTimeAndPlace) {
  const Case input =
      case_of(cube + sun +
              "irradiance = 1\nsun_position = { date = \"2003-10-17\", time = \"12:30:30\", latitude = "
              "39.742476, longitude = -105.1786, time_zone = -7 }\n");
  const Vec3& travels = input.lights.at(0).direction;
  EXPECT_NEAR(std::acos(-travels.z()) * 180 / M_PI, 50.1116, 0.01);
  EXPECT_NEAR(std::atan2(-travels.x(), -travels.y()) * 180 / M_PI + 360, 194.3402, 0.01);
  EXPECT_EQ(input.lights[0].note, "sun at altitude 39.89, azimuth 194.34 degrees");
}

TEST(ReadDaylight, MakesATableOfACieSky) {
  const Case input = case_of(cube + seen + sky + south + "cie_type = 12\nluminance = 5000\n");
  const LightCase& light = input.lights.at(0);
  EXPECT_EQ(light.intensity.at(0), 1) << "the zenith";
  // The part 60 degrees from the zenith in the south is the sun. As much to the north, 120 degrees from it,
  // the standard has 1.7257 for the gradation and 1.0413/1.4548 for the indicatrix.
  const std::size_t at_60 = 30, angles = light.angle.size();
  EXPECT_GT(light.intensity.at(60 * angles + at_60), 5);
  EXPECT_NEAR(light.intensity.at(at_60), 1.7257 * 1.0413 / 1.4548, 1e-3);
  EXPECT_EQ(light.plane.at(60), 180);
  EXPECT_NEAR(Photometry(input.bands).luminous(values_of(light.strength)), 5000, 1e-9);
  EXPECT_TRUE(std::holds_alternative<RadianceOfLight>(light.strength));
}

TEST(ReadDaylight, TakesTwoIrradiancesForASkyOfPerez) {
  const std::string perez = "direct_normal_irradiance = 800\ndiffuse_horizontal_irradiance = 100\n";
  const Case one = case_of(cube + "[units]\nlength = \"cm\"\n" + sky + south + perez);
  EXPECT_TRUE(std::holds_alternative<IrradianceOfLight>(one.lights.at(0).strength));
  EXPECT_NEAR(values_of(one.lights[0].strength).at(0), 0.01, 1e-12) << "W/cm^2";
  EXPECT_TRUE(
      one.lights[0].note.starts_with("Perez, clearness 4.644, brightness 0.1458, 146.1 lm/W, sun at"));
  const Case given = case_of(cube + seen + sky + south + perez + "illuminance = 12000\n");
  EXPECT_NEAR(Photometry(given.bands).luminous(values_of(given.lights.at(0).strength)), 12000, 1e-9);
  EXPECT_NE(faults_of(cube + "[bands]\nnames = [\"a\"]\nedges = [900, 1000]\n" + sky + south + perez)
                .find("a light of kind sky needs radiance or luminance or irradiance or illuminance; add one "
                      "of them"),
            std::string::npos);
}

// The diffuse irradiance is of all wavelengths: in bands that the eye sees it has the lumens of Perez et al.
// 1990, here 141.88 + 2 * 1.90 - 53.24 cos 60 - 14.03 ln 0.14578 = 146.07 lm/W (clearness 4.644). Taken for
// light of the one band from 380 to 780 nm, it had 182 lm/W.
TEST(ReadDaylight, GivesASkyOfPerezTheIlluminanceOfItsEfficacy) {
  const std::string perez = "direct_normal_irradiance = 800\ndiffuse_horizontal_irradiance = 100\n";
  const std::string one = "[bands]\nnames = [\"a\"]\nedges = [380, 780]\n";
  for (const std::string& bands : {seen, one}) {
    const Case input = case_of(cube + bands + sky + south + perez);
    EXPECT_TRUE(std::holds_alternative<IrradianceOfLight>(input.lights.at(0).strength));
    EXPECT_NEAR(Photometry(input.bands).luminous(values_of(input.lights[0].strength)), 14607, 1);
  }
}

TEST(ReadDaylight, SaysWhatIsWrong) {
  const auto fault = [](const std::string& text) {
    const std::string faults = faults_of(cube + text);
    const std::size_t start = faults.find(": ", faults.find(':') + 4);
    return faults.substr(std::min(faults.size(), start + 2));
  };
  EXPECT_EQ(fault(sun + "irradiance = 1\n"),
            "a light of kind sun needs direction or sun_position; add one of them");
  EXPECT_EQ(fault(sun + "direction = [0, 0, -1]\n"),
            "a light of kind sun needs irradiance or illuminance; add one of them");
  EXPECT_EQ(fault(sky + "radiance = 1\ncie_type = 12\n"), "is brighter towards the sun; add sun_position");
  EXPECT_EQ(fault(sky + "radiance = 1\ncie_type = 16\n"), "out of range; use an integer from 1 to 15");
  EXPECT_EQ(fault(sky + "radiance = 1\n" + south),
            "unused (only a CIE sky or a sky of Perez depends on the sun); remove it");
  EXPECT_EQ(fault(sky + "radiance = 1\nirradiance = 2\n"), "unused (`radiance` is given); remove it");
  EXPECT_EQ(fault(sky + south + "radiance = 1\ndirect_normal_irradiance = 2\n"),
            "a sky of Perez needs two irradiances; add diffuse_horizontal_irradiance");
  // Hardly any sun, high up, and hardly any sky: no such skies were measured.
  EXPECT_TRUE(fault(sky + "sun_position = { altitude = 65, azimuth = 0 }\ndirect_normal_irradiance = "
                          "100\ndiffuse_horizontal_irradiance = 30\n")
                  .starts_with("gives a sky of clearness 4.068 and brightness 0.024"));
  const auto place = [&](const std::string& date, const std::string& time) {
    return fault(sun + "irradiance = 1\nsun_position = { date = \"" + date + "\", time = \"" + time +
                 "\", latitude = 50, longitude = 0, time_zone = 0 }\n");
  };
  EXPECT_EQ(place("2023-02-29", "12:00"),
            "is no date from 1950 to 2050; give \"year-month-day\", e.g. \"2026-06-21\"");
  EXPECT_EQ(place("2024-02-29", "24:00"),
            "is no time of the day; give \"hours:minutes\" from \"00:00\" to \"23:59\"");
  EXPECT_TRUE(place("2024-12-21", "03:00").starts_with("has the sun below the horizon (altitude -"));
  EXPECT_EQ(fault(sun + "irradiance = 1\nsun_position = { date = \"2024-12-21\" }\n"),
            "needs altitude and azimuth, or date, time, latitude, longitude and time_zone; add time");
}

// 1000 cd/m^2 of a disc in a case in millimetres and milliwatts.
TEST(ReadLight, KnowsLuminanceAndIlluminanceInUnitsOfTheCase) {
  const std::string units = "[units]\nlength = \"mm\"\npower = \"mW\"\n";
  const Case input =
      case_of(cube + units + seen +
              "[[light]]\nname = \"a\"\nkind = \"disc\"\nposition = [0.5, 0.5, 0.9]\ndirection = [0, 0, "
              "-1]\nradius = 0.1\nluminance = 1000\n");
  // lm/(m^2 sr) over lm/W is W/(m^2 sr): 1e3 mW and 1e6 mm^2.
  EXPECT_NEAR(Photometry(input.bands).luminous(values_of(input.lights.at(0).strength)) * 1e-3 * 1e6, 1000,
              1e-9);
  EXPECT_NE(faults_of(cube + "[units]\nlength = \"ft\"\n" + seen + sun +
                      "direction = [0, 0, -1]\nilluminance = 1000\n")
                .find("needs units.length of m, cm, mm or km, not \"ft\""),
            std::string::npos);
}

}  // namespace
}  // namespace etendue::read_daylight_test
