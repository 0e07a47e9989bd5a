// SPDX-License-Identifier: AGPL-3.0-or-later
// Runs whose temperatures follow by iteration.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/app/run/csv_table.h"
#include "tests/app/run/small_case.h"

namespace etendue::temperatures_run_test {
namespace {

using test::CaseFolder;
using test::CsvTable;
using test::etendue_says;
using test::has;
using test::Outcome;
using test::text_of;

std::string cube_with(const std::string& rest) {
  return "[mesh]\nedge_length = 0.35\n[[mesh.box]]\nregion = \"gas\"\nmin = [0, 0, 0]\nmax = [1, 1, 1]\n"
         "[directions]\nset = \"product\"\norder = 2\n[output]\ndirectory = \"results\"\n" +
         rest;
}

TEST(TemperaturesRun, ConductNoHeatThroughASheet) {
  const CaseFolder folder(
      cube_with("[[mesh.sheet]]\nfront = \"plate\"\nmin = [0.5, 0, 0]\nmax = [0.5, 1, 1]\n"
                "[media.gas]\nabsorption = 0\nconductivity = 1\n[walls.\"*\"]\ndiffuse = 1\n"
                "[walls.xmin]\ntemperature = 300\n[walls.xmax]\ntemperature = 400\n"));
  const Outcome outcome = etendue_says({"run", folder.file()});
  ASSERT_EQ(outcome.code, ExitCode::done) << outcome.err << outcome.out;
  const CsvTable heat(text_of(folder.path() / "results" / "heat.csv"));
  EXPECT_NEAR(heat.number({"wall", "xmin"}, "conducted"), 0, 1e-3);
  EXPECT_NEAR(heat.number({"wall", "xmax"}, "conducted"), 0, 1e-3);
}

const std::string kOven =
    "[bands]\nnames = [\"short\", \"long\"]\nedges = [1, 4000, 1e9]\n"
    "[media.gas]\nabsorption = [0.2, 0.6]\nscattering = 0.2\ntemperature = 1200\n"
    "[walls.\"*\"]\nemissivity = [0.5, 0.8]\nheat_flux = 0\n"
    "[walls.zmin]\nemissivity = 0.9\ntemperature = 500\n"
    "[walls.zmax]\nemissivity = [0.3, 0.7]\nheat_flux = 2000\nconvection = { h = 40, ambient = 320 }\n";

TEST(TemperaturesRun, OfWallsCloseTheirHeat) {
  const CaseFolder folder(cube_with(kOven));
  const Outcome outcome = etendue_says({"run", folder.file(), "--set", "solve.tolerance=1e-9"});
  ASSERT_EQ(outcome.code, ExitCode::done) << outcome.err << outcome.out;
  EXPECT_TRUE(has(outcome.out, "carried away by convection")) << outcome.out;
  const CsvTable heat(text_of(folder.path() / "results" / "heat.csv"));
  const auto of = [&](const char* wall, const char* what) { return heat.number({"wall", wall}, what); };
  const double into_floor = of("zmin", "net");
  EXPECT_GT(into_floor, 1000);
  for (const char* wall : {"xmin", "xmax", "ymin", "ymax"}) {
    EXPECT_NEAR(of(wall, "net") / into_floor, 0, 1e-7) << wall;
    EXPECT_GT(of(wall, "temperature"), 500) << wall;
    EXPECT_LT(of(wall, "temperature"), 1200) << wall;
  }
  EXPECT_NEAR((of("zmax", "net") + 2000) / of("zmax", "convected"), 1, 1e-7);
  EXPECT_NEAR(of("zmax", "convected") / (40 * (of("zmax", "temperature") - 320)), 1, 1e-9);
}

// The light of the lamp is not swept before it meets a wall.
TEST(TemperaturesRun, OfWallsTakeTheLightOfLamps) {
  const CaseFolder folder(
      cube_with("[media.gas]\nabsorption = 0\n[walls.\"*\"]\nemissivity = 0.8\nheat_flux = 0\n"
                "[walls.zmin]\nemissivity = 1\nconvection = { h = 10, ambient = 300 }\n"
                "[[light]]\nname = \"lamp\"\nkind = \"point\"\nposition = [0.5, 0.5, 0.7]\npower = 700\n"));
  const Outcome outcome = etendue_says({"run", folder.file(), "--set", "solve.tolerance=1e-9"});
  ASSERT_EQ(outcome.code, ExitCode::done) << outcome.err << outcome.out;
  const CsvTable heat(text_of(folder.path() / "results" / "heat.csv"));
  EXPECT_NEAR(heat.number({"wall", "zmin"}, "convected") / 700, 1, 1e-5);
  EXPECT_NEAR(heat.number({"wall", "zmin"}, "temperature"), 370, 1e-3);
}

// Glass as warm as all about it has n^2 times the light of a void, behind smooth faces and black ones.
TEST(TemperaturesRun, FillGlassWithMoreLight) {
  for (const char* wall :
       {"refractive_index = 1.5\ntemperature = 900\n",
        "refractive_index = 1.5\ntemperature = 900\nconvection = { h = 5, ambient = 900 }\n",
        "emissivity = 0.7\ntemperature = 900\n", "emissivity = 0.7\nheat_flux = 0\n"})
    for (const char* glass : {"temperature = 900\n", "heat_source = 0\n", "conductivity = 1\n"}) {
      if (std::string(glass) != "temperature = 900\n" && has(wall, "heat_flux")) continue;  // nothing is warm
      const CaseFolder folder(
          cube_with("[media.gas]\nabsorption = 2\nscattering = 0.5\nrefractive_index = 1.5\n" +
                    std::string(glass) + "[walls.\"*\"]\n" + wall));
      const Outcome outcome = etendue_says({"run", folder.file(), "--set", "solve.tolerance=1e-9"});
      ASSERT_EQ(outcome.code, ExitCode::done) << wall << glass << outcome.err << outcome.out;
      const CsvTable regions(text_of(folder.path() / "results" / "regions.csv"));
      const double full = 4 * 2.25 * 5.670374419e-8 * std::pow(900.0, 4);
      EXPECT_NEAR(regions.number({"gas"}, "fluence_mean") / full, 1, 1e-5) << wall << glass;
      const CsvTable heat(text_of(folder.path() / "results" / "heat.csv"));
      EXPECT_NEAR(heat.number({"region", "gas"}, "temperature"), 900, 1e-2) << wall << glass;
      EXPECT_NEAR(heat.number({"region", "gas"}, "net") / full, 0, 1e-6) << wall << glass;
    }
}

TEST(TemperaturesRun, RefusesUnlikeRefractiveIndices) {
  const CaseFolder folder(
      cube_with("[media.gas]\nabsorption = 2\ntemperature = 900\n[walls.\"*\"]\n"
                "refractive_index = 1.5\n"));
  const Outcome outcome = etendue_says({"run", folder.file()});
  EXPECT_EQ(outcome.code, ExitCode::input_error) << outcome.out;
  EXPECT_TRUE(has(outcome.err, "give them the same")) << outcome.err;
}

TEST(TemperaturesRun, OfWallsAreSeenBySensors) {
  const CaseFolder folder(
      cube_with(kOven + "[[sensor]]\nname = \"roof\"\nkind = \"flux\"\nwall = \"zmax\"\nparts = [2]\n"));
  const Outcome outcome = etendue_says({"run", folder.file(), "--set", "directions.order=8"});
  ASSERT_EQ(outcome.code, ExitCode::done) << outcome.err << outcome.out;
  const CsvTable sensors(text_of(folder.path() / "results" / "sensors.csv"));
  const CsvTable walls(text_of(folder.path() / "results" / "walls.csv"));
  for (const char* band : {"short", "long"}) {
    double sent = 0;
    for (std::size_t row = 0; row < sensors.rows().size(); ++row)
      if (sensors.column("quantity")[row] == "flux_backward" && sensors.column("band")[row] == band)
        sent = sensors.numbers("value")[row];
    EXPECT_NEAR(sent / walls.number({"zmax", band}, "outgoing"), 1, 0.02) << band;
  }
}

TEST(TemperaturesRun, GoOnFromASolution) {
  const CaseFolder folder(cube_with(kOven));
  const auto run = [&](const std::vector<std::string>& more) {
    std::vector<std::string> words = {"run", folder.file(), "--set", "solve.tolerance=1e-8"};
    words.insert(words.end(), more.begin(), more.end());
    return etendue_says(words);
  };
  ASSERT_EQ(run({}).code, ExitCode::done);
  const auto results = folder.path() / "results";
  const double whole = CsvTable(text_of(results / "heat.csv")).number({"wall", "zmax"}, "temperature");
  // A run that is cut off, and one that continues from it.
  ASSERT_EQ(run({"--set", "solve.max_sweeps=8"}).code, ExitCode::not_converged);
  const std::string start = "solve.initial=\"" + (results / "solution.vtu").string() + "\"";
  const Outcome outcome =
      run({"--set", start, "--set", "output.directory=\"" + (folder.path() / "again").string() + "\""});
  ASSERT_EQ(outcome.code, ExitCode::done) << outcome.err << outcome.out;
  const CsvTable again(text_of(folder.path() / "again" / "heat.csv"));
  EXPECT_NEAR(again.number({"wall", "zmax"}, "temperature") / whole, 1, 1e-6);
  // From the end nothing is left to do.
  const std::string end = "solve.initial=\"" + (folder.path() / "again" / "solution.vtu").string() + "\"";
  const Outcome last =
      run({"--set", end, "--set", "output.directory=\"" + (folder.path() / "last").string() + "\""});
  ASSERT_EQ(last.code, ExitCode::done) << last.err << last.out;
  EXPECT_TRUE(has(last.out, "  1 steps to the temperatures")) << last.out;
}

TEST(TemperaturesRun, AreSeenInPicturesOfSavedResults) {
  const std::string camera =
      "[[camera]]\nname = \"view\"\nposition = [0.1, 0.1, 0.1]\nlook_at = [1, 1, 1]\npixels = [8, 6]\n";
  const CaseFolder folder(cube_with(kOven + camera));
  ASSERT_EQ(etendue_says({"run", folder.file()}).code, ExitCode::done);
  const std::string taken = text_of(folder.path() / "results" / "view.png");
  std::filesystem::remove(folder.path() / "results" / "view.png");
  const Outcome outcome = etendue_says({"render", (folder.path() / "results").string()});
  ASSERT_EQ(outcome.code, ExitCode::done) << outcome.err << outcome.out;
  EXPECT_EQ(text_of(folder.path() / "results" / "view.png"), taken);
}

// The patch has half of the emissivity of the wall about it, and another temperature.
TEST(TemperaturesRun, OfWallsEndAtTheirBorders) {
  const CaseFolder folder(
      cube_with("[[mesh.patch]]\nwall = \"door\"\nmin = [1, 0.3, 0.3]\nmax = [1, 0.7, "
                "0.7]\n[media.gas]\nabsorption = 0\n"
                "[walls.\"*\"]\nemissivity = 1\ntemperature = 300\n[walls.door]\nemissivity = 0.5\n"
                "convection = { h = 1e4, ambient = 1000 }\n"
                "[[sensor]]\nname = \"door\"\nkind = \"flux\"\nwall = \"door\"\nparts = [3]\n"));
  const Outcome outcome = etendue_says({"run", folder.file(), "--set", "directions.order=8"});
  ASSERT_EQ(outcome.code, ExitCode::done) << outcome.err << outcome.out;
  const CsvTable sensors(text_of(folder.path() / "results" / "sensors.csv"));
  const CsvTable walls(text_of(folder.path() / "results" / "walls.csv"));
  double sent = 0;
  for (std::size_t row = 0; row < sensors.rows().size(); ++row)
    if (sensors.column("quantity")[row] == "flux_backward") sent = sensors.numbers("value")[row];
  EXPECT_NEAR(sent / walls.number({"door"}, "outgoing"), 1, 0.02);
}

TEST(TemperaturesRun, OfWallsLetNoLightIn) {
  const std::string box =
      "[media.gas]\nabsorption = 0\n[walls.\"*\"]\ntemperature = 300\n[walls.zmax]\n"
      "convection = { h = 10, ambient = 300 }\n[[light]]\nname = \"light\"\n";
  for (const char* light : {"kind = \"sun\"\ndirection = [0, 0, -1]\nirradiance = 1000\n",
                            "kind = \"sun\"\nwalls = [\"zmax\"]\ndirection = [0, 0, -1]\nirradiance = 1000\n",
                            "kind = \"wall\"\nwalls = [\"zmax\"]\nradiance = 1000\n"})
    EXPECT_EQ(etendue_says({"check", CaseFolder(cube_with(box + light)).file()}).code, ExitCode::input_error)
        << light;
}

TEST(TemperaturesRun, NeedNoWallThatFollowsOfAnEntryThatSaysSo) {
  const CaseFolder folder(
      cube_with("[media.gas]\nabsorption = 1\n[walls.\"*\"]\nconvection = { h = 10, ambient = 300 }\n"
                "[walls.xmin]\ntemperature = 400\n[walls.xmax]\ntemperature = 400\n[walls.ymin]\n"
                "temperature = 400\n[walls.ymax]\ntemperature = 400\n[walls.zmin]\ntemperature = 400\n"
                "[walls.zmax]\ntemperature = 500\n"));
  const Outcome outcome = etendue_says({"run", folder.file()});
  EXPECT_EQ(outcome.code, ExitCode::done) << outcome.err << outcome.out;
}

TEST(TemperaturesRun, NeedSomethingThatTakesTheHeatAway) {
  const CaseFolder folder(
      cube_with("[bands]\nnames = [\"a\", \"b\"]\nedges = [1, 3000, 1e9]\n[media.gas]\nabsorption = 0\n"
                "temperature = 300\n[walls.\"*\"]\nheat_flux = 100\n"));
  const Outcome outcome = etendue_says({"run", folder.file()});
  EXPECT_EQ(outcome.code, ExitCode::input_error) << outcome.out;
  EXPECT_TRUE(has(outcome.err, "nothing takes its heat away")) << outcome.err;
}

// The sheet seals the upper half, whose walls give heat and take none.
TEST(TemperaturesRun, NeedAWayOutOfEachVolume) {
  const std::string halves =
      "[[mesh.sheet]]\nfront = \"up\"\nback = \"down\"\nmin = [0, 0, 0.5]\nmax = [1, 1, 0.5]\n"
      "[bands]\nnames = [\"a\", \"b\"]\nedges = [1, 3000, 1e9]\n[media.gas]\nabsorption = 0\n"
      "[walls.\"*\"]\nspecular = 1\n[walls.zmin]\ntemperature = 1000\n[walls.down]\nemissivity = 0.5\n"
      "[walls.up]\nemissivity = 0.6\nheat_flux = 300\n[walls.zmax]\nemissivity = 0.6\n";
  const Outcome sealed = etendue_says({"run", CaseFolder(cube_with(halves + "heat_flux = 0\n")).file()});
  EXPECT_EQ(sealed.code, ExitCode::input_error) << sealed.out;
  EXPECT_TRUE(has(sealed.err, "no way out of the volume")) << sealed.err;
  const CaseFolder folder(cube_with(halves + "convection = { h = 10, ambient = 300 }\n"));
  const Outcome cooled = etendue_says({"run", folder.file(), "--set", "solve.tolerance=1e-8"});
  ASSERT_EQ(cooled.code, ExitCode::done) << cooled.err;
  const CsvTable heat(text_of(folder.path() / "results" / "heat.csv"));
  EXPECT_NEAR(heat.number({"wall", "zmax"}, "temperature"), 330, 1e-3);
}

// Light that fades away has no relative error; the temperatures are known all the same.
TEST(TemperaturesRun, OfAColdRoomAreZero) {
  const CaseFolder folder(
      cube_with("[media.gas]\nabsorption = 0\n[walls.\"*\"]\nemissivity = 0.8\n"
                "convection = { h = 10, ambient = 0 }\n"));
  const Outcome outcome = etendue_says({"run", folder.file()});
  ASSERT_EQ(outcome.code, ExitCode::not_converged) << outcome.err << outcome.out;
  const CsvTable heat(text_of(folder.path() / "results" / "heat.csv"));
  EXPECT_NEAR(heat.number({"wall", "zmax"}, "temperature"), 0, 1e-3);
}

TEST(TemperaturesRun, OfAWallThatDoesNotAbsorbIsThatOfTheConductorBesideIt) {
  const CaseFolder folder(
      cube_with("[media.gas]\nabsorption = 0\nconductivity = 5\n[walls.\"*\"]\nspecular = 1\n"
                "[walls.zmin]\nemissivity = 0.0\ntemperature = 700\n[walls.zmax]\nemissivity = 0.0\n"
                "convection = { h = 20, ambient = 300 }\n"));
  const Outcome outcome = etendue_says({"run", folder.file(), "--set", "solve.tolerance=1e-9"});
  ASSERT_EQ(outcome.code, ExitCode::done) << outcome.err << outcome.out;
  const CsvTable heat(text_of(folder.path() / "results" / "heat.csv"));
  EXPECT_NEAR(heat.number({"wall", "zmax"}, "temperature"), 380, 1e-4);  // 20 (T - 300) = 5 (700 - T)
}

TEST(TemperaturesRun, OfASavedStateAreReadOutByOneSweep) {
  const CaseFolder folder(cube_with(kOven));
  ASSERT_EQ(etendue_says({"run", folder.file()}).code, ExitCode::done);
  const auto results = folder.path() / "results";
  const double found = CsvTable(text_of(results / "heat.csv")).number({"wall", "zmax"}, "temperature");
  const std::string start = "solve.initial=\"" + (results / "solution.vtu").string() + "\"";
  etendue_says({"run", folder.file(), "--set", start, "--set", "solve.max_sweeps=1", "--set",
                "output.directory=\"" + (folder.path() / "again").string() + "\""});
  const CsvTable again(text_of(folder.path() / "again" / "heat.csv"));
  // The unknown of a wall is a polynomial of its temperature, which is what is saved.
  EXPECT_NEAR(again.number({"wall", "zmax"}, "temperature"), found, 1e-12 * found);
}

const std::string kProbe = "[[probe]]\nname = \"p\"\npoints = [[0.5, 0.25, 0.3], [0.2, 0.6, 0.75]]\n";

std::vector<double> probed(const std::string& text, const std::vector<std::string>& options = {}) {
  const CaseFolder folder(cube_with(text + kProbe));
  std::vector<std::string> line = {"run", folder.file()};
  line.insert(line.end(), options.begin(), options.end());
  const Outcome outcome = etendue_says(line);
  EXPECT_EQ(outcome.code, ExitCode::done) << outcome.err;
  const CsvTable probes(text_of(folder.path() / "results" / "probes.csv"));
  return {probes.number({"p", "0"}, "temperature"), probes.number({"p", "1"}, "temperature")};
}

TEST(TemperaturesRun, AreAtProbesThoseThatAreGiven) {
  const std::string given =
      "[media.gas]\nabsorption = 1\ntemperature = \"300 + 1000*z^2 + 100*y\"\n[walls.\"*\"]\ntemperature = "
      "300\n";
  const std::vector<double> kelvin = probed(given);
  EXPECT_NEAR(kelvin[0], 415, 1e-9);
  EXPECT_NEAR(kelvin[1], 922.5, 1e-9);
  const std::vector<double> by_photons =
      probed(given, {"--set", "solve.method=\"photons\"", "--set", "solve.photons=1000"});
  EXPECT_EQ(by_photons, kelvin);
}

// Heat is conducted alone: 300 + 400 z.
TEST(TemperaturesRun, AreAtProbesThoseOfConductors) {
  const std::vector<double> kelvin = probed(
      "[media.gas]\nabsorption = 0\nconductivity = 2\n[walls.\"*\"]\nspecular = 1\n"
      "[walls.zmin]\ntemperature = 300\n[walls.zmax]\ntemperature = 700\n",
      {"--set", "solve.tolerance=1e-9"});
  EXPECT_NEAR(kelvin[0], 420, 1e-4);
  EXPECT_NEAR(kelvin[1], 600, 1e-4);
}

// A gray gas in radiative equilibrium is as warm as the room around it.
TEST(TemperaturesRun, AreAtProbesThoseOfGasInEquilibrium) {
  const std::vector<double> kelvin =
      probed("[media.gas]\nabsorption = 1\nheat_source = 0\n[walls.\"*\"]\ntemperature = 500\n",
             {"--set", "solve.tolerance=1e-9"});
  EXPECT_NEAR(kelvin[0], 500, 1e-3);
  EXPECT_NEAR(kelvin[1], 500, 1e-3);
}

TEST(TemperaturesRun, HaveNoColumnInACaseWithoutThem) {
  const CaseFolder folder(
      cube_with("[media.gas]\nabsorption = 1\nemission = 1\n[walls.\"*\"]\ndiffuse = 0.5\n" + kProbe));
  ASSERT_EQ(etendue_says({"run", folder.file()}).code, ExitCode::done);
  EXPECT_FALSE(has(text_of(folder.path() / "results" / "probes.csv"), "temperature"));
}

TEST(TemperaturesRun, AreSeenBySensorsOfRegions) {
  const CaseFolder folder(
      cube_with("[media.gas]\nabsorption = 1\nconductivity = 1\nheat_source = 1e4\n"
                "[walls.\"*\"]\ntemperature = 500\n[[sensor]]\nname = \"account\"\nkind = \"region\"\nregion "
                "= \"gas\"\n"));
  const Outcome outcome = etendue_says({"run", folder.file()});
  ASSERT_EQ(outcome.code, ExitCode::done) << outcome.err << outcome.out;
  const CsvTable sensors(text_of(folder.path() / "results" / "sensors.csv"));
  const CsvTable regions(text_of(folder.path() / "results" / "regions.csv"));
  double emitted = 0;
  for (std::size_t row = 0; row < sensors.rows().size(); ++row)
    if (sensors.column("quantity")[row] == "emitted") emitted = sensors.numbers("value")[row];
  EXPECT_NEAR(emitted / regions.number({"gas"}, "emitted"), 1, 1e-6);
}

TEST(TemperaturesRun, WarnsOfLayersThatTheCellsMiss) {
  const std::string gas =
      "[media.gas]\nabsorption = 1\nheat_source = 1e4\n[walls.\"*\"]\ntemperature = 500\n";
  const CaseFolder folder(cube_with(gas));
  const auto says = [&](const char* conductivity) {
    return has(
        etendue_says({"run", folder.file(), "--set", std::string("media.gas.conductivity=") + conductivity})
            .out,
        "the layer in which conduction gives way");
  };
  EXPECT_TRUE(says("0.01"));
  EXPECT_FALSE(says("100"));
}

TEST(TemperaturesRun, WarnsBeyondTheRangeOfGrayGases) {
  const CaseFolder folder(cube_with(
      "[bands]\nwsgg = \"bordbar\"\nmolar_ratio = 1\n[media.gas]\ngas_pressure = 0.5\nheat_source = 5e6\n"
      "[walls.\"*\"]\ntemperature = 500\n"));
  const Outcome outcome = etendue_says({"run", folder.file()});
  EXPECT_EQ(outcome.code, ExitCode::done) << outcome.err << outcome.out;
  EXPECT_TRUE(has(outcome.out, "known up to 2400 K")) << outcome.out;
}

}  // namespace
}  // namespace etendue::temperatures_run_test
