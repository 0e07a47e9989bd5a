// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/read/read_sensor.h"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/app/case/case_text.h"

namespace etendue::read_sensor_test {
namespace {

const std::string sensor = cube + "[[sensor]]\nname = \"desk\"\n";

TEST(ReadSensor, MeasuresIrradianceUnlessItSaysOtherwise) {
  const Case input = case_of(sensor + "position = [0.5, 0.5, 0]\nnormal = [0, 0, 2]\n");
  ASSERT_EQ(input.sensors.size(), 1U);
  const Sensor& desk = input.sensors[0].sensor;
  EXPECT_EQ(input.sensors[0].name, "desk");
  EXPECT_EQ(desk.kind, SensorKind::irradiance);
  EXPECT_EQ(desk.position, Vec3(0.5, 0.5, 0));
  EXPECT_EQ(desk.direction, Vec3(0, 0, 1));
  EXPECT_EQ(desk.rays, 2000);
}

TEST(ReadSensor, TakesEachKind) {
  const std::string place = "position = [0.5, 0.5, 0.5]\n";
  const auto read = [](const std::string& text) { return case_of(sensor + text).sensors.at(0); };
  EXPECT_EQ(read("kind = \"fluence\"\n" + place).sensor.kind, SensorKind::fluence);
  EXPECT_EQ(read("kind = \"radiance\"\ndirection = [3, 0, 0]\n" + place).sensor.direction, Vec3(1, 0, 0));
  EXPECT_NEAR(read("kind = \"cone\"\ndirection = [1, 0, 0]\nangle = 30\n" + place).sensor.half_angle,
              std::numbers::pi / 6, 1e-15);
  const Sensor grid =
      read("kind = \"grid\"\nalong = [1, 0, 0]\nacross = [0, 1, 0]\nparts = [8, 6]\n" + place).sensor;
  EXPECT_EQ(grid.direction, Vec3(0, 0, 1));
  EXPECT_EQ(grid.count, (std::array<int, 2>{8, 6}));
  const Sensor flux =
      read("kind = \"flux\"\npolygon = [[0, 0, 0.5], [1, 0, 0.5], [1, 1, 0.5]]\nparts = [3]\n").sensor;
  EXPECT_EQ(flux.polygon.size(), 3U);
  EXPECT_EQ(flux.count[0], 3);
  EXPECT_EQ(flux.half_angle, 0);
  const SensorCase surface = read("kind = \"flux\"\nregion = \"air\"\nbeyond = \"xmin\"\n");
  EXPECT_EQ(surface.region, "air");
  EXPECT_EQ(surface.beyond, "xmin");
  const SensorCase intensity = read("kind = \"intensity\"\nwall = \"xmin\"\n");
  EXPECT_EQ(intensity.wall, "xmin");
  EXPECT_EQ(intensity.sensor.count, (std::array<int, 2>{24, 19}));
  const SensorCase region = read("kind = \"region\"\nregion = \"air\"\ndirection = [0, 0, 2]\nangle = 60\n");
  EXPECT_EQ(region.region, "air");
  EXPECT_EQ(region.sensor.direction, Vec3(0, 0, 1));
  EXPECT_NEAR(region.sensor.half_angle, std::numbers::pi / 3, 1e-15);
}

// Light from outside has neither beams nor radiance along rays then: the irradiance was 0 under a sun. The
// cell of a point is seen.
TEST(ReadSensor, IsRefusedBesideLightsThatItDoesNotSee) {
  const auto refused = [](const std::string& light, const std::string& keys) {
    return faults_of(cube + "[[light]]\nname = \"lamp\"\nuncollided = false\n" + light +
                     "[[sensor]]\nname = \"desk\"\n" + keys)
               .find("the sensor \"desk\" does not see the light \"lamp\"") != std::string::npos;
  };
  const std::string sun = "kind = \"sun\"\ndirection = [0, 0, -1]\nirradiance = 1\n",
                    point = "kind = \"point\"\nposition = [0.5, 0.5, 0.5]\npower = 1\n",
                    even_sky = "kind = \"sky\"\nradiance = 1\nwalls = [\"zmax\"]\n",
                    clear_sky = even_sky + "cie_type = 1\n";
  const std::string desk = "position = [0.5, 0.5, 0]\nnormal = [0, 0, 1]\n";
  EXPECT_TRUE(refused(sun, desk));
  EXPECT_TRUE(refused(clear_sky, desk));
  EXPECT_TRUE(refused(even_sky + "[walls.zmax]\nglazing = { transmittance = 0.8 }\n", desk));
  EXPECT_FALSE(refused(point, desk));
  EXPECT_FALSE(refused(even_sky, desk));
  EXPECT_FALSE(refused(sun, "kind = \"region\"\nregion = \"air\"\n"));
  EXPECT_FALSE(refused(sun, "kind = \"flux\"\nregion = \"air\"\n"));
}

TEST(ReadSensor, TakesGlare) {
  const std::string seen = "kind = \"glare\"\nposition = [0.5, 0.5, 0.5]\ndirection = [2, 0, 0]\n";
  const std::string eye = sensor + seen, colors = "[bands]\nnames = [\"red\", \"green\", \"blue\"]\n";
  const Sensor glare = case_of(eye + colors).sensors.at(0).sensor;
  EXPECT_EQ(glare.direction, Vec3(1, 0, 0));
  EXPECT_EQ(glare.count[0], 360);
  EXPECT_EQ(glare.glare_threshold, 2000);
  EXPECT_EQ(glare.glare_sources, GlareSources::threshold);
  const Sensor lights =
      case_of(eye + "sources = \"lights\"\nparts = [90]\nthreshold = 5\nup = [0, 1, 0]\n" + colors)
          .sensors.at(0)
          .sensor;
  EXPECT_EQ(lights.glare_sources, GlareSources::lights);
  EXPECT_EQ(lights.count[0], 90);
  EXPECT_EQ(lights.up, Vec3(0, 1, 0));
  EXPECT_NE(faults_of(eye + "up = [1, 0, 0]\n" + colors).find("points along the view"), std::string::npos);
}

// The resolved case is read again by render and by runs that go on.
TEST(ReadSensor, ReadsItsResolvedCase) {
  const std::string grid = "kind = \"grid\"\nposition = [0, 0, 0]\nalong = [1, 0, 0]\nacross = [0, 1, 0]\n";
  const Case input = case_of(sensor + grid);
  const Case again = case_of(input.resolved_toml);
  EXPECT_EQ(again.sensors.at(0).sensor.count, input.sensors.at(0).sensor.count);
}

TEST(ReadSensor, NamesWhatIsMissing) {
  EXPECT_EQ(faults_of(sensor),
            "slab.toml:7: sensor[0].position: missing; use a point of the domain\n"
            "slab.toml:7: sensor[0].normal: missing; use a vector to the side where light is measured");
  EXPECT_EQ(
      faults_of(sensor + "kind = \"flux\"\n"),
      "slab.toml:7: sensor[0].polygon: missing; use a list of corners, or the name of a wall or region");
  EXPECT_EQ(faults_of(sensor + "kind = \"cone\"\nposition = [0, 0, 0]\ndirection = [1, 0, 0]\n"),
            "slab.toml:7: sensor[0].angle: missing; use the half angle of the cone in degrees");
}

TEST(ReadSensor, RefusesWhatItsKindDoesNotTake) {
  EXPECT_EQ(
      faults_of(sensor + "kind = \"fluence\"\nposition = [0, 0, 0]\nnormal = [1, 0, 0]\n"),
      "slab.toml:11: sensor[0].normal = [1, 0, 0]: unused (a sensor of kind \"fluence\" does not take it); "
      "remove it");
}

TEST(ReadSensor, AFluxGoesThroughOneThing) {
  EXPECT_EQ(
      faults_of(sensor + "kind = \"flux\"\nwall = \"xmin\"\nregion = \"air\"\n"),
      "slab.toml:11: sensor[0].region = \"air\": beside another (a flux goes through one thing); use one "
      "of polygon, wall and region");
  EXPECT_EQ(
      faults_of(sensor + "kind = \"flux\"\nwall = \"xmin\"\nbeyond = \"air\"\n"),
      "slab.toml:11: sensor[0].beyond = \"air\": unused (only the surface of a region has another side); "
      "remove it");
  EXPECT_EQ(
      faults_of(sensor + "kind = \"flux\"\nregion = \"air\"\nparts = [2]\n"),
      "slab.toml:11: sensor[0].parts = [2]: unused (through the surface of a region the faces of the mesh "
      "are summed up); remove it");
}

TEST(ReadSensor, RefusesPolygonsThatHaveNoInside) {
  const std::string flux = sensor + "kind = \"flux\"\npolygon = ";
  EXPECT_EQ(
      faults_of(flux + "[[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0.1]]\n"),
      "slab.toml:10: sensor[0].polygon = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0.1]]: is not flat; use "
      "corners in one plane");
  EXPECT_EQ(
      faults_of(flux + "[[0, 0, 0], [1, 0, 0], [0, 2, 0], [2, 2, 0]]\n"),
      "slab.toml:10: sensor[0].polygon = [[0, 0, 0], [1, 0, 0], [0, 2, 0], [2, 2, 0]]: has sides that meet "
      "elsewhere than at their common corner; use several sensors");
  EXPECT_EQ(
      faults_of(flux + "[[0, 0, 0], [2, 0, 0], [2, 1, 0], [1, 0, 0], [0, 1, 0]]\n"),
      "slab.toml:10: sensor[0].polygon = [[0, 0, 0], [2, 0, 0], [2, 1, 0], [1, 0, 0], [0, 1, 0]]: has sides "
      "that meet elsewhere than at their common corner; use several sensors");
  EXPECT_EQ(faults_of(flux + "[[0, 0, 0], [1, 0, 0], [0.2, 0.2, 0], [0, 1, 0]]\n"), "");
  EXPECT_EQ(
      faults_of(flux + "[[0, 0, 0], [1, 0, 0], [2, 0, 0]]\n"),
      "slab.toml:10: sensor[0].polygon = [[0, 0, 0], [1, 0, 0], [2, 0, 0]]: has no area; use corners that "
      "span one");
}

TEST(ReadSensor, NeedsNamesThatDiffer) {
  const std::string one = "[[sensor]]\nname = \"a\"\nkind = \"fluence\"\nposition = [0, 0, 0]\n";
  EXPECT_EQ(faults_of(cube + one + one),
            "slab.toml:12: sensor[1].name = \"a\": another sensor has this name; give each its own");
}

TEST(ReadSensor, UnitsOfPhotometryAreKnownOnes) {
  EXPECT_EQ(case_of(cube + "[units]\nilluminance = \"fc\"\nluminance = \"lambert\"\n").units.luminance,
            "lambert");
  EXPECT_EQ(
      faults_of(cube + "[units]\nilluminance = \"candela\"\n"),
      "slab.toml:8: units.illuminance = \"candela\": is not known; use \"lx\", \"lux\", \"ph\", \"phot\", "
      "\"fc\" or \"footcandle\"");
}

}  // namespace
}  // namespace etendue::read_sensor_test
