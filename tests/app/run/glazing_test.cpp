// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/materials/surfaces/glazing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/app/readings/sensor_table.h"
#include "tests/app/run/box_case.h"
#include "tests/app/run/csv_table.h"
#include "tests/app/run/small_case.h"

namespace etendue::glazing_test {
namespace {

using std::numbers::pi;
using test::box_case;
using test::CaseFolder;
using test::CsvTable;
using test::etendue_says;
using test::Outcome;
using test::rows_of;
using test::text_of;

/// A black box under a glazed roof.
std::string atrium(const std::string& more) {
  return box_case({.size = "[2, 1, 1]",
                   .edge_length = 0.5,
                   .walls = "zmax = \"roof\"",
                   .bands = "names = [\"light\"]\nedges = [500, 600]"},
                  "[walls.roof]\nglazing = { transmittance = 0.8 }\n[walls.\"*\"]\n" + more);
}

const std::string even_sky = "[[light]]\nkind = \"sky\"\nname = \"sky\"\nradiance = 2\nwalls = [\"roof\"]\n";

double of_wall(const CaseFolder& folder, const std::string& wall, const std::string& column) {
  return CsvTable(text_of(folder.path() / "results" / "walls.csv")).number({wall}, column);
}

/// 2 times the integral of T(mu) mu dmu, by the midpoint rule in the angle.
double diffuse_transmittance(const Glazing& glass) {
  double sum = 0;
  constexpr int steps = 20000;
  for (int i = 0; i < steps; ++i) {
    const double angle = (i + 0.5) * pi / 2 / steps;
    sum += pi / steps * glass.transmittance(std::cos(angle)) * std::sin(angle) * std::cos(angle);
  }
  return sum;
}

// A roof of area A lets in pi L A times its diffuse transmittance of an even sky of radiance L: by rays, by
// directions and by photons.
TEST(Glazing, LetsInTheDiffuseTransmittanceOfAnEvenSky) {
  const double known = pi * 2 * 2 * diffuse_transmittance(Glazing(0.8));
  const CaseFolder rays(atrium(even_sky)), directions(atrium(even_sky + "uncollided = false\n")),
      photons(atrium(even_sky + "[solve]\nmethod = \"photons\"\nphotons = 1e5\n"));
  for (const CaseFolder* folder : {&rays, &directions, &photons}) {
    const Outcome run = etendue_says({"run", folder->file()});
    ASSERT_EQ(run.code, ExitCode::done) << run.err << run.out;
    EXPECT_NEAR(of_wall(*folder, "roof", "outgoing") / known, 1, 2e-3);
  }
}

// The sun at 60 degrees: E cos T on the floor below, by rays and photons.
TEST(Glazing, LetsTheSunInByItsAngle) {
  const std::string sun =
      "[[light]]\nkind = \"sun\"\nname = \"sun\"\nirradiance = 3\nwalls = [\"roof\"]\n"
      "direction = [0, -0.8660254037844386, -0.5]\n";
  const std::string floor = "[[sensor]]\nname = \"floor\"\nposition = [1, 0.1, 0.99]\nnormal = [0, 0, 1]\n";
  const CaseFolder folder(atrium(sun + floor)),
      photons(atrium(sun + "[solve]\nmethod = \"photons\"\nphotons = 1e5\n"));
  const Outcome run = etendue_says({"run", folder.file()});
  ASSERT_EQ(run.code, ExitCode::done) << run.err;
  auto rows = rows_of(text_of(folder.path() / "results" / "sensors.csv"));
  const double known = 3 * 0.5 * Glazing(0.8).transmittance(0.5);
  EXPECT_NEAR(rows["floor light irradiance W/m^2"].at(2), known, 1e-9);
  EXPECT_NEAR(of_wall(folder, "roof", "outgoing"), 2 * known, 1e-6);
  ASSERT_EQ(etendue_says({"run", photons.file()}).code, ExitCode::done);
  for (const std::string wall : {"ymin", "zmin"})
    EXPECT_NEAR(of_wall(photons, wall, "incoming"), of_wall(folder, wall, "incoming"), 0.02 * known) << wall;
}

// Suns and skies are told as they are before the glass, and not left out.
TEST(Glazing, LeavesWhatSunsAndSkiesAreToldToSend) {
  const CaseFolder folder(
      atrium(even_sky + "[[light]]\nname = \"sun\"\nkind = \"sun\"\nirradiance = 3\nwalls = [\"roof\"]\n"
                        "sun_position = { altitude = 30, azimuth = 180 }\n"));
  const Outcome run = etendue_says({"run", folder.file()});
  ASSERT_EQ(run.code, ExitCode::done) << run.err;
  EXPECT_NE(run.out.find("sky: 6.283 W/m^2, "), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("sun: 1.5 W/m^2, "), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("lx on a level plane; sun at altitude 30.00, azimuth 180.00 degrees"),
            std::string::npos)
      << run.out;
  EXPECT_NE(text_of(folder.path() / "results" / "summary.json").find("\"daylight\""), std::string::npos);
}

// The daylight factor under the roof: the integral of L T cos cos'/r^2 over the roof, over pi L.
TEST(Glazing, AttenuatesDaylightFactors) {
  const CaseFolder folder(atrium(even_sky +
                                 "[[sensor]]\nname = \"desk\"\nposition = [1, 0.5, 0.2]\nnormal = [0, 0, "
                                 "1]\ndaylight_factor = true\n"));
  const Outcome run = etendue_says({"run", folder.file()});
  ASSERT_EQ(run.code, ExitCode::done) << run.err;
  auto rows = rows_of(text_of(folder.path() / "results" / "sensors.csv"));
  const Glazing glass(0.8);
  constexpr int steps = 400;
  double sum = 0;
  for (int i = 0; i < steps; ++i)
    for (int j = 0; j < steps; ++j) {
      const double x = 2 * (i + 0.5) / steps - 1, y = (j + 0.5) / steps - 0.5, z = 0.8;
      const double square = x * x + y * y + z * z, cosine = z / std::sqrt(square);
      sum += 2.0 / (steps * steps) * cosine * cosine / square * glass.transmittance(cosine);
    }
  EXPECT_NEAR(rows["desk light daylight_factor %"].at(2), 100 * sum / pi, 0.1);
}

// Radiosity knows no beams: it says so once, not for every part of the sky.
TEST(Glazing, IsRefusedByRadiosityInOneLine) {
  const CaseFolder folder(atrium(even_sky + "[solve]\nmethod = \"radiosity\"\n"));
  const Outcome refused = etendue_says({"run", folder.file()});
  EXPECT_EQ(refused.code, ExitCode::input_error);
  EXPECT_NE(refused.err.find("is a light that is no wall"), std::string::npos) << refused.err;
  EXPECT_EQ(std::count(refused.err.begin(), refused.err.end(), '\n'), 1) << refused.err;
}

// Glazing in a body inside of the room lets nothing in.
TEST(Glazing, IsRefusedInWallsThatAreNotOuterOnes) {
  std::string text = atrium(even_sky + "[walls.panel]\nglazing = { transmittance = 0.5 }\n");
  text.replace(text.find("[bands]"), 7,
               "[[mesh.sheet]]\ncorners = [[0.5, 0.5, 0.5], [1, 0.5, 0.5], [1, 0.8, 0.5]]\nfront = "
               "\"panel\"\n[bands]");
  const CaseFolder folder(text);
  const Outcome refused = etendue_says({"check", "--mesh", folder.file()});
  EXPECT_EQ(refused.code, ExitCode::input_error);
  EXPECT_NE(refused.err.find("glazing in a wall that is no outer one"), std::string::npos) << refused.err;
}

TEST(Glazing, StandsInOuterWallsThatDoNothingElse) {
  const auto faults = [](const std::string& from, const std::string& to) {
    std::string text = atrium(even_sky);
    text.replace(text.find(from), from.size(), to);
    const CaseFolder folder(text);
    return etendue_says({"check", folder.file()}).err;
  };
  const std::string glazing = "glazing = { transmittance = 0.8 }";
  EXPECT_NE(faults(glazing, glazing + "\nspecular = 0.1").find("beside glazing; remove one of them"),
            std::string::npos);
  EXPECT_NE(faults(glazing, "glazing = { transmittance = 0.95 }")
                .find("exceeds 0.916881, that of panes that absorb nothing (1 of refractive index 1.526)"),
            std::string::npos)
      << faults(glazing, "glazing = { transmittance = 0.95 }");
  EXPECT_NE(faults("kind = \"sky\"", "kind = \"wall\"").find("use kind \"sky\""), std::string::npos);
}

}  // namespace
}  // namespace etendue::glazing_test
